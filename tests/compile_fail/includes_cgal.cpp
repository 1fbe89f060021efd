// expect: CGAL/version.h
// SPDX-License-Identifier: MIT
#include <vector>

#include <CGAL/version.h>
