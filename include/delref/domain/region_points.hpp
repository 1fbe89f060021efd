// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in each region of an oracle, by labels on a regular grid: what the mesh of a domain of several regions is held against, for a
// region that is thin against the facets around it can be passed over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/oracle.hpp>

namespace delref {

/// Up to `most` samples in each region, by region number, spread over all that are in it. Samples are so far apart, in the middle of the cells
/// of a grid; a region between them is missed. Throws `Interrupted`.
template <Oracle O>
std::vector<std::vector<Point3>> region_points(const O& oracle, double distance, std::size_t most, const Control& control) {
  const auto [low, high] = oracle.bounds();
  const auto steps = [&](double length) { return static_cast<std::size_t>(std::max(1.0, std::ceil(length / distance))); };
  const std::size_t nx = steps(high.x - low.x), ny = steps(high.y - low.y), nz = steps(high.z - low.z);
  const auto at = [](double from, double to, std::size_t i, std::size_t n) { return from + (to - from) * ((static_cast<double>(i) + 0.5) / static_cast<double>(n)); };
  std::vector<std::vector<Point3>> found;
  std::vector<std::size_t> seen;
  std::vector<Point3> row(nx);
  std::vector<int> labels(nx);
  for (std::size_t k = 0; k < nz; ++k)
    for (std::size_t j = 0; j < ny; ++j) {
      throw_if_stopped(control);
      for (std::size_t i = 0; i < nx; ++i) row[i] = {at(low.x, high.x, i, nx), at(low.y, high.y, j, ny), at(low.z, high.z, k, nz)};
      oracle.label(std::span<const Point3>(row), std::span<int>(labels));
      for (std::size_t i = 0; i < nx; ++i) {
        if (labels[i] < 0) continue;
        const auto r = static_cast<std::size_t>(labels[i]);
        if (r >= found.size()) found.resize(r + 1), seen.resize(r + 1, 0);
        // Every sample, then every second one, every fourth ...: so many at any time, evenly from the first to the last.
        std::size_t stride = 1;
        while (seen[r] / stride >= most) stride *= 2;
        if (seen[r]++ % stride != 0) continue;
        if (found[r].size() < most) found[r].push_back(row[i]);
        else {
          for (std::size_t n = 0; 2 * n < most; ++n) found[r][n] = found[r][2 * n];
          found[r].resize((most + 1) / 2);
          found[r].push_back(row[i]);
        }
      }
    }
  return found;
}

}  // namespace delref
