// SPDX-License-Identifier: MIT
//
// Shows how to write a criterion on the facets of a surface of your own, and how to put a run on a smooth domain together by hand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <tuple>

#include <delref/algorithms/extract_smooth_mesh.hpp>
#include <delref/algorithms/smooth_levels.hpp>
#include <delref/core/mesher.hpp>
#include <delref/domain/build_polyhedral_domain.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/io/surface_formats.hpp>
#include <delref/triangulation/delaunay_3.hpp>

namespace {

/// An ellipsoid, and the direction in which its function grows.
double ellipsoid(delref::Point3 p) { return p.x * p.x / 9 + p.y * p.y + p.z * p.z - 1; }
delref::Vector3 gradient(delref::Point3 p) { return {2 * p.x / 9, 2 * p.y, 2 * p.z}; }

/// No facet is turned against the surface by more than an angle: small facets where the surface bends, large ones where it is flat.
struct NormalDeviation {
  static constexpr std::string_view name = "normal deviation";
  static constexpr bool bounds_size = true;  // every small enough facet of good shape meets it
  double degrees;

  static double of(const delref::SurfaceFacetShape& f) {
    const auto& [a, b, c] = f.corners;
    const delref::Vector3 n = cross(b - a, c - a), g = gradient(f.centre);  // the centre of the surface ball is on the surface
    const double cosine = std::abs(dot(n, g)) / std::sqrt(squared_length(n) * squared_length(g));
    return std::acos(std::min(1.0, cosine)) * 180 / std::acos(-1.0);
  }
  bool is_met(const delref::SurfaceFacetShape& f) const { return of(f) <= degrees; }
};
static_assert(delref::explain_surface_facet_criterion<NormalDeviation>());  // a missing member is told in a sentence

}  // namespace

int main() {
  const delref::ImplicitDomain domain(ellipsoid, delref::BoundingBox3{{-3.5, -1.5, -1.5}, {3.5, 1.5, 1.5}});

  // What `mesh_smooth_domain` does, by hand. First a triangulation of points on every component of the surface, so many that a cell of it
  // has its circumcentre inside, with the corners of a box around them, so that the whole surface is in its hull.
  using Tr = delref::Delaunay3<1, 1>;
  const delref::Control control;
  delref::PolyhedralDomain first;
  for (const double x : {-10.0, 10.0})
    for (const double y : {-4.0, 4.0})
      for (const double z : {-4.0, 4.0}) first.points.push_back({x, y, z});
  for (const auto& seeds : domain.components(control).components) first.points.insert(first.points.end(), seeds.begin(), seeds.end());
  Tr tr;
  const auto vertices = delref::insert_input_points(tr, first, control);
  for (std::size_t i = 0; i < vertices.size(); ++i)  // those of the box are on nothing, the others on the surface
    tr.set_origin(vertices[i], i < 8 ? delref::Carrier{} : delref::Carrier{2, 0}, delref::input_level);

  // Then the level, with criteria of your choice, of any number. A level of tetrahedra could come behind it.
  using Criteria = delref::SurfaceFacetCriteria<delref::MinimumFacetAngle, delref::MaximumFacetSize, NormalDeviation>;
  const Criteria criteria(delref::MinimumFacetAngle{}, delref::MaximumFacetSize{1}, NormalDeviation{2});
  using Level = delref::SurfaceLevel3<Tr, decltype(domain), Criteria>;
  delref::Mesher mesher(tr, std::tuple(Level(domain, criteria, {.smallest_radius = 1e-3})));
  const delref::Outcome<delref::Point3> outcome = mesher.refine(control);

  // At last the plain mesh.
  const auto& complex = mesher.level<0>().complex();
  const auto mesh = delref::extract_smooth_mesh(tr, complex, delref::surface_patches(complex), {1}, true, {"surface"});
  double worst = 0;
  complex.for_each([&](const auto& r) {
    const auto [a, b, c] = tr.vertices(r.facet);
    worst = std::max(worst, NormalDeviation::of({{tr.point(a), tr.point(b), tr.point(c)}, r.centre, r.regions}));
  });
  std::printf("%zu triangles; none is turned by more than %.2f degrees\n", mesh.triangles.size(), worst);
  delref::write_surface("ellipsoid.off", mesh);
  return outcome.complete() && outcome.unmet.empty() && !mesh.triangles.empty() && worst <= 2 ? 0 : 1;
}
