// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stacks of smooth domains: the surface alone (Boissonnat and Oudot 2005), or the surface before tetrahedra (Oudot, Rineau and
// Yvinec, "Meshing volumes bounded by smooth surfaces", 2005). Tuples, so that levels of your own go in front, between or behind by
// `std::tuple_cat`.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/criteria/surface_facet_criteria.hpp>
#include <delref/criteria/tetrahedron_criteria.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/levels/cell_rules.hpp>
#include <delref/levels/surface_level_3.hpp>
#include <delref/levels/tetrahedra_level_3.hpp>

namespace delref {

namespace smooth_detail {

inline double size_or_infinity(const std::function<double(Point3)>& field, Point3 p) {
  return field ? field(p) : std::numeric_limits<double>::infinity();
}
inline auto facet_criteria(const SmoothOptions& options) {
  const auto size = [field = options.facet_size_field](Point3 p) { return size_or_infinity(field, p); };
  const auto distance = [field = options.facet_distance_field](Point3 p) { return size_or_infinity(field, p); };
  return SurfaceFacetCriteria(MaximumFacetSize{options.facet_size}, MaximumFacetDistance{options.facet_distance},
                              MinimumFacetAngle{options.facet_angle}, FacetSizeAtCentre{size}, FacetDistanceAtCentre{distance});
}
inline auto cell_criteria(const SmoothOptions& options) {
  const auto size = [field = options.cell_size_field](Point3 p) { return size_or_infinity(field, p); };
  return TetrahedronCriteria(RadiusEdge{options.radius_edge}, MaximumCircumradius{options.cell_size},
                             MaximumRegionCircumradius{options.region_cell_sizes}, SizeAtCircumcentre{size});
}

}  // namespace smooth_detail

/// The level that meshes the surface of a domain. The oracle must outlive it.
template <SpatialTriangulation Tr, Oracle O>
auto surface_levels(const O& oracle, const SmoothOptions& options) {
  auto criteria = smooth_detail::facet_criteria(options);
  return std::tuple(SurfaceLevel3<Tr, O, decltype(criteria)>(
      oracle, std::move(criteria), {options.smallest_facet, options.surface_tolerance, std::min(options.facet_size, 10 * options.facet_distance), options.manifold}));
}

/// The same, and one that meshes the volume inside behind it.
template <SpatialTriangulation Tr, Oracle O>
auto volume_levels(const O& oracle, const SmoothOptions& options, double smallest_edge = 0) {
  auto criteria = smooth_detail::cell_criteria(options);
  return std::tuple_cat(surface_levels<Tr>(oracle, options),
                        std::tuple(TetrahedraLevel3<Tr, decltype(criteria), LabelledCells<Tr>>(std::move(criteria), {}, smallest_edge)));
}

}  // namespace delref
