// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quality of a tetrahedral mesh as text for a person: a table of the figures, and how ratios, angles and lengths are spread,
// as bars.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include <delref/mesh/quality_table.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>

namespace delref {

/// The whole table, ending in a line feed. Of more than 20 regions the first 20 are spelled out.
inline std::string quality_table(const TetrahedralQuality& q) {
  std::string text = fmt::format("vertices         {}\ntetrahedra       {}\n", q.vertex_count, q.tetrahedron_count);
  text += fmt::format("on input facets  {} triangles, and {} edges on input segments\n", q.triangle_count, q.edge_count);
  if (q.tetrahedron_count == 0) return text + "The mesh has no tetrahedra: there is nothing to measure.\n";
  text += fmt::format("volumes          {:.6g} to {:.6g}, {:.10g} in all\n", q.smallest_volume, q.largest_volume, q.total_volume);
  if (q.flat_or_inverted != 0) text += fmt::format("flat or inverted {} tetrahedra\n", q.flat_or_inverted);
  text += fmt::format("radius-edge      {:.4g} at worst (circumradius / shortest edge; 0.612 is regular)\n", q.worst_radius_edge);
  text += fmt::format("dihedral angles  {:.4g} to {:.4g} degrees\n", q.smallest_dihedral, q.largest_dihedral);
  text += fmt::format("slivers          {} tetrahedra have a dihedral angle under 5 degrees, {} under 10\n", q.under_5_degrees,
                      q.under_10_degrees);
  text += fmt::format("edge lengths     {:.6g} to {:.6g}\n", q.shortest_edge, q.longest_edge);
  if (q.triangle_count != 0)
    text += fmt::format("facet triangles  {:.4g} degrees is their smallest angle\n", q.smallest_triangle_angle);
  if (q.regions.size() > 1) {
    text += fmt::format("\nRegions, {} of them:\n", q.regions.size());
    std::size_t told = 0;
    for (const auto& [label, region] : q.regions) {
      if (told++ == 20) {
        text += fmt::format("  and {} more\n", q.regions.size() - 20);
        break;
      }
      text += fmt::format("  label {:<10} {:>10} tetrahedra  volume {:.10g}\n", label, region.tetrahedron_count, region.volume);
    }
  }
  const auto& ratios = TetrahedralQuality::radius_edge_bins;
  text += "\nRadius-edge ratio of each tetrahedron:\n";
  text += histogram_text(q.radius_edge, [&](std::size_t i) {
    return i + 1 < ratios.size() ? fmt::format("{:>4.1f} - {:<4.1f}", ratios[i], ratios[i + 1])
                                 : fmt::format("{:>4.1f} and up", ratios[i]);
  });
  text += "\nSmallest dihedral angle of each tetrahedron, in degrees (70.5 is regular):\n";
  text += histogram_text(q.smallest_dihedrals, TetrahedralQuality::degrees_per_bin);
  text += "\nAll dihedral angles, in degrees:\n";
  text += histogram_text(q.all_dihedrals, TetrahedralQuality::degrees_per_bin);
  text += "\nEdge lengths, each edge as often as it has tetrahedra:\n";
  text += histogram_text(q.edge_lengths, [&](std::size_t i) {
    const auto bound = [&](std::size_t k) { return q.first_length * std::exp2(0.5 * static_cast<double>(k)); };
    return fmt::format("{:>9.3g} - {:<9.3g}", bound(i), bound(i + 1));
  });
  return text;
}

}  // namespace delref
