// SPDX-License-Identifier: GPL-3.0-or-later
//
// A valid mesh is broken in each way that a mesh can be broken, and exactly the check that is for it must fail.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/verify_planar.hpp>

#include "test_mesh.hpp"

using namespace delref;
using namespace delref::testing_mesh;
using Index = PlanarMesh::Index;
using Names = std::vector<std::string>;

namespace {

Names failed_checks(const PlanarMesh& mesh, const PlanarCriteria& criteria = {}) {
  return failed(verify_planar(two_rooms(), mesh, criteria));
}

Index vertex_at(const PlanarMesh& mesh, Point2 p) {
  return static_cast<Index>(std::ranges::find(mesh.points, p) - mesh.points.begin());
}

std::size_t listed_edge(const PlanarMesh& mesh, Point2 a, Point2 b) {
  const Index v = vertex_at(mesh, a), w = vertex_at(mesh, b);
  const auto is_it = [&](const auto& e) { return (e[0] == v && e[1] == w) || (e[0] == w && e[1] == v); };
  return static_cast<std::size_t>(std::ranges::find_if(mesh.edges, is_it) - mesh.edges.begin());
}

/// The two triangles that have an edge: of each, its index and the corner opposite to the edge.
std::vector<std::pair<std::size_t, std::size_t>> sides(const PlanarMesh& mesh, Index v, Index w) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][(k + 1) % 3], b = mesh.triangles[t][(k + 2) % 3];
      if ((a == v && b == w) || (a == w && b == v)) found.push_back({t, k});
    }
  return found;
}

double turn(const PlanarMesh& mesh, Index a, Index b, Index c) {
  return cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

/// Replaces an edge by the other diagonal of its two triangles; false when they are not strictly convex.
bool flip(PlanarMesh& mesh, Index v, Index w) {
  const auto s = sides(mesh, v, w);
  if (s.size() != 2) return false;
  const auto [t, i] = s[0];
  const auto [u, j] = s[1];
  const Index a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3], c = mesh.triangles[t][(i + 2) % 3];
  const Index d = mesh.triangles[u][j];
  if (!(turn(mesh, a, b, d) > 0) || !(turn(mesh, a, d, c) > 0)) return false;
  mesh.triangles[t] = {a, b, d};
  mesh.triangles[u] = {a, d, c};
  return true;
}

bool is_listed(const PlanarMesh& mesh, Index v, Index w) {
  return listed_edge(mesh, mesh.points[v], mesh.points[w]) != mesh.edges.size();
}

void erase_edge(PlanarMesh& mesh, std::size_t e) {
  mesh.edges.erase(mesh.edges.begin() + static_cast<std::ptrdiff_t>(e));
  mesh.edge_markers.erase(mesh.edge_markers.begin() + static_cast<std::ptrdiff_t>(e));
  mesh.edge_segments.erase(mesh.edge_segments.begin() + static_cast<std::ptrdiff_t>(e));
}

void drop_labels(PlanarMesh& mesh) {
  mesh.point_markers.clear(), mesh.carriers.clear(), mesh.provenance.clear(), mesh.regions.clear();
  mesh.edges.clear(), mesh.edge_markers.clear(), mesh.edge_segments.clear();
}

Unmet<Point2> unmet(Reason reason, Point2 place) {
  Unmet<Point2> u;
  u.reason = reason;
  u.place = place;
  return u;
}

/// A triangle none of whose edges is a subsegment.
std::size_t inner_triangle(const PlanarMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (!is_listed(mesh, a, b) && !is_listed(mesh, b, c) && !is_listed(mesh, c, a)) return t;
  }
  return mesh.triangles.size();
}

}  // namespace

TEST_CASE("a constrained Delaunay mesh with all its labels passes every check that applies") {
  const VerifyReport report = verify_planar(two_rooms(), two_rooms_mesh());
  INFO(verify_table(report));
  CHECK(report.ok());
  CHECK(std::ranges::count(report.findings, CheckStatus::not_run, &Finding::status) == 4);  // circles, edge bound, sizing field
}

TEST_CASE("a mesh that carries no labels is checked all the same") {
  PlanarMesh mesh = two_rooms_mesh();
  drop_labels(mesh);
  CHECK(failed_checks(mesh).empty());
  CHECK(verify_planar(two_rooms(), mesh).find("subsegments are listed, and nothing else")->status == CheckStatus::not_run);
}

TEST_CASE("an edge that was flipped is not Delaunay") {
  const PlanarMesh whole = two_rooms_mesh();
  int flipped = 0;
  for (const auto& t : whole.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k], w = t[(k + 1) % 3];
      PlanarMesh mesh = whole;
      if (v > w || is_listed(whole, v, w) || !flip(mesh, v, w)) continue;
      ++flipped;
      CHECK(failed_checks(mesh) == Names{"edges are Delaunay, subsegments excepted"});
    }
  CHECK(flipped > 10);
}

TEST_CASE("an inverted triangle and a flat one are not counterclockwise") {
  PlanarMesh mesh = two_rooms_mesh();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  CHECK(failed_checks(mesh) == Names{"triangles are counterclockwise"});
  mesh = two_rooms_mesh();
  mesh.triangles[3] = {vertex_at(mesh, {0, 0}), vertex_at(mesh, {0.8125, 0}), vertex_at(mesh, {2, 0})};
  CHECK(failed_checks(mesh) == Names{"triangles are counterclockwise"});
}

TEST_CASE("a Steiner vertex that was moved by 1e-9 is off its segment, with labels and without") {
  PlanarMesh mesh = two_rooms_mesh();
  mesh.points[vertex_at(mesh, {4, 1.6875})].x += 1e-9;
  CHECK(failed_checks(mesh) == Names{"the vertices of chains lie on their segments"});
  drop_labels(mesh);
  CHECK(failed_checks(mesh) == Names{"the vertices of chains lie on their segments"});
}

TEST_CASE("a Steiner vertex may be four ulp off its segment, and no more") {
  for (const auto& [ulps, names] : {std::pair{4, Names{}}, std::pair{5, Names{"the vertices of chains lie on their segments"}}}) {
    PlanarMesh mesh = two_rooms_mesh();
    mesh.points[vertex_at(mesh, {0, 2.9375})].x -= ulps * 4 * std::numeric_limits<double>::epsilon();
    CHECK(failed_checks(mesh) == names);
  }
}

TEST_CASE("an input vertex that was moved by 1e-9 is missing") {
  PlanarMesh mesh = two_rooms_mesh();
  mesh.points[vertex_at(mesh, {4, 4})].x -= 1e-9;
  CHECK(failed_checks(mesh) == Names{"input vertices are in the mesh, once"});
}

TEST_CASE("a triangle that was dropped leaves the domain uncovered") {
  PlanarMesh mesh = two_rooms_mesh();
  const auto t = static_cast<std::ptrdiff_t>(inner_triangle(mesh));
  mesh.triangles.erase(mesh.triangles.begin() + t);
  mesh.regions.erase(mesh.regions.begin() + t);
  CHECK(failed_checks(mesh) == Names{"the triangles cover the domain, once"});
}

TEST_CASE("a hole that was filled is outside the domain") {
  PlanarMesh mesh = two_rooms_mesh();
  const Index a = vertex_at(mesh, {2.5, 1}), b = vertex_at(mesh, {3.5, 1}), c = vertex_at(mesh, {3.5, 2}), d = vertex_at(mesh, {2.5, 2});
  mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  mesh.regions.insert(mesh.regions.end(), {0, 0});
  CHECK(failed_checks(mesh) == Names{"the triangles cover the domain, once"});
}

TEST_CASE("a triangle that is there twice crowds its edges") {
  PlanarMesh mesh = two_rooms_mesh();
  mesh.triangles.push_back(mesh.triangles[inner_triangle(mesh)]);
  mesh.regions.push_back(mesh.regions[inner_triangle(mesh)]);
  CHECK(failed_checks(mesh) == Names{"an edge has at most one triangle on each side"});
}

TEST_CASE("two rings of triangles around one vertex are not a star") {
  Pslg hexagon;
  PlanarMesh mesh;
  mesh.points = {{0, 0}};
  for (const double angle : {0.0, 0.5})
    for (int i = 0; i < 6; ++i) mesh.points.push_back({std::cos(angle + i * 1.0472), std::sin(angle + i * 1.0472)});
  for (Index i = 0; i < 6; ++i) {
    hexagon.points.push_back(mesh.points[1 + i]);
    hexagon.segments.push_back({i, (i + 1) % 6});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
    mesh.triangles.push_back({0, 7 + i, 7 + (i + 1) % 6});
  }
  CHECK(failed(verify_planar(hexagon, mesh)) == Names{"the triangles at a vertex are one ring, or fans"});
}

TEST_CASE("a subsegment that is not listed, and a listed one that is none, are told") {
  PlanarMesh mesh = two_rooms_mesh();
  erase_edge(mesh, listed_edge(mesh, {4, 1.6875}, {4, 3.0625}));
  CHECK(failed_checks(mesh) == Names{"subsegments are listed, and nothing else"});
  mesh = two_rooms_mesh();
  const auto& t = mesh.triangles[inner_triangle(mesh)];
  mesh.edges.push_back({t[0], t[1]});
  mesh.edge_markers.push_back(1);
  mesh.edge_segments.push_back(0);
  CHECK(failed_checks(mesh) == Names{"subsegments are listed, and nothing else"});
}

TEST_CASE("a subsegment that names another segment is told") {
  PlanarMesh mesh = two_rooms_mesh();
  mesh.edge_segments[listed_edge(mesh, {4, 1.6875}, {4, 3.0625})] = 0;
  CHECK(failed_checks(mesh) == Names{"subsegments are listed, and nothing else"});
}

TEST_CASE("an input segment whose subsegment was flipped is no chain") {
  PlanarMesh mesh = two_rooms_mesh();
  const Point2 a{2, 1.1875}, b{2, 2.5};
  REQUIRE(flip(mesh, vertex_at(mesh, a), vertex_at(mesh, b)));
  CHECK(failed_checks(mesh) == Names{"input segments are chains of edges"});
}

TEST_CASE("a wrong label of a region is told, of a marker, of a carrier, of a provenance") {
  const PlanarMesh whole = two_rooms_mesh();
  const Index on_wall = vertex_at(whole, {2, 3.3125}), inside = vertex_at(whole, {2.78125, 3.15625}), input = vertex_at(whole, {4, 4});
  PlanarMesh mesh = whole;
  mesh.regions[inner_triangle(mesh)] += 1;
  CHECK(failed_checks(mesh) == Names{"triangles have the labels of their regions"});
  mesh = whole;
  mesh.edge_markers[listed_edge(mesh, {2.5, 1}, {3.5, 1})] = 8;
  CHECK(failed_checks(mesh) == Names{"subsegments have the markers of their segments"});
  for (const Index v : {on_wall, inside, input}) {
    mesh = whole;
    mesh.point_markers[v] = 77;
    CHECK(failed_checks(mesh) == Names{"vertices have their markers"});
    mesh = whole;
    mesh.carriers[v] = {1, 0};
    CHECK(failed_checks(mesh) == Names{"vertices name the input element that they lie on"});
    mesh = whole;
    mesh.provenance[v] = v == input ? LevelIndex{0} : input_level;
    CHECK(failed_checks(mesh) == Names{"vertices name who inserted them"});
  }
}

TEST_CASE("indices out of range, coordinates that are not finite and an empty mesh are told") {
  const Names invalid{"the mesh has triangles, and indices and coordinates are valid"};
  PlanarMesh mesh = two_rooms_mesh();
  mesh.triangles[0][0] = 1000;
  CHECK(failed_checks(mesh) == invalid);
  mesh = two_rooms_mesh();
  mesh.points[3].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(failed_checks(mesh) == invalid);
  mesh = two_rooms_mesh();
  mesh.regions.pop_back();
  CHECK(failed_checks(mesh) == invalid);
  CHECK(failed_checks(PlanarMesh{}) == invalid);
}

TEST_CASE("with circles, subsegments that are encroached or not Delaunay are told unless they are listed") {
  Pslg square;
  square.points = {{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}, {3, 4}, {5, 4}, {3.9375, 4.125}, {4.0625, 3.875}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 0}, {8, 9}};
  const PlanarMesh mesh = triangulated(square);
  PlanarCriteria criteria;
  CHECK(failed(verify_planar(square, mesh, criteria)).empty());
  criteria.circle = true;
  CHECK(failed(verify_planar(square, mesh, criteria)) == Names{"subsegments are Delaunay too", "no subsegment is encroached"});
  criteria.listed = {unmet(Reason::precision, {4, 4})};
  CHECK(failed(verify_planar(square, mesh, criteria)).empty());
}

TEST_CASE("a vertex on the diametral circle does not encroach, one just inside does") {
  Pslg triangle;
  triangle.points = {{0, 0}, {4, 0}, {2, 2}};
  triangle.segments = {{0, 1}, {1, 2}, {2, 0}};
  PlanarCriteria criteria;
  criteria.circle = true;
  CHECK(failed(verify_planar(triangle, triangulated(triangle), criteria)).empty());
  triangle.points[2].y -= 1e-9;
  CHECK(failed(verify_planar(triangle, triangulated(triangle), criteria)) == Names{"no subsegment is encroached"});
}

TEST_CASE("an angle below the bound is a failure, unless it is listed or the run was not complete") {
  Pslg box;
  box.points = {{0, 0}, {10, 0}, {10, 1}, {0, 1}};
  box.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const PlanarMesh mesh = triangulated(box);
  const Names too_small{"no angle is below the bound"};
  PlanarCriteria criteria;
  criteria.min_angle_degrees = 5;
  CHECK(failed(verify_planar(box, mesh, criteria)).empty());
  criteria.min_angle_degrees = 20;
  CHECK(failed(verify_planar(box, mesh, criteria)) == too_small);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point2 p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    criteria.listed.push_back(unmet(Reason::size_floor, {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3}));
  }
  const VerifyReport listed = verify_planar(box, mesh, criteria);
  CHECK(listed.ok());
  CHECK(listed.listed_unmet == 2);
  criteria.listed.pop_back();
  CHECK(verify_planar(box, mesh, criteria).findings.at(19).failures == 1);
  criteria.listed[0].reason = Reason::small_input_angle;  // there is none: that excuse is verified, not believed
  CHECK(verify_planar(box, mesh, criteria).findings.at(19).failures == 2);
  criteria.complete = false;
  const VerifyReport stopped = verify_planar(box, mesh, criteria);
  CHECK(stopped.ok());
  CHECK(stopped.unfinished == 2);
}

namespace {

/// A strip between two straight sides that open from `first_width` to `last_width` over x from 8 to 12, with vertices at equal steps
/// of 1/4 on both; with its sides running on to where they meet in the apex when that is asked for.
std::pair<Pslg, PlanarMesh> strip(double first_width, double last_width, bool with_apex) {
  Pslg p;
  p.points = {{8, -first_width / 2}, {12, -last_width / 2}, {12, last_width / 2}, {8, first_width / 2}};
  p.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  std::vector<Point2> steiner;
  for (double x = 8.25; x < 12; x += 0.25) {
    const double half = (first_width + (last_width - first_width) * (x - 8) / 4) / 2;
    steiner.push_back({x, half});
    steiner.push_back({x, -half});
  }
  if (with_apex) {
    const double apex = 8 - 4 * first_width / (last_width - first_width);
    p.points[0] = p.points[3] = {apex, 0};
    p.points.pop_back();
    p.segments = {{0, 1}, {1, 2}, {2, 0}};
    // the wall between the strip and the corner
    p.points.push_back({8, -first_width / 2});
    p.points.push_back({8, first_width / 2});
    p.segments.push_back({3, 4});
  }
  return {p, triangulated(p, steiner)};
}

}  // namespace

TEST_CASE("an edge that bridges two segments with a small angle excuses its triangle, far from the corner too") {
  // widths of 1/8 to 3/16: the apex is at x = 0, and no edge between x = 8 and 12 is longer than 1
  PlanarCriteria criteria;
  criteria.min_angle_degrees = 35;
  const auto& [wedge, wedge_mesh] = strip(0.125, 0.1875, true);
  const VerifyReport report = verify_planar(wedge, wedge_mesh, criteria);
  INFO(verify_table(report));
  CHECK(report.ok());
  CHECK(report.excused_angles > 10);
  const auto& [box, box_mesh] = strip(0.125, 0.1875, false);
  const VerifyReport same_without_corner = verify_planar(box, box_mesh, criteria);
  INFO(verify_table(same_without_corner));
  CHECK(same_without_corner.findings.at(19).failures > 10);
}

TEST_CASE("a small angle between segments excuses nothing when a hole is in it") {
  Pslg p;
  p.points = {{-8, -8}, {8, -8}, {8, 8}, {-8, 8}, {0, 0}, {4, -0.5}, {4, 0.5}};
  p.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 4}};
  PlanarCriteria criteria;
  criteria.min_angle_degrees = 40;
  CHECK(verify_planar(p, triangulated(p), criteria).excused_angles > 0);
  p.holes = {{3, 0}};
  CHECK(verify_planar(p, triangulated(p), criteria).excused_angles == 0);
}

TEST_CASE("triangles near a small input angle are excused, but not from bounds on their size") {
  Pslg wedge;
  wedge.points = {{0, 0}, {8, 0}, {8, 1}};
  wedge.segments = {{0, 1}, {1, 2}, {2, 0}};
  PlanarCriteria criteria;
  criteria.min_angle_degrees = 20;
  const VerifyReport report = verify_planar(wedge, triangulated(wedge), criteria);
  CHECK(report.ok());
  CHECK(report.excused_angles == 1);
  criteria.max_edge = 4;
  CHECK(failed(verify_planar(wedge, triangulated(wedge), criteria)) == Names{"no edge is longer than the bound"});
}

TEST_CASE("bounds on area, of the domain and of a region, on edges and on size are checked") {
  const Pslg rooms = two_rooms();
  const PlanarMesh mesh = two_rooms_mesh();
  PlanarCriteria criteria;
  criteria.max_area = 0.1;
  CHECK(failed(verify_planar(rooms, mesh, criteria)) == Names{"no area is over its bound"});
  criteria = {};
  criteria.max_edge = 0.5;
  CHECK(failed(verify_planar(rooms, mesh, criteria)) == Names{"no edge is longer than the bound"});
  criteria = {};
  criteria.size = [](Point2 p) { return p.x < 2 ? 10.0 : 0.25; };
  CHECK(failed(verify_planar(rooms, mesh, criteria)) == Names{"no triangle is larger than the sizing field says"});
  criteria.size = [](Point2) { return std::numeric_limits<double>::quiet_NaN(); };
  CHECK(failed(verify_planar(rooms, mesh, criteria)) == Names{"no triangle is larger than the sizing field says"});
  criteria.size = [](Point2) { return 10.0; };
  CHECK(verify_planar(rooms, mesh, criteria).ok());
  Pslg tight = rooms;
  tight.regions[0].max_area = 0.125;
  const VerifyReport report = verify_planar(tight, mesh);
  CHECK(failed(report) == Names{"no area is over its bound"});
  tight.regions[0].max_area = 0;
  tight.regions[1].max_area = 0.125;
  CHECK(verify_planar(tight, mesh).find("no area is over its bound")->failures != report.find("no area is over its bound")->failures);
}

TEST_CASE("the table names what failed and where, counting from the first index of the file") {
  PlanarMesh mesh = two_rooms_mesh();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  const std::string text = verify_table(verify_planar(two_rooms(), mesh));
  CHECK(text.find("FAILED  triangles are counterclockwise: 1 of ") != std::string::npos);
  CHECK(text.find("triangle 4 (vertices ") != std::string::npos);
  CHECK(text.find("The mesh is NOT what was promised.\n") != std::string::npos);
}

TEST_CASE("a verification that is told to stop stops") {
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(verify_planar(two_rooms(), two_rooms_mesh(), {}, Control({}, stop.get_token())), Interrupted);
}
