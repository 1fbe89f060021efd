// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification against inputs with peculiarities, and for coordinates of every size.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/verify_planar.hpp>

#include "test_mesh.hpp"

using namespace delref;
using namespace delref::testing_mesh;
using Names = std::vector<std::string>;

namespace {

Pslg unit_square() {
  Pslg p;
  p.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  p.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return p;
}

std::string problem_of(const Pslg& input) {
  const VerifyReport report = verify_planar(input, triangulated(unit_square()));
  return failed(report) == Names{"the input describes a domain"} ? report.find("the input describes a domain")->places.at(0) : "";
}

}  // namespace

TEST_CASE("repeated vertices, segments of length zero and repeated segments are the same as none") {
  Pslg p = unit_square();
  p.points.push_back({1, 1});
  p.segments = {{0, 1}, {1, 4}, {2, 3}, {3, 0}, {2, 4}, {1, 0}};
  p.segment_markers = {1, 2, 3, 4, 5, 6};
  CHECK(failed(verify_planar(p, triangulated(p))).empty());
  PlanarMesh mesh = triangulated(p);
  for (int& marker : mesh.edge_markers)
    if (marker == 1) marker = 6;  // either of the two that lie there
  CHECK(failed(verify_planar(p, mesh)).empty());
}

TEST_CASE("a vertex inside a segment cuts it, and must be in the mesh") {
  Pslg p = unit_square();
  p.points.insert(p.points.end(), {{0.5, 0}, {0.5, 0.25}, {0.25, 1}});
  p.segments.push_back({4, 5});
  CHECK(failed(verify_planar(p, triangulated(p, {{0.75, 0}, {0.375, 0}}))).empty());
  CHECK(failed(verify_planar(p, triangulated(unit_square()))) == Names{"input vertices are in the mesh, once"});
}

TEST_CASE("a mesh of input that was split may name the segments of the original") {
  Pslg split;  // of a square with both diagonals
  split.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}};
  split.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 2}, {1, 4}, {4, 3}};
  PlanarMesh mesh = triangulated(split);
  PlanarCriteria criteria;
  criteria.segment_names = {0, 1, 2, 3, 4, 4, 5, 5};
  criteria.point_names = {0, 1, 2, 3, Carrier::none};
  for (PlanarMesh::Index& i : mesh.edge_segments) i = criteria.segment_names[i];
  for (Carrier& c : mesh.carriers) c.index = criteria.point_names[c.index];
  CHECK(failed(verify_planar(split, mesh, criteria)).empty());
  CHECK(failed(verify_planar(split, mesh)) ==
        Names{"subsegments are listed, and nothing else", "vertices name the input element that they lie on"});
  criteria.segment_names.pop_back();
  CHECK(failed(verify_planar(split, mesh, criteria)) == Names{"the input is usable"});
}

TEST_CASE("what lies outside the domain may be absent") {
  Pslg p = unit_square();
  p.points.insert(p.points.end(), {{3, 3}, {4, 5}, {2, 2}, {0.25, 0.25}, {0.75, 0.25}, {0.5, 0.75}, {0.5, 0.375}, {0.5, 0.5}});
  p.segments.insert(p.segments.end(), {{4, 5}, {7, 8}, {8, 9}, {9, 7}, {10, 11}});
  p.holes = {{0.375, 0.3125}};
  const PlanarMesh mesh = triangulated(p);
  CHECK(mesh.points.size() == 7);
  CHECK(failed(verify_planar(p, mesh)).empty());
}

TEST_CASE("a segment that runs from inside the domain to outside is needed inside only") {
  Pslg p = unit_square();
  p.points.insert(p.points.end(), {{0.5, 0.5}, {1, 0.5}, {2, 0.5}});
  p.segments.push_back({4, 6});
  CHECK(failed(verify_planar(p, triangulated(p))).empty());
  PlanarMesh mesh = triangulated(p);
  mesh.edge_segments.clear();
  CHECK(failed(verify_planar(p, mesh)).empty());
}

TEST_CASE("a hole that touches the boundary at a vertex is a hole") {
  Pslg p = unit_square();
  p.points.insert(p.points.end(), {{0.75, 0.25}, {0.25, 0.5}});
  p.segments.insert(p.segments.end(), {{0, 4}, {4, 5}, {5, 0}});
  p.holes = {{0.25, 0.1875}};
  CHECK(failed(verify_planar(p, triangulated(p))).empty());
  Pslg filled = p;
  filled.holes.clear();
  CHECK(failed(verify_planar(p, triangulated(filled))) == Names{"the triangles cover the domain, once"});
  CHECK(failed(verify_planar(filled, triangulated(p))) == Names{"the triangles cover the domain, once"});
}

TEST_CASE("input that describes no domain is told in words") {
  Pslg p = unit_square();
  p.segments.push_back({0, 2});
  p.segments.push_back({1, 3});
  CHECK(problem_of(p) == "segment 5 crosses another one; a mesh is verified against input that was split at its crossings");
  p = unit_square();
  p.segments.pop_back();
  CHECK(problem_of(p) == "the segments and holes of the input leave no bounded region");
  p = unit_square();
  p.holes = {{0.5, 0}};
  CHECK(problem_of(p) == "the hole seed at (0.5, 0) lies on a segment, so it marks neither side");
  p.points = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  p.holes.clear();
  CHECK(problem_of(p) == "all points of the input lie on a line: it has no area");
  p = unit_square();
  p.segments[2][0] = 9;
  CHECK(failed(verify_planar(p, triangulated(unit_square()))) == Names{"the input is usable"});
}

TEST_CASE("scaling by a power of two changes no finding, from 1e-150 to 1e150") {
  for (const int exponent : {-498, -100, 100, 498}) {
    Pslg p = two_rooms();
    PlanarMesh mesh = two_rooms_mesh();
    const auto scale = [&](Point2& q) { q = {std::ldexp(q.x, exponent), std::ldexp(q.y, exponent)}; };
    for (Point2& q : p.points) scale(q);
    for (Point2& q : p.holes) scale(q);
    for (Pslg::Region& r : p.regions) {
      scale(r.seed);
      r.max_area = std::ldexp(r.max_area, 2 * exponent);
    }
    for (Point2& q : mesh.points) scale(q);
    PlanarCriteria criteria;
    criteria.max_edge = std::ldexp(3, exponent);
    criteria.size = [&](Point2 q) { return q.x >= 0 ? std::ldexp(3, exponent) : 0; };
    CHECK(failed(verify_planar(p, mesh, criteria)).empty());
    criteria.max_edge = std::ldexp(0.5, exponent);
    CHECK(failed(verify_planar(p, mesh, criteria)) == Names{"no edge is longer than the bound"});
  }
}

TEST_CASE("a mesh at an offset of 1e9 is verified, its vertices within the ulp of that size") {
  const auto shifted = [](Point2 q) { return Point2{q.x + 1e9, q.y + 1e9}; };
  Pslg p = unit_square();
  p.points[2] = {0.8, 0.9};
  for (Point2& q : p.points) q = shifted(q);
  CHECK(failed(verify_planar(p, triangulated(p))).empty());
}

TEST_CASE("the distance of a vertex from a segment far from the origin is measured to a fraction of an ulp") {
  const Point2 a{1e9, 1e9}, b{1e9 + 1, 1e9 + 3};
  const verification::SegmentLine line(a, b);
  CHECK(line.distance({1e9 + 0.5, 1e9 + 1.5}) == 0);
  CHECK(line.distance({1e9 + 0.5, 1e9 + 1.5 + verification::ulp(1e9)}) < verification::ulp(1e9));
  CHECK(line.distance({1e9 + 0.5, 1e9 + 1.5 + verification::ulp(1e9)}) > 0.3 * verification::ulp(1e9));
}

TEST_CASE("the nearest of some points is found") {
  std::vector<Point2> points;
  for (int i = 0; i < 100; ++i) points.push_back({std::fmod(i * 0.37, 1), std::fmod(i * 0.61, 1)});
  const verification::NearestPoint nearest(points);
  for (int i = 0; i < 50; ++i) {
    const Point2 place{std::fmod(i * 0.73, 1.5), std::fmod(i * 0.11, 1.5)};
    double best = 100;
    for (const Point2 p : points) best = std::min(best, squared_distance(p, place));
    CHECK(nearest.squared_distance_from(place) == best);
  }
  CHECK(std::isinf(verification::NearestPoint<Point2>({}).squared_distance_from({0, 0})));
}
