// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds vertices and segments to a domain that was refined already. The triangulation is made anew from the vertices of the old
// one, so that nothing is changed before all is known to be valid, and what was learnt of the old domain (regions, corners,
// clusters) is worked out again. A vertex that is there already is used, whoever inserted it. The steps are in extension_*.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/build_planar_domain.hpp>
#include <delref/domain/extension_pieces.hpp>
#include <delref/domain/extension_state.hpp>
#include <delref/domain/extension_steiner.hpp>
#include <delref/domain/extension_thinning.hpp>
#include <delref/domain/insert_planar_graph.hpp>
#include <delref/domain/label_planar_domain.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/pslg_scale.hpp>
#include <delref/domain/unite_pslg.hpp>

namespace delref {

/// Fills the empty triangulation `tr` with the vertices of `before`, a refined triangulation of `domain`, and with what `united`
/// adds to its graph. Use once: the constructor does the work. `before` and `domain` are not changed.
///
///  - An input vertex with the coordinates of a Steiner vertex takes its place; if that was on a segment, or if the vertex is within
///    2 ulp (of the segment's largest coordinate) of a subsegment, the segment is cut there: `united()` has the parts.
///  - A new segment runs over the free Steiner vertices within 2 ulp of it, which are then on it, and is cut at such input vertices.
///  - Steiner vertices that would force tiny triangles are left out: those nearer to a new vertex, and the free ones nearer to a new
///    segment, than a quarter of the distance to their nearest neighbour, and those on two segments that newly meet under 2 degrees.
///
/// Throws `InvalidInput` when segments cross other than in an input vertex of the united graph, or when its seeds leave no
/// domain; `Interrupted`. O(n log n), and the faces along each new segment.
template <class Tr>
class PlanarDomainExtension {
  using Vertex = typename Tr::Vertex;
  using Index = Pslg::Index;

 public:
  PlanarDomainExtension(const Tr& before, const PlanarDomain& domain, UnitedPslg united, Tr& tr, const Control& control)
      : x_{before, domain, std::move(united), tr, control} {
    x_.domain.scale = scale_exponent(x_.united.checked.pslg);
    x_.domain.pslg = scaled(x_.united.checked.pslg, x_.domain.scale);
    x_.cuts.resize(x_.old.pslg.segments.size());
    x_.chains.resize(x_.old.pslg.segments.size());
    detail::collect_steiner(x_);
    detail::find_new_vertices_on_segments(x_);
    detail::cut_old_segments(x_);
    insert_points();
    detail::cut_new_segments(x_);
    detail::drop_near_tiny_angles(x_);
    detail::drop_near_new_vertices(x_);
    detail::remove_dropped(x_);
    insert_segments();
    const auto input_vertices = std::span(x_.vertices).first(x_.domain.pslg.points.size());
    notes_ = PlanarDomainLabeller<Tr>(x_.tr, x_.domain, x_.united.checked, input_vertices, control).notes();
  }

  /// The domain, and its graph with the names of all that was given; the extension is then without it.
  PlanarDomain domain() && { return std::move(x_.domain); }
  CheckedPslg united() && { return std::move(x_.united.checked); }
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  void insert_points() {
    std::vector<Point2> points = x_.domain.pslg.points;
    for (std::uint32_t v = 0; v < x_.steiner.size(); ++v)
      if (!x_.steiner[v].dropped) x_.place.push_back(points.size()), points.push_back(x_.steiner[v].point);
      else x_.place.push_back(0);
    x_.vertices = insert_planar_points(x_.tr, std::span<const Point2>(points), x_.domain.pslg.points.size(), x_.control);
    std::size_t numbers = 0;  // also of the vertices of the box, which may be the last
    for (const Vertex v : x_.tr.finite_vertices()) numbers = std::max(numbers, x_.tr.index(v) + 1);
    x_.steiner_at.assign(numbers, detail::ExtensionSteiner::none);
    for (std::uint32_t v = 0; v < x_.steiner.size(); ++v) {
      if (x_.steiner[v].dropped) continue;
      x_.tr.set_origin(x_.vertices[x_.place[v]], Carrier{2, Carrier::none}, x_.steiner[v].provenance);
      x_.steiner_at[x_.tr.index(x_.vertices[x_.place[v]])] = v;
    }
  }

  std::vector<Vertex> chain(const detail::ExtensionPiece& piece) const {
    std::vector<Vertex> result{x_.vertices[piece.ends[0]]};
    for (const std::uint32_t v : piece.chain) result.push_back(x_.vertices[x_.place[v]]);
    result.push_back(x_.vertices[piece.ends[1]]);
    return result;
  }

  void insert_segments() {
    write_pieces();
    try {
      for (std::size_t k = 0; k < x_.pieces.size(); ++k) {
        if (k % 4096 == 0) throw_if_stopped(x_.control);
        insert_planar_chain<Tr>(x_.tr, chain(x_.pieces[k]));
      }
    } catch (const typename Tr::Cgal::Intersection_of_constraints_exception&) {
      refuse_crossings(x_.united.checked, x_.control);
    }
    for (std::size_t k = 0; k < x_.pieces.size(); ++k)
      if (!name_planar_chain<Tr>(x_.tr, x_.domain, chain(x_.pieces[k]), static_cast<Index>(k))) refuse_crossings(x_.united.checked, x_.control);
    x_.domain.index_segments();
  }

  /// The graph's segments become the pieces.
  void write_pieces() {
    CheckedPslg& checked = x_.united.checked;
    const std::vector<int> markers = std::exchange(checked.pslg.segment_markers, {});
    const std::vector<Index> originals = std::exchange(checked.original_segment, {});
    checked.pslg.segments.clear();
    for (const detail::ExtensionPiece& piece : x_.pieces) {
      checked.pslg.segments.push_back(piece.ends);
      if (!markers.empty()) checked.pslg.segment_markers.push_back(markers[piece.of]);
      checked.original_segment.push_back(originals[piece.of]);
    }
    x_.domain.pslg.segments = checked.pslg.segments;
    x_.domain.pslg.segment_markers = checked.pslg.segment_markers;
  }

  detail::PlanarExtension<Tr> x_;
  std::vector<std::string> notes_;
};

}  // namespace delref
