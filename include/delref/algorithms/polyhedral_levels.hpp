// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stacks of polyhedral meshing (Shewchuk 1998): edges before facets, which make the triangulation conform to the complex, and
// the same two with their state before tetrahedra. Tuples, so that levels of your own go in front, between or behind by
// `std::tuple_cat`.
#pragma once

#include <span>
#include <tuple>
#include <utility>

#include <delref/levels/edges_level_3.hpp>
#include <delref/levels/facets_level_3.hpp>
#include <delref/levels/tetrahedra_level_3.hpp>

namespace delref {

/// The levels that make every segment a chain of edges and every facet a set of faces. `vertices` are those of the domain in `tr`
/// (`insert_input_points`). The domain and the repair must outlive the levels.
template <SpatialTriangulation Tr>
auto conforming_levels(const Tr& tr, const PolyhedralDomain& domain, std::span<const typename Tr::Vertex> vertices,
                       RegionRepair<Tr>& repair, ConformingOptions options = {}) {
  return std::tuple(EdgesLevel3<Tr>(tr, domain, vertices, options), FacetsLevel3<Tr>(tr, domain, vertices, repair, options));
}

/// Conforming levels, which a mesher has worked off and released, with a tetrahedra level behind them.
template <SpatialTriangulation Tr, class Edges, class Facets, class Tetrahedra>
auto polyhedral_levels(Tr& tr, Edges edges, Facets facets, Tetrahedra tetrahedra) {
  facets.domain_is_labelled(tr);
  return std::tuple(std::move(edges), std::move(facets), std::move(tetrahedra));
}

}  // namespace delref
