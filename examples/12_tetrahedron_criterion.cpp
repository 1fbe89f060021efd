// SPDX-License-Identifier: MIT
//
// Shows how to write a criterion on tetrahedra of your own, and how to put a run in space together by hand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include <delref/algorithms/polyhedral_refinement.hpp>
#include <delref/io/tetrahedral_formats.hpp>

namespace {

/// The temperature in a block that a rod along its edge heats, in kelvin.
double temperature(delref::Point3 p) { return 300 + 80 * std::exp(-4 * std::hypot(p.x, p.y)); }

/// No tetrahedron spans more than so many kelvin between its corners: small ones at the rod, large ones far from it.
struct TemperatureRange {
  static constexpr std::string_view name = "temperature range";
  static constexpr bool bounds_size = true;  // every small enough tetrahedron meets it
  double kelvin;

  static double of(const delref::TetrahedronShape& t) {
    const auto& [a, b, c, d] = t.corners;
    const auto [low, high] = std::minmax({temperature(a), temperature(b), temperature(c), temperature(d)});
    return high - low;
  }
  bool is_met(const delref::TetrahedronShape& t) const { return of(t) <= kelvin; }
};
static_assert(delref::explain_tetrahedron_criterion<TemperatureRange>());  // a missing member is told in a sentence

}  // namespace

int main() {
  delref::Plc block;
  block.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  block.facets = {{{{0, 1, 2, 3}}, {}, 0}, {{{4, 5, 6, 7}}, {}, 0}, {{{0, 1, 5, 4}}, {}, 0},
                  {{{1, 2, 6, 5}}, {}, 0}, {{{2, 3, 7, 6}}, {}, 0}, {{{3, 0, 4, 7}}, {}, 0}};

  // What `mesh_polyhedron` does, by hand. First the Delaunay triangulation of the checked input.
  using Tr = delref::Delaunay3<>;
  const delref::Control control;
  const delref::PolyhedralDomain domain = delref::check_plc(block, {}, control);
  Tr tr;
  const auto vertices = delref::insert_input_points(tr, domain, control);

  // Then two levels that make every segment a chain of edges and every facet a set of faces. Only now do facets separate regions.
  delref::RegionRepair<Tr> repair;
  delref::Mesher conform(tr, delref::conforming_levels<Tr>(tr, domain, vertices, repair));
  conform.refine(control);
  const delref::PolyhedralRegions regions = delref::PolyhedralDomainLabeller<Tr>(tr, domain, control).take();

  // The same two with the tetrahedra level behind them, with criteria of your choice, of any number.
  const delref::SmallAngleGuard guard(domain);
  delref::TetrahedronCriteria criteria(delref::RadiusEdge{2}, TemperatureRange{10});
  delref::Mesher mesher(tr, delref::polyhedral_levels(tr, conform.release<0>(), conform.release<1>(),
                                                      delref::TetrahedraLevel3(criteria, repair, guard)));
  const delref::Outcome<delref::Point3> outcome = mesher.refine(control);

  // At last the plain mesh.
  const delref::TetrahedralMesh mesh = delref::extract_tetrahedral_mesh(
      tr, domain, regions, mesher.level<0>().subsegments(), mesher.level<1>().complex(), {"edges", "facets", "tetrahedra"});
  double worst = 0;
  const auto& p = mesh.points;
  for (const auto& [a, b, c, d] : mesh.tetrahedra)
    worst = std::max(worst, TemperatureRange::of(delref::TetrahedronShape({p[a], p[b], p[c], p[d]})));
  std::printf("%zu tetrahedra; none spans more than %.2f kelvin\n", mesh.tetrahedra.size(), worst);
  delref::write_tetrahedral_mesh("block.svg", mesh);
  return outcome.complete() && outcome.unmet.empty() && worst <= 10 ? 0 : 1;
}
