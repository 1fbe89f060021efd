// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quality of a mesh as text for a person: a table of the figures, and how the angles are spread, as bars.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>

#include <fmt/format.h>

#include <delref/mesh/quality.hpp>

namespace delref {

/// Counts per bin as lines "name  count  share  bar", between the first and the last bin that is not empty; `name(i)` gives the
/// bin's range in words. The longest bar has 40 characters; a count that is not 0 has at least a dot.
template <std::invocable<std::size_t> Name>
std::string histogram_text(std::span<const std::size_t> bins, Name&& name) {
  const auto filled = [](std::size_t n) { return n != 0; };
  const auto first = std::ranges::find_if(bins, filled);
  if (first == bins.end()) return "  (nothing to count)\n";
  std::size_t total = 0;
  for (const std::size_t n : bins) total += n;
  const auto largest = static_cast<double>(std::ranges::max(bins));
  auto last = bins.size();
  while (bins[last - 1] == 0) --last;
  std::string text;
  for (auto i = static_cast<std::size_t>(first - bins.begin()); i < last; ++i) {
    const auto n = static_cast<double>(bins[i]);
    const auto length = static_cast<std::size_t>(std::lround(40 * n / largest));
    const std::string bar = bins[i] == 0 ? "" : length == 0 ? "." : std::string(length, '#');
    text += fmt::format("  {} {:>10} {:>6.1f} %  {}\n", name(i), bins[i], 100 * n / static_cast<double>(total), bar);
  }
  return text;
}

/// The same for bins of so many degrees, the first from 0.
inline std::string histogram_text(std::span<const std::size_t> bins, double degrees_per_bin) {
  return histogram_text(bins, [&](std::size_t i) {
    return fmt::format("{:>3} - {:<3}", degrees_per_bin * static_cast<double>(i), degrees_per_bin * static_cast<double>(i + 1));
  });
}

/// The whole table, ending in a line feed.
inline std::string quality_table(const PlanarQuality& q) {
  std::string text = fmt::format("vertices         {}\ntriangles        {}\n", q.vertex_count, q.triangle_count);
  if (q.triangle_count == 0) return text + "The mesh has no triangles: there is nothing to measure.\n";
  text += fmt::format("angles           {:.4g} to {:.4g} degrees; the smallest of a triangle is {:.4g} on average\n", q.smallest_angle,
                      q.largest_angle, q.mean_smallest_angle);
  text += fmt::format("edge lengths     {:.6g} to {:.6g}\n", q.shortest_edge, q.longest_edge);
  text += fmt::format("triangle areas   {:.6g} to {:.6g}, {:.10g} in all\n", q.smallest_area, q.largest_area, q.total_area);
  text += fmt::format("radius-edge      {:.4g} at worst (circumradius / shortest edge; 0.577 is equilateral)\n", q.worst_radius_edge);
  text += "\nSmallest angle of each triangle, in degrees (60 is equilateral):\n";
  text += histogram_text(q.smallest_angles, PlanarQuality::degrees_per_bin);
  text += "\nAll angles, in degrees:\n";
  text += histogram_text(q.all_angles, PlanarQuality::degrees_per_bin);
  return text;
}

}  // namespace delref
