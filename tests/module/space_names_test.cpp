// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each name of the module delref's meshing of space, used by a program that only imports: the short way, and the stack put together
// by hand with a criterion and an observer of one's own.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

import delref;

using Catch::Approx;

namespace {

/// A box of 2 by 1 by 1 as two cubes that share a side.
delref::Plc two_cubes() {
  delref::Plc plc;
  for (const double x : {0.0, 1.0, 2.0})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) plc.points.push_back({x, y, z});
  const std::array<std::array<delref::Plc::Index, 4>, 11> sides{{{0, 1, 3, 2}, {4, 5, 7, 6}, {8, 9, 11, 10}, {0, 1, 5, 4},
                                                                 {4, 5, 9, 8}, {2, 3, 7, 6}, {6, 7, 11, 10}, {0, 2, 6, 4},
                                                                 {4, 6, 10, 8}, {1, 3, 7, 5}, {5, 7, 11, 9}}};
  for (const auto& side : sides) {
    delref::Plc::Facet& facet = plc.facets.emplace_back();
    facet.polygons.emplace_back(side.begin(), side.end());
    facet.marker = static_cast<int>(plc.facets.size());
  }
  plc.regions = {{{0.5, 0.5, 0.5}, 3, 0.01}, {{1.5, 0.5, 0.5}, 4, 0}};
  return plc;
}

/// No tetrahedron is taller than so much.
struct Height {
  static constexpr std::string_view name = "height";
  static constexpr bool bounds_size = true;
  double most = 1;
  bool is_met(const delref::TetrahedronShape& t) const {
    const auto [low, high] = std::ranges::minmax(t.corners | std::views::transform(&delref::Point3::z));
    return high - low <= most;
  }
};
static_assert(delref::TetrahedronCriterion<Height>);
static_assert(delref::explain_tetrahedron_criterion<Height>());

using Tr = delref::Delaunay3<>;
static_assert(delref::SpatialTriangulation<Tr>);

/// Counts what dies and looks at each new vertex, its tetrahedra and the Delaunay balls by delref's names alone.
struct Watcher {
  std::size_t dead = 0, born = 0;
  delref::Vector3 step;
  void on_before_insertion(const Tr&, const delref::Proposal<Tr>& proposal) {
    dead += static_cast<std::size_t>(std::ranges::distance(proposal.zone->dying_cells()));
  }
  void on_after_insertion(const Tr& tr, Tr::Vertex v, const delref::Proposal<Tr>& proposal) {
    for (const Tr::Cell c : proposal.zone->new_cells()) {
      ++born;
      for (const Tr::Vertex w : tr.vertices(c))
        if (!tr.is_infinite(w) && w != v) step = tr.point(w) - tr.point(v);
    }
  }
};

}  // namespace

TEST_CASE("a complex is meshed, judged, verified, written and read by import") {
  delref::PolyhedralOptions options;
  options.radius_edge = 1.6;
  options.max_volume = 0.05;
  const std::vector<delref::Point3> places{{0, 0, 0}};
  const std::vector<double> sizes{0.2};
  options.size = [field = delref::PointSizing3(places, sizes, 0.5)](delref::Point3 p) { return field(p); };
  CHECK(delref::checked_size(options.size, delref::Point3{0, 3, 4}) == 2.7);
  const delref::PolyhedralResult result = delref::mesh_polyhedron(two_cubes(), options);
  REQUIRE(result.outcome.complete());
  CHECK(result.outcome.unmet.empty());
  CHECK(result.notes.empty());

  const delref::TetrahedralQuality quality = delref::tetrahedral_quality(result.mesh);
  CHECK(quality.total_volume == Approx(2));
  CHECK(quality.regions.at(3).volume == Approx(1));
  CHECK(quality.worst_radius_edge <= 1.6);
  CHECK(delref::quality_table(quality).find("slivers") != std::string::npos);
  const auto [a, b, c, d] = result.mesh.tetrahedra.front();
  const auto& points = result.mesh.points;
  CHECK(delref::TetrahedronMeasures(points[a], points[b], points[c], points[d]).volume() > 0);

  delref::PolyhedralCriteria criteria;
  criteria.radius_edge = options.radius_edge;
  criteria.max_volume = options.max_volume;
  criteria.size = options.size;
  const delref::VerifyReport report = delref::verify_polyhedral(two_cubes(), result.mesh, criteria);
  INFO(delref::verify_table(report));
  CHECK(report.ok());

  delref::write_tetrahedral_mesh("module_test_3.vtu", result.mesh);
  CHECK(delref::read_tetrahedral_mesh("module_test_3.vtu").tetrahedra == result.mesh.tetrahedra);
  CHECK(std::get<delref::TetrahedralMesh>(delref::read_mesh("module_test_3.vtu")).regions == result.mesh.regions);
  CHECK(delref::tetrahedral_mesh_files("module_test_3.node").size() == 4);
}

TEST_CASE("bounds that no mesh of space can meet are refused, by import") {
  delref::PolyhedralOptions options;
  options.radius_edge = 0.9;
  CHECK_THROWS_AS(delref::mesh_polyhedron(two_cubes(), options), delref::InvalidInput);
  options.radius_edge = 2;
  options.cell_size = 0;
  CHECK_THROWS_AS(delref::check_polyhedral_options(options), delref::InvalidInput);
}

TEST_CASE("domains of space are read from text by import") {
  const delref::Plc plc = delref::parse_off("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", "a.off");
  CHECK(plc.facets.size() == 1);
  CHECK_THROWS_AS(delref::check_plc(plc), delref::InvalidInput);
  CHECK_THROWS_AS(delref::read_plc("no_such_file.off"), delref::InvalidInput);
  CHECK(delref::domain_dimension("a.off") == delref::Dimension::space);
  CHECK(delref::parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").plc.points.size() == 3);
}

TEST_CASE("the stack of space is put together by import, with a criterion and an observer of one's own") {
  const delref::Control control;
  const delref::PolyhedralDomain domain = delref::check_plc(two_cubes());
  CHECK(domain.facets.front().frame.lift({0, 0}) == domain.facets.front().frame.origin);
  Tr tr;
  delref::RegionRepair<Tr> repair;
  const delref::SmallAngleGuard guard(domain);
  const auto vertices = delref::insert_input_points(tr, domain, control);
  Watcher watcher;

  delref::Mesher conforming(tr, delref::conforming_levels<Tr>(tr, domain, vertices, repair));
  REQUIRE(conforming.refine(control, watcher).complete());
  const delref::PolyhedralRegions regions = delref::PolyhedralDomainLabeller<Tr>(tr, domain, control).take();
  delref::TetrahedronCriteria criteria(delref::RadiusEdge{2}, delref::MaximumVolume{0.1}, delref::MaximumRegionVolume(regions.regions),
                                             delref::MaximumCircumradius{1}, Height{0.4});
  delref::TetrahedraLevel3<Tr, decltype(criteria)> tetrahedra(criteria, repair, guard);
  delref::Mesher mesher(tr, delref::polyhedral_levels(tr, conforming.release<0>(), conforming.release<1>(), std::move(tetrahedra)));
  const auto outcome = mesher.refine(control, watcher);
  CHECK(outcome.complete());
  CHECK(outcome.unmet.empty());
  CHECK(watcher.dead > 0);
  CHECK(watcher.born > watcher.dead);
  CHECK(watcher.step != delref::Vector3{});

  const delref::TetrahedralMesh mesh = delref::extract_tetrahedral_mesh(tr, domain, regions, mesher.level<0>().subsegments(),
                                                                        mesher.level<1>().complex(), {"edges", "facets", "tetrahedra"});
  for (const auto& [a, b, c, d] : mesh.tetrahedra)
    CHECK(Height{0.4}.is_met(delref::TetrahedronShape({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]})));
  delref::PolyhedralCriteria promised;
  promised.radius_edge = 2;
  promised.max_volume = 0.1;
  promised.cell_size = 1;
  CHECK(delref::verify_polyhedral(two_cubes(), mesh, promised).ok());
}
