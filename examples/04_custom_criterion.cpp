// SPDX-License-Identifier: MIT
//
// Shows how to write a criterion of your own, and how to put a run together by hand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include <delref/algorithms/planar.hpp>
#include <delref/io/planar_formats.hpp>

namespace {

/// The depth of a bay, in metres: a trench crosses it.
double depth(delref::Point2 p) { return 10 + 40 * std::exp(-8 * (p.y - p.x) * (p.y - p.x)); }

/// No triangle spans more than so many metres of depth between its corners: few triangles on flat ground, many on the slopes.
struct DepthRange {
  static constexpr std::string_view name = "depth range";
  static constexpr bool bounds_size = true;  // every small enough triangle meets it
  double metres;

  static double of(const delref::TriangleShape& t) {
    const auto [low, high] = std::minmax({depth(t.corners[0]), depth(t.corners[1]), depth(t.corners[2])});
    return high - low;
  }
  bool is_met(const delref::TriangleShape& t) const { return of(t) <= metres; }
};
static_assert(delref::explain_triangle_criterion<DepthRange>());  // a missing member is told in a sentence

}  // namespace

int main() {
  delref::Pslg bay;
  bay.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  bay.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

  // What `mesh_planar` does, by hand. First the triangulation of the checked input, and the domain in it.
  using Tr = delref::ConstrainedDelaunay2<>;
  const delref::Control control;
  const delref::CheckedPslg checked = delref::check_pslg(bay, {}, control);
  Tr tr;
  delref::PlanarDomainBuilder builder(tr, checked, control);
  const delref::PlanarDomain domain = std::move(builder).domain();

  // Then the two levels of planar meshing with criteria of your choice, of any number.
  const auto bound = delref::AngleBound::degrees(20.7);
  const delref::TriangleCriteria criteria(delref::MinimumAngle{bound}, delref::MaximumEdge{0.5}, DepthRange{2.0});
  delref::Mesher mesher(tr, delref::planar_levels<Tr>(domain, criteria, delref::DiametralCircle{}, delref::OffCentre(bound)));
  const delref::Outcome<delref::Point2> outcome = mesher.refine(control);

  // At last the plain mesh.
  const delref::PlanarMesh mesh = delref::extract_planar_mesh(tr, domain, {"edges", "faces"});
  double worst = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    worst = std::max(worst, DepthRange::of({mesh.points[a], mesh.points[b], mesh.points[c]}));
  std::printf("%zu triangles; none spans more than %.2f m of depth\n", mesh.triangles.size(), worst);
  delref::write_planar_mesh("bay.svg", mesh);
  return outcome.complete() && outcome.unmet.empty() && worst <= 2.0 ? 0 : 1;
}
