// SPDX-License-Identifier: MIT
//
// What the levels of space ask of a triangulation, beyond what the frame asks: cells with slots and regions, faces and edges with
// the mark of the input constraint that they lie on, the dying and the new cells of a zone.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>

#include <delref/core/point.hpp>
#include <delref/core/queue/refinement_queue.hpp>
#include <delref/core/triangulation_concept.hpp>

namespace delref {

/// A Delaunay triangulation of space. A `Facet` is named by a cell and the index of the opposite vertex in it, and has another name
/// from its other cell; an `Edge` by its two vertices.
template <class Tr>
concept SpatialTriangulation =
    Triangulation<Tr> && std::same_as<typename Tr::Point, Point3> && std::default_initializable<typename Tr::Hint> &&
    requires(Tr& tr, const Tr& ctr, typename Tr::Cell c, typename Tr::Facet f, typename Tr::Vertex v, const typename Tr::Zone& zone,
             QueuePosition q) {
      requires StoresElement<Tr, typename Tr::Cell>;
      { ctr.vertex(c, 0) } -> std::same_as<typename Tr::Vertex>;
      { ctr.facet(c, 0) } -> std::same_as<typename Tr::Facet>;
      { ctr.mirror(f) } -> std::same_as<typename Tr::Facet>;
      { ctr.cell(f) } -> std::same_as<typename Tr::Cell>;
      { ctr.apex(f) } -> std::same_as<typename Tr::Vertex>;
      { ctr.is_infinite(v) } -> std::same_as<bool>;
      { ctr.is_infinite(c) } -> std::same_as<bool>;
      { ctr.has_marked_facets(c) } -> std::same_as<bool>;
      { ctr.has_marked_edges(c) } -> std::same_as<bool>;
      { ctr.is_marked(f) } -> std::same_as<bool>;
      { ctr.is_edge_marked(c, 0, 1) } -> std::same_as<bool>;
      tr.mark(f, true);
      tr.mark_edge(c, 0, 1, true);
      { ctr.region(c) } -> std::convertible_to<int>;
      tr.set_region(c, 0);
      { ctr.slot(c, std::size_t{}) } -> std::same_as<QueuePosition>;
      tr.set_slot(c, std::size_t{}, q);
      { ctr.finite_cells() } -> std::ranges::forward_range;
      { zone.dying_cells() } -> std::ranges::forward_range;
      { zone.new_cells() } -> std::ranges::forward_range;
    };

}  // namespace delref
