// SPDX-License-Identifier: MIT
//
// A program on the module delref.core alone, compiled where there is no CGAL: a triangulation and a level of its own.
#if __has_include(<CGAL/version.h>) || __has_include(<boost/version.hpp>) || __has_include(<gmp.h>)
#error "CGAL, Boost or GMP is on the include path: this test would show nothing"
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <span>
#include <tuple>
#include <vector>

import delref.core;

#include "../core_only/subdivision.hpp"

int main() {
  consumer::Subdivision interval(0, 1);
  delref::Mesher mesher(interval, std::tuple(consumer::LengthLevel(0.1)));
  const auto outcome = mesher.refine();
  std::printf("%zu vertices, %zu unmet\n", interval.number_of_vertices(), outcome.unmet.size());
  return outcome.complete() && outcome.unmet.empty() && interval.number_of_vertices() == 17 ? 0 : 1;
}
