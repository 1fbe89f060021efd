// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piecewise linear complex on its way to a domain: vertices merged, segments cut, every facet in its plane and triangulated.
// The checks that follow (what crosses, what is open, which angles are small) work on this form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/facet_frame.hpp>
#include <delref/domain/facet_triangulation.hpp>
#include <delref/domain/plc.hpp>
#include <delref/domain/plc_cuts.hpp>
#include <delref/domain/plc_duplicates.hpp>
#include <delref/domain/plc_names.hpp>
#include <delref/domain/plc_options.hpp>
#include <delref/domain/plc_outlines.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/domain/segment_table.hpp>

namespace delref {

struct TriangulatedPlc {
  using Index = Plc::Index;
  using Triangle = std::array<Index, 3>;
  using Ends = SegmentTable::Ends;

  std::span<const Point3> points;
  FacetOutlines outlines;
  /// Per facet of `outlines`.
  std::vector<PlaneFrame> frames;
  /// The triangles of facet f are those from `first_triangle[f]` up to the next facet's first.
  std::vector<Triangle> triangles;
  std::vector<std::size_t> first_triangle;
  /// Segments that the input lists, or that a facet has inside, and their markers; one may be there twice.
  std::vector<Ends> listed;
  std::vector<int> listed_markers;
  /// All sides and listed segments, each once.
  SegmentTable segments;

  std::size_t size() const { return outlines.size(); }
  std::span<const Triangle> triangles_of(std::size_t f) const {
    return std::span(triangles).subspan(first_triangle[f], first_triangle[f + 1] - first_triangle[f]);
  }
  /// Makes `segments` anew from what there is.
  void find_segments() { segments = SegmentTable(points.size(), {outlines.all_sides, listed}); }
  /// Takes the facets out that are not marked. Requires `triangles` to be made later, or not to have been made for them.
  void keep(const std::vector<bool>& kept) {
    outlines = plc_duplicates::kept_only(outlines, kept);
    std::size_t count = 0;
    for (std::size_t f = 0; f < kept.size(); ++f)
      if (kept[f]) frames[count++] = frames[f];
    frames.resize(count);
  }
};

namespace triangulated_plc {

using Index = Plc::Index;

/// Puts every facet into a plane. Facets on one line are left out and told; those too far from a plane are defects.
inline void find_frames(TriangulatedPlc& plc, const PlcOptions& options, const PlcNames& names, const Control& control,
                        DefectList& defects, std::vector<std::string>& notes) {
  std::vector<bool> kept(plc.size(), true);
  ExampleList flat;
  plc.frames.resize(plc.size());
  for (std::size_t f = 0; f < plc.size(); ++f) {
    if (f % 1024 == 0) throw_if_stopped(control);
    const bool is_triangle = plc.outlines.is_triangle(f);
    const std::vector<Index> vertices = is_triangle ? std::vector<Index>{} : plc.outlines.vertices(f);
    const auto frame = facet_frame(plc.points, plc.outlines, f, vertices);
    const Index original = plc.outlines.facets[f].original;
    if (!frame) {
      kept[f] = false;
      for (const auto& slit : plc.outlines.slits(f)) plc.listed.push_back(slit), plc.listed_markers.push_back(0);
      if (!plc.outlines.curves(f).empty()) flat.add(names.facet(original, plc.outlines.vertices(f)));
      continue;
    }
    plc.frames[f] = *frame;
    if (is_triangle) continue;
    const Index v = farthest_off(*frame, plc.points, vertices);
    const double off = std::abs(frame->height(plc.points[v]));
    const double diameter = bounding_box_3(vertices | std::views::transform([&](Index i) { return plc.points[i]; })).diagonal();
    if (off > options.planarity_tolerance * diameter)
      defects.add(names.facet(original, vertices) + " is not planar: " + names.placed_vertex(v) + " is " + names.length(off) +
                  " off its plane, more than " + describe(options.planarity_tolerance) + " of its diameter " +
                  names.length(diameter) + "; cut it into triangles or planar facets");
  }
  if (flat.count() == 0 && std::ranges::all_of(kept, std::identity{})) return;
  plc.keep(kept);
  if (flat.count() > 0)
    notes.push_back(count_of(flat.count(), "facet without area, whose vertices are on one line, was",
                             "facets without area, whose vertices are on one line, were") +
                    " left out: " + flat.text());
}

/// Cuts segments where vertices lie on them.
inline void cut_segments(TriangulatedPlc& plc, const PlcNames& names, const Control& control, std::vector<std::string>& notes) {
  plc.find_segments();
  const std::vector<SegmentCut> cuts = find_cuts(plc.points, plc.segments, control);
  if (cuts.empty()) return;
  tell_cuts(plc.segments, cuts, names, notes);
  const SegmentChains chains(plc.segments, cuts);
  plc.outlines = cut_outlines(plc.outlines, chains);
  std::vector<TriangulatedPlc::Ends> pieces;
  std::vector<int> markers;
  for (std::size_t s = 0; s < plc.listed.size(); ++s) {
    chains.append(plc.listed[s], pieces);
    markers.resize(pieces.size(), plc.listed_markers[s]);
  }
  plc.listed = std::move(pieces);
  plc.listed_markers = std::move(markers);
  plc.find_segments();
}

/// What hole points that remove nothing are told as.
inline void tell_useless_holes(const Plc& input, Index original, const FacetTriangulator& triangulator, const PlcNames& names,
                               std::vector<std::string>& notes) {
  for (const std::size_t h : triangulator.useless_holes)
    notes.push_back("the hole point " + names.place(input.facets[original].holes[h]) + " of " + names.facet(original) +
                    " is not in it and removes nothing");
}

/// Triangulates every facet. One that is only segments becomes these; one that encloses nothing is a defect.
inline void triangulate_facets(TriangulatedPlc& plc, const Plc& input, const PlcNames& names, const Control& control,
                               DefectList& defects, std::vector<std::string>& notes) {
  FacetTriangulator triangulator(names);
  std::vector<bool> kept(plc.size(), true);
  plc.triangles.clear();
  plc.triangles.reserve(plc.size());
  plc.first_triangle.assign(1, 0);
  for (std::size_t f = 0; f < plc.size(); ++f) {
    if (f % 256 == 0) throw_if_stopped(control);
    const auto curves = plc.outlines.curves(f);
    const Index original = plc.outlines.facets[f].original;
    const auto& holes = input.facets[original].holes;
    if (plc.outlines.is_triangle(f) && holes.empty()) {
      plc.triangles.push_back({curves[0][0], curves[1][0], curves[2][0]});
    } else {
      const std::string wrong =
          triangulator.triangulate(plc.frames[f], plc.outlines.sides(f), plc.outlines.loose(f), holes, plc.triangles);
      if (!wrong.empty()) defects.add(names.facet(original) + ": " + wrong);
      tell_useless_holes(input, original, triangulator, names, notes);
      if (wrong.empty() && plc.triangles.size() == plc.first_triangle.back()) {
        kept[f] = false;
        if (!curves.empty())
          defects.add(names.facet(original, plc.outlines.vertices(f)) +
                      " encloses nothing: " + (holes.empty() ? "its polygons do not close" : "its hole points remove all of it"));
        for (const auto& slit : plc.outlines.slits(f)) plc.listed.push_back(slit), plc.listed_markers.push_back(0);
        continue;
      }
    }
    plc.first_triangle.push_back(plc.triangles.size());
  }
  if (!std::ranges::all_of(kept, std::identity{})) plc.keep(kept);
}

/// Segments in facets are listed ones, so that joining facets does not lose them.
inline void list_slits(TriangulatedPlc& plc) {
  for (std::size_t f = 0; f < plc.size(); ++f)
    for (const auto& slit : plc.outlines.slits(f)) plc.listed.push_back(slit), plc.listed_markers.push_back(0);
}

}  // namespace triangulated_plc

/// Triangulates the facets of a complex whose vertices were merged (`renumbered`, `names`). Defects are added to the list; if
/// there are any the result is not to be used. Requires what `find_plain_defects` checks.
inline TriangulatedPlc triangulated(const Plc& input, const std::vector<Plc::Index>& renumbered, const PlcOptions& options,
                                    const PlcNames& names, const Control& control, DefectList& defects,
                                    std::vector<std::string>& notes) {
  using namespace triangulated_plc;
  TriangulatedPlc plc;
  plc.points = names.points;
  plc.outlines = outlines_of(input, renumbered, names, control, notes);
  drop_duplicate_facets(input, plc.outlines, names, control, defects, notes);
  for (std::size_t s = 0; s < input.segments.size(); ++s) {
    const Index a = renumbered[input.segments[s][0]], b = renumbered[input.segments[s][1]];
    if (a == b) continue;
    plc.listed.push_back({a, b});
    plc.listed_markers.push_back(input.segment_marker(s));
  }
  find_frames(plc, options, names, control, defects, notes);
  if (!defects.empty()) return plc;
  cut_segments(plc, names, control, notes);
  list_slits(plc);
  triangulate_facets(plc, input, names, control, defects, notes);
  plc.find_segments();
  return plc;
}

}  // namespace delref
