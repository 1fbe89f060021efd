// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of `--size-points`.
#pragma once

#include <functional>
#include <string>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>

namespace delref::program {

/// The sizing field of the points in a file: lines `x y size` in the plane and `x y z size` in space, empty lines, and comments from
/// `#` to the end of a line. For `Point2` and `Point3`. Throws `InvalidInput` that names the file and the line, and `Interrupted`.
template <class Point>
std::function<double(Point)> read_size_points(const std::string& path, double gradation, const Control& control);

}  // namespace delref::program
