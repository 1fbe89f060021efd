// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of `--size-points`.
#pragma once

#include <functional>
#include <string>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>

namespace delref::program {

/// The sizing field of the points in a file: lines `x y size`, empty lines, and comments from `#` to the end of a line.
/// Throws `InvalidInput` that names the file and the line, and `Interrupted`.
std::function<double(Point2)> read_size_points(const std::string& path, double gradation, const Control& control);

}  // namespace delref::program
