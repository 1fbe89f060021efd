// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes of the mesher pass; then they are broken in each way that a mesh can be broken, and the check that is for it must fail.
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

#include <delref/mesh/verify_smooth.hpp>

#include "domains.hpp"

using namespace delref;
using namespace delref::testing_mesh_smooth;
using Index = TetrahedralMesh::Index;
using Names = std::vector<std::string>;

namespace {

const TetrahedralMesh& ball_mesh() {
  static const TetrahedralMesh mesh = meshed(ball());
  return mesh;
}
const TetrahedralMesh& ball_surface() {
  static const TetrahedralMesh mesh = meshed(ball(), surface_options());
  return mesh;
}
const TetrahedralMesh& halves_mesh() {
  static const TetrahedralMesh mesh = refined(halves(), usual_options()).mesh;
  return mesh;
}

VerifyReport verified(const Domain& domain, const TetrahedralMesh& mesh, const SmoothOptions& options = usual_options(),
                      const SmoothExpectations& expected = {}) {
  return verify_smooth(domain, mesh, options, expected);
}
Names failed(const VerifyReport& report) {
  Names names;
  for (const Finding& f : report.findings)
    if (f.status == CheckStatus::failed) names.push_back(f.name);
  return names;
}
Names failed(const Domain& domain, const TetrahedralMesh& mesh, const SmoothOptions& options = usual_options()) {
  return failed(verified(domain, mesh, options));
}
Names failed_of_ball(const TetrahedralMesh& mesh) { return failed(ball(), mesh); }
bool fails(const Names& names, const char* check) { return std::ranges::find(names, check) != names.end(); }

template <class T>
void erase(std::vector<T>& items, std::size_t i) {
  items.erase(items.begin() + static_cast<std::ptrdiff_t>(i));
}
void erase_triangle(TetrahedralMesh& mesh, std::size_t t) {
  erase(mesh.triangles, t), erase(mesh.triangle_markers, t), erase(mesh.triangle_facets, t);
}
void add_triangle(TetrahedralMesh& mesh, const std::array<Index, 3>& corners, std::size_t like) {
  mesh.triangles.push_back(corners);
  mesh.triangle_markers.push_back(mesh.triangle_markers[like]), mesh.triangle_facets.push_back(mesh.triangle_facets[like]);
}
void erase_tetrahedron(TetrahedralMesh& mesh, std::size_t t) { erase(mesh.tetrahedra, t), erase(mesh.regions, t); }

bool has_corners(const std::array<Index, 4>& tetrahedron, const std::array<Index, 3>& triangle) {
  return std::ranges::all_of(triangle, [&](Index v) { return std::ranges::count(tetrahedron, v) != 0; });
}
std::size_t tetrahedron_behind(const TetrahedralMesh& mesh, std::size_t triangle) {
  const auto found = std::ranges::find_if(mesh.tetrahedra, [&](const auto& t) { return has_corners(t, mesh.triangles[triangle]); });
  return static_cast<std::size_t>(found - mesh.tetrahedra.begin());
}

double volume(const TetrahedralMesh& mesh, const std::array<Index, 4>& t) {
  const Point3 p = mesh.points[t[0]];
  return dot(mesh.points[t[1]] - p, cross(mesh.points[t[2]] - p, mesh.points[t[3]] - p));
}

/// Replaces two tetrahedra with a common face by three around the line between the corners opposite to it.
bool flip_some_face(TetrahedralMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::size_t u = 0; u < t; ++u) {
      std::vector<Index> common, apex;
      for (const Index v : mesh.tetrahedra[t]) (std::ranges::count(mesh.tetrahedra[u], v) != 0 ? common : apex).push_back(v);
      for (const Index v : mesh.tetrahedra[u])
        if (std::ranges::count(mesh.tetrahedra[t], v) == 0) apex.push_back(v);
      if (common.size() != 3) continue;
      std::vector<std::array<Index, 4>> three;
      for (std::size_t k = 0; k < 3; ++k) three.push_back({common[k], common[(k + 1) % 3], apex[0], apex[1]});
      for (const double sign : {1.0, -1.0}) {
        if (!std::ranges::all_of(three, [&](const auto& n) { return sign * volume(mesh, n) > 1e-4; })) continue;
        for (auto& n : three)
          if (sign < 0) std::swap(n[0], n[1]);
        mesh.tetrahedra[t] = three[0], mesh.tetrahedra[u] = three[1];
        mesh.tetrahedra.push_back(three[2]), mesh.regions.push_back(mesh.regions[t]);
        return true;
      }
    }
  return false;
}

/// The surface of `mesh` with the vertex of greatest x of its left half being that of least x of the right one.
TetrahedralMesh pinched(TetrahedralMesh mesh) {
  std::array<Index, 2> nearest{};
  std::array<double, 2> distance{1e9, 1e9};
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const std::size_t side = mesh.points[v].x > 0;
    const double d = std::abs(mesh.points[v].x);
    if (d < distance[side]) distance[side] = d, nearest[side] = v;
  }
  for (auto& t : mesh.triangles) std::ranges::replace(t, nearest[1], nearest[0]);
  return mesh;
}

}  // namespace

TEST_CASE("what the mesher makes of smooth domains passes") {
  const VerifyReport of_ball = verified(ball(), ball_mesh());
  INFO(verify_table(of_ball));
  CHECK(of_ball.ok());
  REQUIRE(of_ball.surfaces.size() == 1);
  CHECK(of_ball.surfaces[0].euler_characteristic() == 2);
  CHECK(std::abs(of_ball.surfaces[0].volume - 4.18879) < 0.15);
  CHECK(of_ball.smallest_angle >= 30 - 1e-6);
  CHECK(of_ball.worst_radius_edge <= 2 + 1e-6);

  const VerifyReport of_surface = verified(ball(), ball_surface(), surface_options());
  INFO(verify_table(of_surface));
  CHECK(of_surface.ok());
  CHECK(of_surface.surfaces.size() == 1);

  SmoothExpectations torus;
  torus.components = 1;
  torus.euler_characteristic = 0;
  for (const bool surface_only : {false, true}) {
    SmoothOptions options = usual_options();
    options.surface_only = surface_only;
    const VerifyReport of_ring = verified(ring(), meshed(ring(), options), options, torus);
    INFO(verify_table(of_ring));
    CHECK(of_ring.ok());
  }
}

TEST_CASE("the halves of a ball pass, and have a surface each") {
  for (const bool surface_only : {false, true}) {
    SmoothOptions options = usual_options();
    options.surface_only = surface_only;
    const Refined result = refined(halves(), options);
    SmoothExpectations expected;
    expected.listed = result.unmet;
    const VerifyReport report = verified(halves(), result.mesh, options, expected);
    INFO(verify_table(report));
    CHECK(report.ok());
    REQUIRE(report.surfaces.size() == 2);
    for (const SurfacePiece& piece : report.surfaces) CHECK(piece.euler_characteristic() == 2);
    CHECK(report.surfaces[0].volume > report.surfaces[1].volume);
  }
}

TEST_CASE("bad indices, coordinates and lengths are found before anything is asked") {
  const char* name = "the mesh has triangles, and indices and coordinates are valid";
  TetrahedralMesh mesh = ball_mesh();
  mesh.tetrahedra[3][1] = static_cast<Index>(mesh.points.size());
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  mesh.triangles[3][1] = mesh.triangles[3][0];
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  mesh.points[5].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  mesh.regions.pop_back();
  CHECK(failed_of_ball(mesh) == Names{name});
  CHECK(failed_of_ball({}) == Names{name});
}

TEST_CASE("a vertex on another one, an inverted tetrahedron and a repeated one are found") {
  TetrahedralMesh mesh = ball_mesh();
  mesh.points[9] = mesh.points[4];
  CHECK(failed_of_ball(mesh) == Names{"no two vertices are at one place"});
  mesh = ball_mesh();
  std::swap(mesh.tetrahedra[7][0], mesh.tetrahedra[7][1]);
  CHECK(failed_of_ball(mesh) == Names{"tetrahedra are positively oriented"});
  mesh = ball_mesh();
  mesh.tetrahedra.push_back(mesh.tetrahedra[7]), mesh.regions.push_back(mesh.regions[7]);
  CHECK(failed_of_ball(mesh) == Names{"a triangle has at most one tetrahedron on each side"});
}

TEST_CASE("a triangle too few, too many, twice, or turned is found") {
  const char* name = "the triangles are what lies between regions, once";
  TetrahedralMesh mesh = ball_mesh();
  erase_triangle(mesh, 11);
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  add_triangle(mesh, mesh.triangles[11], 11);
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  std::swap(mesh.triangles[11][0], mesh.triangles[11][1]);
  CHECK(failed_of_ball(mesh) == Names{name});
  mesh = ball_mesh();
  const auto& t = mesh.tetrahedra[tetrahedron_behind(mesh, 11)];
  for (std::size_t k = 0; k < 4; ++k)
    add_triangle(mesh, {t[k], t[(k + 1) % 4], t[(k + 2) % 4]}, 11);
  CHECK(failed_of_ball(mesh) == Names{name});

  mesh = ball_surface();
  add_triangle(mesh, {mesh.triangles[11][2], mesh.triangles[11][1], mesh.triangles[11][0]}, 11);
  CHECK(failed_of_ball(mesh) == Names{name});
}

TEST_CASE("a tetrahedron with the label of the other region is found") {
  TetrahedralMesh mesh = halves_mesh();
  mesh.regions[20] = 3 - mesh.regions[20];
  CHECK(failed(halves(), mesh) == Names{"the triangles are what lies between regions, once"});
  mesh = ball_mesh();
  for (int& label : mesh.regions) label = 7;
  CHECK(fails(failed_of_ball(mesh), "tetrahedra have the labels of the regions of their circumcentres"));
}

TEST_CASE("a tetrahedron that should not be there, or is missing, is found by the balls of its triangles") {
  TetrahedralMesh mesh = ball_mesh();
  const std::size_t t = tetrahedron_behind(mesh, 11);
  const auto corners = mesh.tetrahedra[t];
  for (std::size_t k = mesh.triangles.size(); k-- > 0;)
    if (has_corners(corners, mesh.triangles[k])) erase_triangle(mesh, k);
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<Index, 3> face{corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]};
    const auto others = std::ranges::count_if(mesh.tetrahedra, [&](const auto& u) { return has_corners(u, face); });
    if (others < 2) continue;
    if (k % 2 == 0) std::swap(face[0], face[1]);  // towards where the tetrahedron was
    add_triangle(mesh, face, 0);
  }
  erase_tetrahedron(mesh, t);
  CHECK(fails(failed_of_ball(mesh), "triangles have empty balls with the centre on the surface"));
}

TEST_CASE("wrong markers are found") {
  const char* name = "triangles have one marker for each pair of regions";
  TetrahedralMesh mesh = halves_mesh();
  mesh.triangle_markers[11] = mesh.triangle_markers[11] % 3 + 1;
  CHECK(fails(failed(halves(), mesh), name));
  mesh = halves_mesh();
  for (int& marker : mesh.triangle_markers) marker = 1;
  for (Index& facet : mesh.triangle_facets) facet = 0;
  CHECK(fails(failed(halves(), mesh), name));
  mesh = ball_surface();
  mesh.triangle_markers[11] = 5;
  CHECK(failed_of_ball(mesh) == Names{name});
}

TEST_CASE("a hole in a surface, a facet turned in it and a pinched one are found") {
  TetrahedralMesh mesh = ball_surface();
  erase_triangle(mesh, 11);
  const Names hole = failed_of_ball(mesh);
  CHECK(fails(hole, "the surface is closed around every region"));
  CHECK(fails(hole, "the triangles at every vertex are a disk"));
  mesh = ball_surface();
  std::swap(mesh.triangles[11][0], mesh.triangles[11][1]);
  CHECK(fails(failed_of_ball(mesh), "triangles have empty balls with the centre on the surface"));

  const TetrahedralMesh two = meshed(two_balls(), surface_options());
  REQUIRE(failed(two_balls(), two, surface_options()).empty());
  const VerifyReport report = verified(two_balls(), pinched(two), surface_options());
  CHECK(fails(failed(report), "triangles have empty balls with the centre on the surface"));
}

TEST_CASE("two tetrahedra that touch at a vertex are closed and no disk") {
  TetrahedralMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 4, 6, 5}};
  mesh.regions = {1, 1};
  for (const auto& t : mesh.tetrahedra)
    for (const auto& [i, j, k] : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}})
      mesh.triangles.push_back({t[std::size_t(i)], t[std::size_t(j)], t[std::size_t(k)]});
  const VerifyReport report = verified(ball(), mesh);
  CHECK(report.find("the triangles are what lies between regions, once")->status == CheckStatus::passed);
  CHECK(report.find("the surface is closed around every region")->status == CheckStatus::passed);
  CHECK(report.find("the triangles at every vertex are a disk")->failures == 1);
  CHECK(report.surfaces.size() == 2);
  SmoothOptions options = usual_options();
  options.manifold = false;
  CHECK(verified(ball(), mesh, options).find("the triangles at every vertex are a disk")->status == CheckStatus::not_run);
}

TEST_CASE("a topology that is not the expected one is found") {
  SmoothExpectations expected;
  expected.components = 1;
  expected.euler_characteristic = 2;
  CHECK(failed(verified(ball(), ball_mesh(), usual_options(), expected)).empty());
  expected.components = 2;
  CHECK(failed(verified(ball(), ball_mesh(), usual_options(), expected)) == Names{"the surface has the topology that was expected"});
  expected.components = 1;
  expected.euler_characteristic = 0;
  CHECK(failed(verified(ball(), ball_mesh(), usual_options(), expected)) == Names{"the surface has the topology that was expected"});
}

TEST_CASE("a face that was flipped is not Delaunay") {
  TetrahedralMesh mesh = ball_mesh();
  REQUIRE(flip_some_face(mesh));
  CHECK(fails(failed_of_ball(mesh), "tetrahedra are Delaunay"));
}

TEST_CASE("a vertex off the surface is found, and one within the tolerance is not") {
  const char* name = "the vertices of triangles are on the surface";
  const Index v = ball_surface().triangles[11][0];
  for (const double factor : {1 + 1e-4, 1 - 1e-4}) {
    TetrahedralMesh mesh = ball_surface();
    Point3& p = mesh.points[v];
    p = {factor * p.x, factor * p.y, factor * p.z};
    CHECK(fails(failed_of_ball(mesh), name));
  }
  TetrahedralMesh mesh = ball_surface();
  mesh.points[v].x *= 1 + 1e-8;
  CHECK(failed_of_ball(mesh).empty());
}

TEST_CASE("components and volumes of the domain that are not in the mesh are found") {
  TetrahedralMesh one = meshed(two_balls());
  for (std::size_t t = one.tetrahedra.size(); t-- > 0;)
    if (one.points[one.tetrahedra[t][0]].x > 0) erase_tetrahedron(one, t);
  for (std::size_t t = one.triangles.size(); t-- > 0;)
    if (one.points[one.triangles[t][0]].x > 0) erase_triangle(one, t);
  CHECK(failed(two_balls(), one) ==
        Names{"every component of the surface is in the mesh", "regions have the volume that they have in the domain, roughly"});
  SmoothExpectations expected;
  expected.missed_components = 1;
  CHECK(failed(verified(two_balls(), one, usual_options(), expected)) == Names{"regions have the volume that they have in the domain, roughly"});
}

TEST_CASE("vertices that lie about what they are are found") {
  TetrahedralMesh mesh = ball_mesh();
  mesh.carriers[mesh.triangles[0][0]].dimension = 3;
  CHECK(fails(failed_of_ball(mesh), "vertices say what they lie on"));
  mesh = ball_mesh();
  const auto inside = std::ranges::find(mesh.carriers, 3, &Carrier::dimension);
  REQUIRE(inside != mesh.carriers.end());
  inside->dimension = 1;
  CHECK(failed_of_ball(mesh) == Names{"vertices say what they lie on"});
  mesh = ball_mesh();
  mesh.provenance[mesh.triangles[0][0]] = 9;
  CHECK(failed_of_ball(mesh) == Names{"vertices name who inserted them"});
}

TEST_CASE("the mesh of another domain does not pass") {
  const Domain smaller{[](Point3 p) { return std::hypot(p.x, p.y, p.z) < 0.97 ? 0 : outside; }};
  const Names names = failed(smaller, ball_mesh());
  CHECK(fails(names, "the vertices of triangles are on the surface"));
  CHECK(failed(smaller, ball_surface(), surface_options()).size() >= 1);
  const Domain hollow{[](Point3 p) { return std::hypot(p.x, p.y, p.z) < 1 && std::hypot(p.x, p.y, p.z) > 0.7 ? 0 : outside; }};
  const Names of_hollow = failed(hollow, ball_mesh());
  CHECK(fails(of_hollow, "tetrahedra have the labels of the regions of their circumcentres"));
  CHECK(fails(of_hollow, "regions have the volume that they have in the domain, roughly"));
  CHECK(fails(of_hollow, "every component of the surface is in the mesh"));
}

TEST_CASE("each criterion of facets fails when it is tightened") {
  for (const TetrahedralMesh& mesh : {ball_mesh(), ball_surface()}) {
    SmoothOptions options = usual_options();
    options.facet_angle = AngleBound::degrees(45);
    CHECK(failed(ball(), mesh, options) == Names{"no facet angle is under the bound"});
    options = usual_options();
    options.facet_size = 0.15;
    CHECK(failed(ball(), mesh, options) == Names{"no surface ball is greater than the facet size"});
    options = usual_options();
    options.facet_size_field = [](Point3 p) { return p.x < 0 ? 1 : 0.15; };
    CHECK(failed(ball(), mesh, options) == Names{"no surface ball is greater than the facet size"});
    options = usual_options();
    options.facet_distance = 0.01;
    CHECK(failed(ball(), mesh, options) == Names{"no facet is further from the surface than its bound"});
    options.facet_distance = 0.0202;  // 1 - sqrt(1 - 0.2^2)
    CHECK(failed(ball(), mesh, options).empty());
    options.facet_distance_field = [](Point3 p) { return p.x < 0 ? 1 : 0.01; };
    CHECK(failed(ball(), mesh, options) == Names{"no facet is further from the surface than its bound"});
  }
}

TEST_CASE("each criterion of tetrahedra fails when it is tightened") {
  SmoothOptions options = usual_options();
  options.radius_edge = 1;
  CHECK(failed(ball(), ball_mesh(), options) == Names{"no radius-edge ratio is over the bound"});
  const char* size = "no circumradius is greater than the cell size";
  options = usual_options();
  options.cell_size = 0.2;
  CHECK(failed(ball(), ball_mesh(), options) == Names{size});
  options = usual_options();
  options.region_cell_sizes = {0.2};
  CHECK(failed(ball(), ball_mesh(), options) == Names{size});
  options.region_cell_sizes = {0, 0.2};
  CHECK(failed(ball(), ball_mesh(), options).empty());
  options.cell_size_field = [](Point3 p) { return p.x < 0 ? 10 : 0.2; };
  CHECK(failed(ball(), ball_mesh(), options) == Names{size});
}

TEST_CASE("what is listed, at the size floor or unfinished is no failure, unless the check is strict") {
  SmoothOptions options = usual_options();
  options.facet_angle = AngleBound::degrees(45);
  SmoothExpectations expected;
  expected.complete = false;
  const VerifyReport unfinished = verified(ball(), ball_mesh(), options, expected);
  CHECK(unfinished.ok());
  CHECK(unfinished.unfinished > 0);
  CHECK(unfinished.smallest_angle < 45);
  CHECK(unfinished.smallest_angle_in_force >= 45 - 1e-6);
  expected.complete = true;
  for (const auto& [a, b, c] : ball_mesh().triangles) {
    const auto& p = ball_mesh().points;
    expected.listed.push_back({0, "minimum facet angle", Reason::size_floor, p[a] + (1.0 / 3) * ((p[b] - p[a]) + (p[c] - p[a])), {}, 3});
  }
  const VerifyReport listed = verified(ball(), ball_mesh(), options, expected);
  CHECK(listed.ok());
  CHECK(listed.listed_unmet == unfinished.unfinished);
  expected.strict = true;
  CHECK(failed(verified(ball(), ball_mesh(), options, expected)) == Names{"no facet angle is under the bound"});
  options.smallest_facet = 0.3;
  CHECK(failed(ball(), ball_mesh(), options).empty());
  CHECK(failed(verified(ball(), ball_mesh(), options, expected)) == Names{"no facet angle is under the bound"});
}

TEST_CASE("verification of smooth meshes does the same for coordinates of every size") {
  for (const double factor : {0x1p-100, 0x1p100}) {
    TetrahedralMesh mesh = ball_mesh();
    for (Point3& p : mesh.points) p = {factor * p.x, factor * p.y, factor * p.z};
    const Domain scaled{[=](Point3 p) { return std::hypot(p.x / factor, p.y / factor, p.z / factor) < 1 ? 0 : outside; },
                        {{-1.3 * factor, -1.3 * factor, -1.3 * factor}, {1.3 * factor, 1.3 * factor, 1.3 * factor}}};
    SmoothOptions options = usual_options();
    options.facet_size *= factor;
    options.smallest_facet *= factor;
    const VerifyReport report = verify_smooth(scaled, mesh, options);
    CHECK(report.find("triangles have empty balls with the centre on the surface")->status == CheckStatus::passed);
    CHECK(report.find("no surface ball is greater than the facet size")->status == CheckStatus::passed);
    Point3& moved = mesh.points[mesh.triangles[0][0]];
    moved = {1.001 * moved.x, 1.001 * moved.y, 1.001 * moved.z};
    CHECK_FALSE(verify_smooth(scaled, mesh, options).ok());
  }
}

TEST_CASE("verification of smooth meshes stops when it is told to") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(verify_smooth(ball(), ball_mesh(), usual_options(), {}, Control({}, source.get_token())), Interrupted);
}
