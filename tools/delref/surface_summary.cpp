// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "words.hpp"

namespace delref::program {
namespace {

std::string topology_text(const ReportedBoundary& b) {
  std::string text = fmt::format("{}, Euler characteristic {}", counted(b.components, "component", "components"), b.euler_characteristic);
  if (b.pinched_vertices > 0) text += fmt::format(", pinched at {}", counted(b.pinched_vertices, "vertex", "vertices"));
  if (b.crowded_edges > 0) text += fmt::format(", {} not of two triangles", counted(b.crowded_edges, "edge", "edges"));
  return text;
}

/// "2 found from ..., exactly; all in the mesh (1 was seeded again)".
std::string components_text(const ReportedSurface& s) {
  std::string text = fmt::format("{} found {}; ", grouped(s.components_found), s.found_by);
  text += s.components_missed > 0 ? fmt::format("{} NOT in the mesh", grouped(s.components_missed)) : "all in the mesh";
  const std::size_t again = s.components_seeded_again;
  return again > 0 ? fmt::format("{} ({} seeded again)", text, again == 1 ? "1 was" : grouped(again) + " were") : text;
}

std::string size_text(double size, bool is_asked_for) {
  return std::isfinite(size) ? fmt::format("{:.6g} at most{}", size, is_asked_for ? "" : " (chosen)") : "any";
}

std::string side(const std::optional<int>& label) { return label ? fmt::format("region {}", *label) : "the outside"; }

}  // namespace

std::string missing_parts(const ReportedSurface& s) {
  std::string text;
  if (s.components_missed > 0) text = counted(s.components_missed, "component", "components");
  if (s.loose_vertices > 0)
    text += fmt::format("{}parts at {}", text.empty() ? "" : " and ", counted(s.loose_vertices, "place", "places"));
  return text;
}

std::string doubt_about_components(const ReportedSurface& s) {
  if (s.boundaries.size() != 1 || s.boundaries.front().components == s.components_found) return {};
  return fmt::format("the surface of the mesh has {} where {} found: its facets are too large for it, or what was found is too coarse. Try a "
                     "smaller --facet-size.",
                     counted(s.boundaries.front().components, "component", "components"),
                     s.components_found == 1 ? "1 was" : grouped(s.components_found) + " were");
}

void add_surface(Rows& rows, const PolyhedralRunReport& report) {
  const ReportedSurface& s = *report.surface;
  const ReportedSmoothOptions& o = *report.options.smooth;
  constexpr std::size_t most_rows = 12;
  rows.add("surface", fmt::format("{} triangles, {} vertices", grouped(report.mesh.triangles), grouped(s.vertices)));
  const char* name = "  topology";
  for (std::size_t i = 0; i < std::min(s.boundaries.size(), most_rows); ++i) {
    const ReportedBoundary& b = s.boundaries[i];
    const std::string whose = s.boundaries.size() > 1 ? fmt::format("region {}: ", b.label) : "";
    rows.add(std::exchange(name, ""), whose + topology_text(b));
  }
  if (s.boundaries.size() > most_rows) rows.add("", fmt::format("and {}", counted(s.boundaries.size() - most_rows, "region more", "regions more")));
  name = "  patches";
  if (s.patches.size() > 1)
    for (std::size_t i = 0; i < std::min(s.patches.size(), most_rows); ++i) {
      const ReportedPatch& p = s.patches[i];
      rows.add(std::exchange(name, ""), fmt::format("{}: {} triangles between {} and {}", p.marker, grouped(p.triangles), side(p.regions[0]),
                                                    side(p.regions[1])));
    }
  if (s.patches.size() > most_rows) rows.add("", fmt::format("and {}", counted(s.patches.size() - most_rows, "patch more", "patches more")));
  rows.add("  components", components_text(s));
  rows.add("  angles", fmt::format("{:.4g} degrees at least{}", s.smallest_angle_degrees,
                                   o.facet_angle_degrees > 0 ? fmt::format(" ({:g} asked for)", o.facet_angle_degrees) : ""));
  rows.add("  facet size", size_text(s.sizes.facet_size, o.facet_size.has_value()));
  if (std::isfinite(s.sizes.facet_distance)) rows.add("  distance", size_text(s.sizes.facet_distance, o.facet_distance.has_value()));
  if (s.loose_vertices > 0)
    rows.add("  loose", fmt::format("{} on the surface that no triangle has: part of it is missing there", counted(s.loose_vertices, "vertex", "vertices")));
  if (s.stopped_by_floor > 0)
    rows.add("  size floor", fmt::format("{} left, with surface balls of radius {:.3g} or less",
                                         counted(s.stopped_by_floor, "facet", "facets"), s.sizes.smallest_facet));
}

}  // namespace delref::program
