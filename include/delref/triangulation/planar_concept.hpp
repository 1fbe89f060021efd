// SPDX-License-Identifier: MIT
//
// What the planar levels ask of a triangulation, beyond what the frame asks: faces and edges with slots, constraints with the
// input segment that they lie on, the domain, the dying and the new elements of a zone.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>

#include <delref/core/point.hpp>
#include <delref/core/queue/refinement_queue.hpp>
#include <delref/core/triangulation_concept.hpp>

namespace delref {

/// A constrained Delaunay triangulation of the plane. An edge is named by a face and the index 0, 1 or 2 of the opposite vertex in
/// it; the same edge has another name from its other face.
template <class Tr>
concept PlanarTriangulation =
    Triangulation<Tr> && std::same_as<typename Tr::Point, Point2> &&
    requires(Tr& tr, const Tr& ctr, typename Tr::Face f, typename Tr::Edge e, const typename Tr::Zone& zone, QueuePosition q,
             Point2 p) {
      requires StoresElement<Tr, typename Tr::Face>;
      requires StoresElement<Tr, typename Tr::Edge>;
      { ctr.vertex(f, 0) } -> std::same_as<typename Tr::Vertex>;
      { ctr.source(e) } -> std::same_as<typename Tr::Vertex>;
      { ctr.target(e) } -> std::same_as<typename Tr::Vertex>;
      { ctr.apex(e) } -> std::same_as<typename Tr::Vertex>;
      { ctr.edge(f, 0) } -> std::same_as<typename Tr::Edge>;
      { ctr.face(e) } -> std::same_as<typename Tr::Face>;
      { ctr.mirror(e) } -> std::same_as<typename Tr::Edge>;
      { ctr.is_constrained(e) } -> std::same_as<bool>;
      { ctr.segment(e) } -> std::convertible_to<std::size_t>;
      { ctr.in_domain(f) } -> std::same_as<bool>;
      { ctr.region(f) } -> std::convertible_to<int>;
      { ctr.in_diametral_circle(e, p) } -> std::same_as<bool>;
      { ctr.slot(f, std::size_t{}) } -> std::same_as<QueuePosition>;
      { ctr.slot(e, std::size_t{}) } -> std::same_as<QueuePosition>;
      tr.set_slot(f, std::size_t{}, q);
      tr.set_slot(e, std::size_t{}, q);
      { ctr.domain_faces() } -> std::ranges::forward_range;
      { ctr.finite_vertices() } -> std::ranges::forward_range;
      { ctr.subsegments() } -> std::ranges::forward_range;
      { zone.dying_faces() } -> std::ranges::forward_range;
      { zone.new_faces() } -> std::ranges::forward_range;
      { zone.dying_subsegments() } -> std::ranges::forward_range;
      { zone.boundary_edges() } -> std::ranges::forward_range;
    };

}  // namespace delref
