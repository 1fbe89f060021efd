// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stack of planar meshing: edges before faces (Ruppert 1995; Shewchuk 2002). A tuple, so that levels of your own go in front,
// between or behind by `std::tuple_cat`.
#pragma once

#include <tuple>
#include <utility>

#include <delref/levels/edges_level_2.hpp>
#include <delref/levels/faces_level_2.hpp>

namespace delref {

/// The two levels of planar meshing on the triangulation type `Tr`, which must be given: `planar_levels<Tr>(domain, ...)`.
///
/// `criteria` is a `TriangleCriteria<...>`, `encroachment` an `Encroachment2` policy, `points` a `PointChoice2` policy. The domain
/// must outlive the levels. With the circle, angle bounds up to 20.7 degrees are proven to end, with the lens up to 26.4; beyond
/// that it is experience, and a budget is advised.
template <PlanarTriangulation Tr, class Criteria, class Encroachment = DiametralCircle, class Points = Circumcentre>
auto planar_levels(const PlanarDomain& domain, Criteria criteria, Encroachment encroachment = {}, Points points = {},
                   EdgesOptions options = {}) {
  return std::tuple(EdgesLevel2<Tr, Encroachment>(domain, encroachment, options),
                    FacesLevel2<Tr, Criteria, Points>(domain, std::move(criteria), std::move(points), options.smallest_edge));
}

}  // namespace delref
