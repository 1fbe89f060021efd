// SPDX-License-Identifier: MIT
//
// What the frame asks of a triangulation: the narrow part that does not depend on the dimension. Levels of a dimension ask for
// more (`PlanarTriangulation` in triangulation/planar_concept.hpp). A user's own triangulation that has these members works with
// `Mesher` and with every level that needs no more.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>

#include <delref/core/carrier.hpp>
#include <delref/core/proposal.hpp>

namespace delref {

/// Part 1: names its types.
template <class Tr>
concept TriangulationTypes = requires {
  typename Tr::Point;
  typename Tr::Vertex;
  typename Tr::Edge;
  typename Tr::Hint;
  typename Tr::Zone;
  { Tr::dimension } -> std::convertible_to<int>;
} && requires(const typename Tr::Point& p) {
  { is_finite(p) } -> std::same_as<bool>;
} && std::copyable<typename Tr::Vertex> && std::default_initializable<typename Tr::Vertex> &&
    std::equality_comparable<typename Tr::Vertex> && std::default_initializable<typename Tr::Zone> &&
    std::default_initializable<typename Tr::Point> && std::default_initializable<typename Tr::Edge>;

/// Part 2: finds the conflict zone of a point, searched from a hint, into a zone that it reuses.
template <class Tr>
concept FindsConflictZones =
    requires(Tr& tr, const typename Tr::Point& p, const typename Tr::Hint& hint, typename Tr::Zone& zone) {
      { tr.conflict_zone(p, hint, zone) } -> std::same_as<Location<Tr>>;
    };

/// Part 3: inserts a point into the zone that part 2 found, which makes a vertex (a weighted point that would be hidden has no zone:
/// part 2 says `degenerate`).
template <class Tr>
concept InsertsIntoZones = requires(Tr& tr, const typename Tr::Point& p, typename Tr::Zone& zone) {
  { tr.insert(p, zone) } -> std::same_as<typename Tr::Vertex>;
  { zone.vanishing() } -> std::ranges::input_range;
};

/// Part 4: tells of each vertex its point and a number that is never reused, and keeps what the frame writes on it.
template <class Tr>
concept DescribesVertices =
    requires(Tr& tr, const Tr& ctr, typename Tr::Vertex v, Carrier carrier, LevelIndex level,
             std::span<const typename Tr::Vertex> vertices) {
      { ctr.point(v) } -> std::convertible_to<typename Tr::Point>;
      { ctr.index(v) } -> std::convertible_to<std::size_t>;
      { ctr.carrier(v) } -> std::same_as<Carrier>;
      { ctr.provenance(v) } -> std::same_as<LevelIndex>;
      tr.set_origin(v, carrier, level);
      { ctr.number_of_vertices() } -> std::convertible_to<std::size_t>;
      { ctr.is_simplex(vertices) } -> std::same_as<bool>;
      { ctr.barycentre(vertices) } -> std::convertible_to<typename Tr::Point>;
    };

/// Part 5: forgets all slots, for a new scan.
template <class Tr>
concept ClearsSlots = requires(Tr& tr) { tr.clear_slots(); };

/// A triangulation that a `Mesher` can refine.
template <class Tr>
concept Triangulation =
    TriangulationTypes<Tr> && FindsConflictZones<Tr> && InsertsIntoZones<Tr> && DescribesVertices<Tr> && ClearsSlots<Tr>;

/// `E` is an element that `Tr` stores: it can be a hint, has vertices, and a zone tells whether it dies.
template <class Tr, class E>
concept StoresElement = requires(const Tr& tr, const E& e, const typename Tr::Zone& zone) {
  typename Tr::Hint;
  requires std::constructible_from<typename Tr::Hint, const E&>;
  { tr.vertices(e) } -> std::ranges::input_range;
  { tr.dies(e, zone) } -> std::same_as<bool>;
};

/// Fails to compile with one sentence per missing part.
template <class Tr>
consteval bool explain_triangulation() {
  static_assert(TriangulationTypes<Tr>,
                "a triangulation needs: types Point (with is_finite(point)), Vertex (copyable, comparable), Edge, Hint, Zone, all but Hint "
                "default constructible, and a constant `dimension`");
  static_assert(FindsConflictZones<Tr>,
                "a triangulation needs: conflict_zone(point, hint, zone) that gives a delref::Location of it");
  static_assert(InsertsIntoZones<Tr>,
                "a triangulation needs: insert(point, zone) that gives the new Vertex, and zone.vanishing() that lists the "
                "vertices this insertion removes");
  static_assert(DescribesVertices<Tr>,
                "a triangulation needs: point(v), index(v), carrier(v), provenance(v), set_origin(v, carrier, level), "
                "number_of_vertices(), is_simplex(vertices), barycentre(vertices)");
  static_assert(ClearsSlots<Tr>, "a triangulation needs: clear_slots() that forgets every level's mark on every element");
  return Triangulation<Tr>;
}

}  // namespace delref
