// SPDX-License-Identifier: MIT
//
// A program on the module delref.core alone, compiled where there is no CGAL.
#if __has_include(<CGAL/version.h>) || __has_include(<boost/version.hpp>) || __has_include(<gmp.h>)
#error "CGAL, Boost or GMP is on the include path: this test would show nothing"
#endif

import delref.core;

int main() {
  const delref::Point2 a{0, 0}, b{3, 4};
  return squared_length(b - a) == 25 ? 0 : 1;
}
