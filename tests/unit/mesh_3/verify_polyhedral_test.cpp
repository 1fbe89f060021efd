// SPDX-License-Identifier: GPL-3.0-or-later
//
// A valid mesh is broken in each way that a mesh can be broken, and exactly the check that is for it must fail.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/verify_polyhedral.hpp>

#include "test_solids.hpp"

using namespace delref;
using namespace delref::testing_mesh_3;
using Index = TetrahedralMesh::Index;
using Names = std::vector<std::string>;

namespace {

Names failed_checks(const TetrahedralMesh& mesh, const PolyhedralCriteria& criteria = {}) {
  return failed(verify_polyhedral(three_rooms(), mesh, criteria));
}

bool fails(const Names& names, const char* check) { return std::ranges::find(names, check) != names.end(); }

Index vertex_at(const TetrahedralMesh& mesh, Point3 p) {
  return static_cast<Index>(std::ranges::find(mesh.points, p) - mesh.points.begin());
}

template <class T>
void erase(std::vector<T>& items, std::size_t i) {
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
}

void erase_triangle(TetrahedralMesh& mesh, std::size_t t) {
  erase(mesh.triangles, t), erase(mesh.triangle_markers, t), erase(mesh.triangle_facets, t);
}

void erase_edge(TetrahedralMesh& mesh, std::size_t e) {
  erase(mesh.edges, e), erase(mesh.edge_markers, e), erase(mesh.edge_segments, e);
}

void erase_tetrahedron(TetrahedralMesh& mesh, std::size_t t) { erase(mesh.tetrahedra, t), erase(mesh.regions, t); }

void erase_vertex_labels(TetrahedralMesh& mesh) { mesh.carriers.clear(), mesh.point_markers.clear(), mesh.provenance.clear(); }

std::size_t triangle_of_facet(const TetrahedralMesh& mesh, Index facet) {
  return static_cast<std::size_t>(std::ranges::find(mesh.triangle_facets, facet) - mesh.triangle_facets.begin());
}

double volume(const TetrahedralMesh& mesh, const std::array<Index, 4>& t) {
  return dot(mesh.points[t[1]] - mesh.points[t[0]],
             cross(mesh.points[t[2]] - mesh.points[t[0]], mesh.points[t[3]] - mesh.points[t[0]]));
}

/// Replaces two tetrahedra of one room with a common face by three around the line between the corners that the face has opposite
/// to it.
bool flip_some_face(TetrahedralMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::size_t u = 0; u < t; ++u) {
      std::vector<Index> common, apex;
      for (const Index v : mesh.tetrahedra[t]) (std::ranges::count(mesh.tetrahedra[u], v) != 0 ? common : apex).push_back(v);
      for (const Index v : mesh.tetrahedra[u])
        if (std::ranges::count(mesh.tetrahedra[t], v) == 0) apex.push_back(v);
      if (common.size() != 3 || mesh.regions[t] != mesh.regions[u]) continue;
      std::vector<std::array<Index, 4>> three;
      for (std::size_t k = 0; k < 3; ++k) three.push_back({common[k], common[(k + 1) % 3], apex[0], apex[1]});
      for (const double sign : {1.0, -1.0}) {
        if (!std::ranges::all_of(three, [&](const auto& n) { return sign * volume(mesh, n) > 0.01; })) continue;
        for (auto& n : three)
          if (sign < 0) std::swap(n[0], n[1]);
        mesh.tetrahedra[t] = three[0], mesh.tetrahedra[u] = three[1];
        mesh.tetrahedra.push_back(three[2]), mesh.regions.push_back(mesh.regions[t]);
        return true;
      }
    }
  return false;
}

int everywhere(Point3) { return 1; }

/// A square prism whose front and bottom meet under 45 degrees.
Plc wedge() {
  Plc plc;
  add_facet(plc, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, 1);
  add_facet(plc, {{0, 0, 2}, {2, 0, 2}, {2, 2, 2}}, 2);
  add_facet(plc, {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}}, 3);
  add_facet(plc, {{2, 0, 0}, {2, 2, 0}, {2, 2, 2}, {2, 0, 2}}, 4);
  add_facet(plc, {{2, 2, 0}, {0, 0, 0}, {0, 0, 2}, {2, 2, 2}}, 5);
  return plc;
}

Plc unit_cube() {
  Plc plc;
  add_box(plc, {0, 0, 0}, {1, 1, 1}, 1);
  return plc;
}

/// A cube of side 4 with a cube of side 1 in it.
Plc box_in_box() {
  Plc plc;
  add_box(plc, {0, 0, 0}, {4, 4, 4}, 1);
  add_box(plc, {1.5, 1.5, 1.5}, {2.5, 2.5, 2.5}, 11);
  plc.regions = {{{0.5, 0.5, 0.5}, 3, 0}, {{2.1, 2.2, 2.3}, 4, 0}};
  return plc;
}
bool in_inner_box(Point3 p) { return std::max({std::abs(p.x - 2), std::abs(p.y - 2), std::abs(p.z - 2)}) < 0.5; }
TetrahedralMesh box_in_box_mesh() {
  return meshed(box_in_box(), {}, [](Point3 p) { return in_inner_box(p) ? 4 : 3; });
}

}  // namespace

TEST_CASE("a mesh of three rooms passes every check, and so does one without labels") {
  CHECK(failed_checks(three_rooms_mesh()).empty());
  TetrahedralMesh mesh = three_rooms_mesh();
  erase_vertex_labels(mesh);
  mesh.regions.clear(), mesh.edges.clear(), mesh.edge_markers.clear(), mesh.edge_segments.clear();
  mesh.triangle_facets.clear();
  CHECK(failed_checks(mesh).empty());
  mesh.triangle_markers.clear();
  const VerifyReport report = verify_polyhedral(three_rooms(), mesh);
  CHECK(failed(report).empty());
  CHECK(report.find("edges have the markers of their segments")->status == CheckStatus::not_run);
}

TEST_CASE("an index that names nothing and a coordinate that is none are found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.tetrahedra[3][1] = 1000;
  CHECK(failed_checks(mesh) == Names{"the mesh has tetrahedra, and indices and coordinates are valid"});
  mesh = three_rooms_mesh();
  mesh.points.back().y = std::numeric_limits<double>::quiet_NaN();
  CHECK(failed_checks(mesh) == Names{"the mesh has tetrahedra, and indices and coordinates are valid"});
  CHECK(failed_checks({}) == Names{"the mesh has tetrahedra, and indices and coordinates are valid"});
  Plc plc = three_rooms();
  plc.facets[2].polygons[0][1] = 99;
  CHECK(failed(verify_polyhedral(plc, three_rooms_mesh())) == Names{"the input is usable"});
}

TEST_CASE("an inverted tetrahedron and a flat one are found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  std::swap(mesh.tetrahedra[5][0], mesh.tetrahedra[5][1]);
  CHECK(failed_checks(mesh) == Names{"tetrahedra are positively oriented"});
  mesh = three_rooms_mesh();
  const Index v = vertex_at(mesh, {0.3125, 0.6875, 0.25});
  mesh.points[v].z = 2;
  CHECK(failed_checks(mesh) == Names{"tetrahedra are positively oriented"});
}

TEST_CASE("a tetrahedron that is there twice is found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.tetrahedra.push_back(mesh.tetrahedra[7]), mesh.regions.push_back(mesh.regions[7]);
  CHECK(failed_checks(mesh) == Names{"a triangle has at most one tetrahedron on each side"});
}

TEST_CASE("a missing tetrahedron is a leak") {
  for (const std::size_t t : {0U, 20U, 50U}) {
    TetrahedralMesh mesh = three_rooms_mesh();
    erase_tetrahedron(mesh, t);
    CHECK(failed_checks(mesh) == Names{"the tetrahedra fill the domain, once"});
  }
}

TEST_CASE("a room without its tetrahedra and triangles is found, whether or not others share a facet with it") {
  TetrahedralMesh mesh = three_rooms_mesh();
  for (std::size_t t = mesh.tetrahedra.size(); t-- > 0;)
    if (mesh.regions[t] == 1) erase_tetrahedron(mesh, t);
  CHECK(failed_checks(mesh) == Names{"the tetrahedra fill the domain, once"});
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
    if (mesh.triangle_facets[t] < 6 && mesh.triangle_facets[t] != 1) erase_triangle(mesh, t);
  CHECK(fails(failed_checks(mesh), "the tetrahedra fill the domain, once"));

  Plc two = unit_cube();
  add_box(two, {3, 0, 0}, {4, 1, 1}, 11);
  const TetrahedralMesh one = meshed(unit_cube(), {}, everywhere);
  const VerifyReport report = verify_polyhedral(two, one);
  CHECK(failed(report) == Names{"the tetrahedra fill the domain, once"});
  CHECK(report.find("the tetrahedra fill the domain, once")->failures == 6);
}

TEST_CASE("a cavity that is filled is found") {
  const TetrahedralMesh right = three_rooms_mesh();
  const TetrahedralMesh filled =
      meshed(three_rooms(), {right.points.begin() + static_cast<std::ptrdiff_t>(three_rooms().points.size()), right.points.end()},
             [](Point3 p) { return p.x < 3 ? label_in_three_rooms(p) : 0; });
  CHECK(failed_checks(filled) == Names{"the tetrahedra fill the domain, once"});
}

TEST_CASE("a body inside another has a room of its own, and filling it or not is told apart") {
  CHECK(failed(verify_polyhedral(box_in_box(), box_in_box_mesh())).empty());
  Plc plc = box_in_box();
  plc.holes = {{2.1, 2.2, 2.3}};
  plc.regions.pop_back();
  CHECK(failed(verify_polyhedral(plc, box_in_box_mesh())) == Names{"the tetrahedra fill the domain, once"});
  const TetrahedralMesh hollow = meshed(plc, {}, [](Point3 p) { return in_inner_box(p) ? outside : 3; });
  CHECK(failed(verify_polyhedral(plc, hollow)).empty());
  CHECK(failed(verify_polyhedral(box_in_box(), hollow)) == Names{"the tetrahedra fill the domain, once"});
}

TEST_CASE("two bodies on top of each other are found, though each is sound") {
  TetrahedralMesh mesh = box_in_box_mesh();
  const TetrahedralMesh outer = meshed(box_in_box(), {}, everywhere);
  const TetrahedralMesh whole = meshed(
      [] {
        Plc p;
        add_box(p, {0, 0, 0}, {4, 4, 4}, 1);
        return p;
      }(),
      {}, everywhere);
  TetrahedralMesh both;
  both.points = mesh.points;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    if (mesh.regions[t] == 4) both.tetrahedra.push_back(mesh.tetrahedra[t]);
  for (const auto& t : whole.tetrahedra) both.tetrahedra.push_back(t);  // the outer box goes right through the inner one
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_facets[t] >= 6) {
      both.triangles.push_back(mesh.triangles[t]);
      both.triangle_facets.push_back(mesh.triangle_facets[t]);
    }
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    both.triangles.push_back(whole.triangles[t]);
    both.triangle_facets.push_back(whole.triangle_facets[t]);
  }
  CHECK(failed(verify_polyhedral(box_in_box(), both)) == Names{"the tetrahedra fill the domain, once"});
}

TEST_CASE("an input vertex that was moved is missing") {
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.points[0].x = -1e-15;
  CHECK(fails(failed_checks(mesh), "input vertices are in the mesh, once"));
}

TEST_CASE("an isolated vertex must be in the mesh where it is in the domain") {
  Plc plc = three_rooms();
  plc.points.push_back({9, 9, 9});
  plc.points.push_back({3.5, 0.5, 0.5});
  plc.point_markers.clear();
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.point_markers.clear();
  CHECK(failed(verify_polyhedral(plc, mesh)).empty());
  plc.points.push_back({2, 0.125, 0.75});
  CHECK(failed(verify_polyhedral(plc, mesh)) == Names{"isolated vertices and segments are in the mesh"});
}

TEST_CASE("a segment on no facet must be a chain of edges of tetrahedra") {
  Plc plc = unit_cube();
  plc.points.insert(plc.points.end(), {{0.5, 0.5, 0.25}, {0.5, 0.5, 0.75}});
  plc.segments = {{8, 9}};
  plc.segment_markers = {6};
  TetrahedralMesh mesh = meshed(plc, {{0.5, 0.5, 0.5}}, everywhere);
  CHECK(failed(verify_polyhedral(plc, mesh)).empty());
  const auto on_it = std::ranges::find(mesh.edge_markers, 6);
  REQUIRE(on_it != mesh.edge_markers.end());
  erase_edge(mesh, static_cast<std::size_t>(on_it - mesh.edge_markers.begin()));
  CHECK(fails(failed(verify_polyhedral(plc, mesh)), "isolated vertices and segments are in the mesh"));
}

TEST_CASE("a chain with a gap, one that is not listed in full, and one off its segment are found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  erase_edge(mesh, 0);
  CHECK(fails(failed_checks(mesh), "input segments are chains of edges"));

  mesh = three_rooms_mesh();
  const Index v = vertex_at(mesh, {0.25, 0, 0});
  mesh.points[v].y = 1e-14;  // inwards
  const Names names = failed_checks(mesh);
  CHECK(fails(names, "the vertices of chains lie on their segments"));
  mesh.points[v].y = 4e-16;
  CHECK_FALSE(fails(failed_checks(mesh), "the vertices of chains lie on their segments"));
}

TEST_CASE("an edge that is listed and lies on no segment is found, and one that is listed twice") {
  TetrahedralMesh mesh = three_rooms_mesh();
  const auto& t = mesh.tetrahedra[0];
  for (const auto& [i, j] : TetrahedronMeasures::edge_corners) {
    const auto joins = [&, a = t[i], b = t[j]](const auto& e) { return (e[0] == a && e[1] == b) || (e[0] == b && e[1] == a); };
    if (std::ranges::any_of(mesh.edges, joins)) continue;
    mesh.edges.push_back({t[i], t[j]}), mesh.edge_markers.push_back(0), mesh.edge_segments.push_back(0);
    break;
  }
  CHECK(failed_checks(mesh) == Names{"edges on input segments are listed, and nothing else"});
  mesh = three_rooms_mesh();
  mesh.edges.push_back(mesh.edges[2]), mesh.edge_markers.push_back(mesh.edge_markers[2]), mesh.edge_segments.push_back(0);
  CHECK(failed_checks(mesh) == Names{"edges on input segments are listed, and nothing else"});
}

TEST_CASE("wrong markers, labels, carriers and levels are found, each by its own check") {
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.edge_markers[static_cast<std::size_t>(std::ranges::find(mesh.edge_markers, 50) - mesh.edge_markers.begin())] = 51;
  CHECK(failed_checks(mesh) == Names{"edges have the markers of their segments"});
  mesh = three_rooms_mesh();
  std::swap(mesh.triangle_markers[triangle_of_facet(mesh, 0)], mesh.triangle_markers[triangle_of_facet(mesh, 3)]);
  CHECK(failed_checks(mesh) == Names{"triangles have the markers of their facets"});
  mesh = three_rooms_mesh();
  mesh.regions[4] = 3 - mesh.regions[4];
  CHECK(failed_checks(mesh) == Names{"tetrahedra have the labels of their regions"});
  for (int& label : mesh.regions) label = 1;
  CHECK(failed_checks(mesh) == Names{"tetrahedra have the labels of their regions"});
  for (const Point3 p : {Point3{0, 0, 0}, {0.25, 0, 0}, {0.4375, 0.5625, 0}, {2, 0.5, 0.1875}}) {
    mesh = three_rooms_mesh();
    auto& dimension = mesh.carriers[vertex_at(mesh, p)].dimension;
    dimension = dimension == 2 ? 3 : 2;
    CHECK(failed_checks(mesh) == Names{"vertices name the kind of input element that they lie on"});
    mesh = three_rooms_mesh();
    ++mesh.point_markers[vertex_at(mesh, p)];
    CHECK(failed_checks(mesh) == Names{"vertices have their markers"});
    mesh = three_rooms_mesh();
    auto& level = mesh.provenance[vertex_at(mesh, p)];
    level = level == input_level ? 0 : 1;
    CHECK(failed_checks(mesh) == Names{"vertices name who inserted them"});
  }
}

TEST_CASE("an unlabelled room has one label, whichever") {
  Plc plc = three_rooms();
  plc.regions.clear();
  TetrahedralMesh mesh = three_rooms_mesh();
  CHECK(failed(verify_polyhedral(plc, mesh)).empty());
  mesh.regions[0] = 5;
  CHECK(failed(verify_polyhedral(plc, mesh)) == Names{"tetrahedra have the labels of their regions"});
}

TEST_CASE("a facet with a triangle too few or too many is found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  erase_triangle(mesh, triangle_of_facet(mesh, 31 - 15));  // of the floating square
  CHECK(failed_checks(mesh) == Names{"the triangles cover the facets, once"});
  for (const Index facet : {0U, 1U, 7U}) {
    mesh = three_rooms_mesh();
    erase_triangle(mesh, triangle_of_facet(mesh, facet));
    CHECK(failed_checks(mesh) == Names{"the triangles cover the facets, once"});
    mesh = three_rooms_mesh();
    const std::size_t t = triangle_of_facet(mesh, facet);
    mesh.triangles.push_back(mesh.triangles[t]);
    mesh.triangle_markers.push_back(mesh.triangle_markers[t]), mesh.triangle_facets.push_back(facet);
    CHECK(failed_checks(mesh) == Names{"the triangles cover the facets, once"});
  }
}

TEST_CASE("a triangle that is not on its facet, and a vertex that was lifted off it, are found") {
  TetrahedralMesh mesh = three_rooms_mesh();
  mesh.triangle_facets[triangle_of_facet(mesh, 0)] = 3;
  CHECK(fails(failed_checks(mesh), "listed triangles lie on their facets"));
  mesh = three_rooms_mesh();
  mesh.points[vertex_at(mesh, {0.4375, 0.5625, 0})].z = 1e-13;
  CHECK(fails(failed_checks(mesh), "listed triangles lie on their facets"));
  mesh.points[vertex_at(mesh, {0.4375, 0.5625, 1e-13})].z = 1e-15;
  CHECK_FALSE(fails(failed_checks(mesh), "listed triangles lie on their facets"));
}

TEST_CASE("a facet that is missing as a whole is found where it is in the domain") {
  TetrahedralMesh mesh = three_rooms_mesh();
  for (std::size_t t = mesh.triangles.size(); t-- > 0;)
    if (mesh.triangle_facets[t] == 16) erase_triangle(mesh, t);
  CHECK(failed_checks(mesh) == Names{"the tetrahedra fill the domain, once"});
}

TEST_CASE("a face that was flipped is not Delaunay") {
  TetrahedralMesh mesh = three_rooms_mesh();
  REQUIRE(flip_some_face(mesh));
  CHECK(failed_checks(mesh) == Names{"tetrahedra are Delaunay"});
}

TEST_CASE("a facet may have a window, and a slit") {
  Plc plc = unit_cube();
  add_box(plc, {1, 0, 0}, {2, 1, 1}, 11, "x");
  const auto first = static_cast<Index>(plc.points.size());
  plc.points.insert(plc.points.end(),
                    {{1, 0.25, 0.25}, {1, 0.75, 0.25}, {1, 0.75, 0.75}, {1, 0.25, 0.75}, {1, 0.5, 0.125}, {1, 0.5, 0}});
  Plc::Facet& wall = plc.facets[1];
  wall.polygons.push_back({first, first + 1, first + 2, first + 3});
  wall.polygons.push_back({first + 4, first + 5});
  wall.holes = {{1, 0.5, 0.5}};
  const std::vector<Point3> middles{{1, 0.5, 1}, {1, 0, 0.5}, {1, 1, 0.5}};
  const TetrahedralMesh mesh = meshed(plc, middles, everywhere);
  CHECK(failed(verify_polyhedral(plc, mesh)).empty());
  TetrahedralMesh broken = mesh;
  erase_triangle(broken, triangle_of_facet(broken, 1));
  CHECK(failed(verify_polyhedral(plc, broken)) == Names{"the triangles cover the facets, once"});
  TetrahedralMesh two_labels = mesh;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) two_labels.regions[t] = volume(mesh, mesh.tetrahedra[t]) > 0.1;
  CHECK(fails(failed(verify_polyhedral(plc, two_labels)), "tetrahedra have the labels of their regions"));
  wall.holes.clear();  // now the window is a facet too, and has no triangles
  CHECK(failed(verify_polyhedral(plc, mesh)) == Names{"the triangles cover the facets, once"});
}

TEST_CASE("a box of twelve triangles is one of six facets when they are joined") {
  Plc twelve = unit_cube();
  const std::vector<Plc::Facet> squares = std::exchange(twelve.facets, {});
  for (const Plc::Facet& square : squares)
    for (const bool second : {false, true}) {
      const auto& p = square.polygons[0];
      twelve.facets.push_back({{second ? std::vector{p[3], p[1], p[2]} : std::vector{p[0], p[3], p[1]}}, {}, 1});
    }
  // A vertex in the middle of a face and one on its diagonal keep the diagonal from being a chain.
  TetrahedralMesh mesh = meshed(unit_cube(), {{0.5, 0.4375, 0}, {0.375, 0.3125, 1}}, everywhere);
  for (Index& f : mesh.triangle_facets) f *= 2;
  for (int& marker : mesh.triangle_markers) marker = 1;
  mesh.point_markers.clear();
  PolyhedralCriteria joined;
  joined.input.join_coplanar_degrees = 0.1;
  CHECK(failed(verify_polyhedral(twelve, mesh, joined)).empty());
  CHECK(fails(failed(verify_polyhedral(twelve, mesh)), "input segments are chains of edges"));
  twelve.facets[0].marker = 2;  // not joined then
  CHECK(fails(failed(verify_polyhedral(twelve, mesh, joined)), "input segments are chains of edges"));
}

TEST_CASE("a ratio over the bound fails, unless it is listed, unfinished or excused") {
  const TetrahedralMesh mesh = three_rooms_mesh();
  const double worst = verify_polyhedral(three_rooms(), mesh).worst_radius_edge;
  PolyhedralCriteria criteria;
  criteria.radius_edge = worst;
  CHECK(failed_checks(mesh, criteria).empty());
  criteria.radius_edge = 0.999 * worst;
  const VerifyReport over = verify_polyhedral(three_rooms(), mesh, criteria);
  CHECK(failed(over) == Names{"no radius-edge ratio is over the bound"});
  CHECK(over.worst_radius_edge == worst);

  PolyhedralCriteria listed = criteria;
  for (const auto& t : mesh.tetrahedra) {
    const TetrahedronMeasures shape(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]);
    if (shape.squared_radius_edge() > criteria.radius_edge * criteria.radius_edge)
      listed.listed.push_back({0, "radius-edge", Reason::precision, shape.barycentre(), {}, 0});
  }
  CHECK(failed_checks(mesh, listed).empty());
  CHECK(verify_polyhedral(three_rooms(), mesh, listed).listed_unmet == listed.listed.size());
  PolyhedralCriteria strict = listed;
  strict.strict = true;
  CHECK_FALSE(failed_checks(mesh, strict).empty());
  for (auto& unmet : listed.listed) unmet.reason = Reason::small_input_angle;
  CHECK_FALSE(failed_checks(mesh, listed).empty());
  criteria.complete = false;
  CHECK(failed_checks(mesh, criteria).empty());
  CHECK(verify_polyhedral(three_rooms(), mesh, criteria).unfinished > 0);
}

TEST_CASE("an input angle under 90 degrees excuses ratios near it, not if the check is strict") {
  const TetrahedralMesh mesh = meshed(wedge(), {{0.25, 0, 1}, {0.25, 0.25, 0.75}}, everywhere);
  PolyhedralCriteria criteria;
  criteria.radius_edge = 0.8;
  const VerifyReport report = verify_polyhedral(wedge(), mesh, criteria);
  CHECK(failed(report).empty());
  CHECK(report.excused_angles > 0);
  criteria.strict = true;
  CHECK(failed(verify_polyhedral(wedge(), mesh, criteria)) == Names{"no radius-edge ratio is over the bound"});
}

TEST_CASE("volumes, circumradii and sizes over their bounds fail") {
  const TetrahedralMesh mesh = three_rooms_mesh();
  PolyhedralCriteria criteria;
  criteria.max_volume = 0.05;
  CHECK(failed_checks(mesh, criteria) == Names{"no volume is over its bound"});
  Plc plc = three_rooms();
  plc.regions[1].max_volume = 0.01;
  CHECK(failed(verify_polyhedral(plc, mesh)) == Names{"no volume is over its bound"});
  criteria = {};
  criteria.cell_size = 0.25;
  CHECK(failed_checks(mesh, criteria) == Names{"no circumradius is over the bound"});
  criteria = {};
  criteria.size = [](Point3 p) { return p.x < 1.5 ? 3.0 : 0.1; };
  CHECK(failed_checks(mesh, criteria) == Names{"no circumradius is greater than the sizing field says"});
  criteria.size = [](Point3) { return 100.0; };
  CHECK(failed_checks(mesh, criteria).empty());
}

TEST_CASE("verification does the same for coordinates of every size") {
  for (const double factor : {0x1p-300, 0x1p-20, 0x1p20, 0x1p300}) {
    Plc plc = three_rooms();
    TetrahedralMesh mesh = three_rooms_mesh();
    const auto scale = [&](Point3& p) { p = {factor * p.x, factor * p.y, factor * p.z}; };
    for (Point3& p : plc.points) scale(p);
    for (Point3& p : mesh.points) scale(p);
    for (Point3& p : plc.holes) scale(p);
    for (Plc::Region& r : plc.regions) {
      scale(r.seed);
      r.max_volume = 0;
    }
    CHECK(failed(verify_polyhedral(plc, mesh)).empty());
    mesh.points[vertex_at(mesh, {factor * 0.4375, factor * 0.5625, 0})].z = factor * 1e-10;
    CHECK_FALSE(failed(verify_polyhedral(plc, mesh)).empty());
  }
}

TEST_CASE("a seed on a facet is told") {
  Plc plc = three_rooms();
  plc.regions[0].seed = {1, 0.3, 0.3};
  CHECK(failed(verify_polyhedral(plc, three_rooms_mesh())) == Names{"the tetrahedra fill the domain, once"});
}

TEST_CASE("verification of a mesh in space stops when it is told to") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(verify_polyhedral(three_rooms(), three_rooms_mesh(), {}, Control({}, source.get_token())), Interrupted);
}
