// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of bad complex is refused or mended in words that name the elements, and a valid one becomes the domain that it
// describes.
#include <cmath>
#include <limits>
#include <set>
#include <stop_token>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "complexes.hpp"

using namespace delref;
using namespace complexes;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A box passes the check unchanged: twelve segments, six facets of two triangles, no small angle, no note") {
  const PolyhedralDomain domain = check_plc(box());
  CHECK(domain.points == box().points);
  CHECK(domain.segments.size() == 12);
  REQUIRE(domain.facets.size() == 6);
  for (std::size_t f = 0; f < 6; ++f) {
    CHECK(domain.facets[f].triangles.size() == 2);
    CHECK(domain.facets[f].segments.size() == 4);
    CHECK(domain.facets[f].marker == static_cast<int>(f) + 1);
    CHECK(domain.facets[f].original == f);
    CHECK(domain.facets[f].gabriel);
    CHECK(area(domain, domain.facets[f]) == 1);
    CHECK(cross(domain.facets[f].frame.u, domain.facets[f].frame.v) == domain.facets[f].frame.normal);
  }
  CHECK(domain.small_angles.empty());
  CHECK(domain.notes.empty());
  CHECK(domain.isolated.empty());
  CHECK(domain.scale == 0);
}

TEST_CASE("Input without vertices, without facets, flat or on one line is refused") {
  CHECK_THAT(refusal(Plc{}), ContainsSubstring("no vertices"));
  Plc plc = box();
  plc.facets.clear();
  CHECK_THAT(refusal(plc), ContainsSubstring("8 vertices but no facets"));
  Plc flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.facets = {facet({{0, 1, 2, 3}})};
  CHECK_THAT(refusal(flat), ContainsSubstring("all 4 vertices lie in one plane"));
  flat.points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  CHECK_THAT(refusal(flat), ContainsSubstring("one straight line"));
  flat.points = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}};
  CHECK_THAT(refusal(flat), ContainsSubstring("only 2 vertices"));
}

TEST_CASE("A number that is none is refused with its vertex, and seeds are looked at too") {
  Plc plc = box();
  plc.first_index = 1;
  plc.points[6].x = std::numeric_limits<double>::quiet_NaN();
  plc.points[7].y = std::numeric_limits<double>::infinity();
  const std::string text = refusal(plc);
  CHECK_THAT(text, ContainsSubstring("vertex 7 at (nan, 1, 1): a coordinate is not a number"));
  CHECK_THAT(text, ContainsSubstring("vertex 8 at (0, inf, 1): a coordinate is infinite"));
  plc = box();
  plc.holes = {{0.5, 0.5, std::numeric_limits<double>::infinity()}};
  plc.regions = {{{0.5, 0.5, 0.5}, 4, -1}};
  CHECK_THAT(refusal(plc), ContainsSubstring("the seed of hole 0") && ContainsSubstring("region 0 (label 4)"));
}

TEST_CASE("A wrong index is refused with the facet or segment, the index and the allowed range") {
  Plc plc = box();
  plc.facets[2].polygons[0][1] = 99;
  plc.segments = {{0, 8}};
  const std::string text = refusal(plc);
  CHECK_THAT(text, ContainsSubstring("facet 2 refers to vertex 99, which does not exist: vertices are numbered from 0 to 7"));
  CHECK_THAT(text, ContainsSubstring("segment 0 refers to vertex 8"));
}

TEST_CASE("Polygons that are empty or pass twice through a vertex are refused") {
  Plc plc = box();
  plc.facets[0].polygons[0] = {0, 3, 2, 0, 1};
  plc.facets[1].polygons.clear();
  plc.facets[2].polygons.push_back({});
  const std::string text = refusal(plc);
  CHECK_THAT(text, ContainsSubstring("facet 0: a polygon passes twice through vertex 0 at (0, 0, 0)"));
  CHECK_THAT(text, ContainsSubstring("facet 1 has no polygon"));
  CHECK_THAT(text, ContainsSubstring("facet 2 has a polygon without vertices"));
}

TEST_CASE("A polygon that repeats its first vertex at its end is that polygon") {
  Plc plc = box();
  plc.facets[0].polygons[0] = {0, 3, 2, 1, 1, 0};
  CHECK(check_plc(plc).facets[0].segments.size() == 4);
}

TEST_CASE("Equal vertices are merged and told, and with a tolerance close ones") {
  Plc plc = box();
  plc.points.push_back({1, 1, 1});
  plc.facets[1].polygons[0] = {4, 5, 8, 7};
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.points.size() == 8);
  CHECK(domain.segments.size() == 12);
  CHECK_THAT(notes(domain), ContainsSubstring("vertex 8 with vertex 6 at (1, 1, 1)"));
  plc.points[8].z += 1e-7;
  CHECK_THAT(refusal(plc), ContainsSubstring("open"));
  CHECK_THAT(refusal(plc), ContainsSubstring("merge tolerance"));
  PlcOptions options;
  options.merge_tolerance = 1e-6;
  CHECK(check_plc(plc, options).points.size() == 8);
}

TEST_CASE("Vertices that lie absurdly close are told and kept") {
  Plc plc = box();
  add_box(plc, {0, 0, 1 + 1e-10}, {1, 1, 2});
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.points.size() == 16);
  CHECK_THAT(notes(domain), ContainsSubstring("4 vertices lie nearer than") && ContainsSubstring("merge tolerance"));
}

TEST_CASE("A facet that is there twice is dropped when the markers agree, and refused when a label would be lost") {
  Plc plc = box();
  plc.facets.push_back(facet({{1, 2, 3, 0}}, 1));
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.facets.size() == 6);
  CHECK_THAT(notes(domain), ContainsSubstring("facet 6 (vertices 0, 1, 2 and 3) repeats facet 0"));
  plc.facets[0].marker = 0;
  CHECK(check_plc(plc).facets[0].marker == 1);
  plc.facets[0].marker = 7;
  CHECK_THAT(refusal(plc), ContainsSubstring("with marker 1 instead of 7"));
}

TEST_CASE("Facets that merging collapses are left out and told") {
  Plc plc = box();
  plc.points.push_back({0, 0, 0});
  plc.facets.push_back(facet({{0, 8, 1}}));
  plc.facets.push_back(facet({{2, 3, 2, 0}}));
  CHECK_THAT(refusal(plc), ContainsSubstring("passes twice"));
  plc.facets.pop_back();
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.facets.size() == 6);
  CHECK_THAT(notes(domain), ContainsSubstring("facet 6"));
}

TEST_CASE("A triangle without area is left out, and what it joined is cut") {
  Plc plc = box();
  plc.points.push_back({0.5, 0, 0});
  plc.facets[0].polygons[0] = {0, 3, 2, 1, 8};
  plc.facets.push_back(facet({{0, 8, 1}}));
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.facets.size() == 6);
  CHECK(domain.segments.size() == 13);
  CHECK(domain.facets[2].segments.size() == 5);
  CHECK_THAT(notes(domain), ContainsSubstring("1 facet without area") && ContainsSubstring("at vertex 8"));
}

TEST_CASE("A facet that is not planar is refused with its vertex and distance, and taken within the tolerance") {
  Plc plc = box();
  plc.points[6].z = 1.2;
  CHECK_THAT(refusal(plc),
             ContainsSubstring("facet 1 (vertices 4, 5, 6 and 7) is not planar") && ContainsSubstring("off its plane"));
  plc.points[6].z = 1 + 1e-6;
  CHECK(refusal(plc).empty());
  PlcOptions strict;
  strict.planarity_tolerance = 1e-8;
  CHECK_THAT(refusal(plc, strict), ContainsSubstring("not planar"));
}

TEST_CASE("Segments are cut where a vertex lies on them, whatever the direction") {
  const auto seed = GENERATE(0u, 1u, 2u, 3u, 4u);
  Plc plc = box();
  plc.points.push_back({0.3, 0.3, 0.3});
  plc.points.push_back({0.7, 0.7, 0.7});
  plc.segments = {{0, 6}, {8, 9}};
  plc.segment_markers = {5, 0};
  if (seed > 0) plc = moved(plc, seed, 1, 3);
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.segments.size() == 15);
  std::multiset<int> markers;
  for (const auto& segment : domain.segments) markers.insert(segment.marker);
  CHECK(markers.count(5) == 3);
  CHECK_THAT(notes(domain), ContainsSubstring("vertices 0 and 6") && ContainsSubstring("at vertex 8"));
}

TEST_CASE("A facet with a hole, a slit and a vertex in it is triangulated with all of them") {
  Plc plc = box({0, 0, 0}, {4, 4, 4});
  plc.points.insert(plc.points.end(), {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {3, 3, 0}, {3.5, 3.5, 0}, {3, 1, 0}});
  plc.points.insert(plc.points.end(), {{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}});
  plc.facets[0].polygons.insert(plc.facets[0].polygons.end(), {{8, 9, 10, 11}, {12, 13}, {14}});
  plc.facets[0].holes = {{1.5, 1.5, 0}};
  for (Plc::Index i = 0; i < 4; ++i) plc.facets.push_back(facet({{8 + i, 8 + (i + 1) % 4, 15 + (i + 1) % 4, 15 + i}}));
  plc.facets.push_back(facet({{15, 16, 17, 18}}));
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.facets[0].segments.size() == 9);
  CHECK(area(domain, domain.facets[0]) == Approx(15));
  std::set<Plc::Index> used;
  for (const auto& triangle : domain.facets[0].triangles) used.insert(triangle.begin(), triangle.end());
  CHECK(used.size() == 11);
  CHECK(domain.notes.empty());
  plc.facets[0].holes.clear();  // what is enclosed is in
  CHECK(area(check_plc(plc), check_plc(plc).facets[0]) == Approx(16));
}

TEST_CASE("A hole point outside its facet removes nothing and is told") {
  Plc plc = box();
  plc.facets[0].holes = {{9, 9, 0}};
  CHECK_THAT(notes(check_plc(plc)), ContainsSubstring("the hole point (9, 9, 0) of facet 0"));
  plc.facets[0].holes = {{0.5, 0.25, 0}};
  CHECK_THAT(refusal(plc), ContainsSubstring("facet 0") && ContainsSubstring("its hole points remove all of it"));
}

TEST_CASE("A facet whose polygons cross is refused with both sides") {
  Plc plc = box({0, 0, 0}, {4, 4, 4});
  plc.points.insert(plc.points.end(), {{1, 1, 0}, {3, 3, 0}, {1, 3, 0}, {3, 1, 0}});
  plc.facets[0].polygons.insert(plc.facets[0].polygons.end(), {{8, 9}, {10, 11}});
  CHECK_THAT(refusal(plc), ContainsSubstring("facet 0: the segment of vertices") && ContainsSubstring("crosses"));
}

TEST_CASE("Facets that are only segments become segments") {
  Plc plc = box();
  plc.points.insert(plc.points.end(), {{0.3, 0.4, 0.5}, {0.6, 0.5, 0.4}, {0.5, 0.8, 0.4}});
  plc.facets.push_back(facet({{8, 9}}));
  plc.facets.push_back(facet({{9, 10}, {10}}));
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.facets.size() == 6);
  CHECK(domain.segments.size() == 14);
}

TEST_CASE("A vertex that nothing names is isolated, or belongs to the facet in which it lies") {
  const auto seed = GENERATE(0u, 1u, 2u);
  Plc plc = box();
  plc.points.insert(plc.points.end(), {{0.5, 0.5, 0.5}, {0.25, 0.75, 0}, {2, 2, 2}});
  if (seed > 0) plc = moved(plc, seed, 1, 1);
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.isolated == std::vector<Plc::Index>{8, 10});
  CHECK(domain.facets[0].triangles.size() == 4);
  CHECK_THAT(notes(domain), ContainsSubstring("vertex 9") && ContainsSubstring("facet 0"));
}

TEST_CASE("Facets that cross, overlap or touch are refused with their vertices and the place") {
  Plc plc = box();
  SECTION("crossing boxes") {
    add_box(plc, {0.5, 0.5, 0.5}, {1.5, 1.5, 1.5});
    CHECK_THAT(refusal(plc),
               ContainsSubstring("facet 1 (vertices 4, 5, 6 and 7) and facet 8") && ContainsSubstring("cross at (1, 0.5, 1)"));
  }
  SECTION("overlapping facets") {
    add_box(plc, {0.25, 0.25, 1}, {0.75, 0.75, 2});
    CHECK_THAT(refusal(plc), ContainsSubstring("facet 1") && ContainsSubstring("overlap"));
  }
  SECTION("a vertex in a facet") {
    plc.points.insert(plc.points.end(), {{0.5, 0.5, 1}, {0.5, 0.6, 2}, {0.6, 0.5, 2}});
    plc.facets.push_back(facet({{8, 9, 10}}));
    CHECK_THAT(refusal(plc), ContainsSubstring("vertex 8 at (0.5, 0.5, 1) of facet 6") && ContainsSubstring("lies in facet 1"));
  }
  SECTION("a segment through a facet") {
    plc.points.insert(plc.points.end(), {{0.5, 0.5, 0.5}, {0.5, 0.5, 2}});
    plc.segments = {{8, 9}};
    CHECK_THAT(refusal(plc), ContainsSubstring("vertices 8 and 9") && ContainsSubstring("meets facet 1"));
  }
  SECTION("segments that cross") {
    plc.points.insert(plc.points.end(), {{0.25, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.25, 0.75, 0.5}, {0.75, 0.25, 0.5}});
    plc.segments = {{8, 9}, {10, 11}};
    CHECK_THAT(refusal(plc), ContainsSubstring("vertices 8 and 9") && ContainsSubstring("vertices 10 and 11"));
  }
}

TEST_CASE("Boxes that share a face, an edge, a vertex or nothing are valid, in any position") {
  const auto seed = GENERATE(0u, 1u, 2u, 3u);
  const auto low = GENERATE(Point3{1, 0, 0}, Point3{1, 1, 0}, Point3{1, 1, 1}, Point3{2, 1, 1}, Point3{1 + 1e-6, 0, 0});
  const auto [scale, offset] = GENERATE(std::pair(1.0, 0.0), std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e6));
  Plc plc = box();
  add_box(plc, low, low + Vector3{1, 1, 1});
  if (low == Point3{1, 0, 0}) plc.facets.pop_back();  // would repeat the face with another marker
  // Equal corners must stay equal when they are rounded.
  const Plc placed = seed == 0 ? plc : moved(plc, seed, scale, offset);
  const PolyhedralDomain domain = check_plc(placed);
  CHECK(domain.small_angles.empty());
  CHECK(domain.facets.size() == plc.facets.size());
  PlcOptions join;
  join.join_coplanar_degrees = 0.01;
  CHECK(check_plc(moved(in_triangles(plc), seed, scale, offset), join).facets.size() == plc.facets.size());
}

TEST_CASE("An open surface is refused with its boundary; facets that hang free are told when others enclose something") {
  Plc plc = box();
  plc.facets.pop_back();
  CHECK_THAT(refusal(plc), ContainsSubstring("open") &&
                               ContainsSubstring("4 segments have a facet on one side only, in 1 chain") &&
                               ContainsSubstring("vertices 0, 3, 7 and 4"));
  plc = box();
  plc.points.insert(plc.points.end(), {{0.2, 0.2, 0.2}, {0.8, 0.2, 0.3}, {0.2, 0.8, 0.3}});
  plc.facets.push_back(facet({{8, 9, 10}}));
  CHECK_THAT(notes(check_plc(plc)), ContainsSubstring("1 facet has a free side") && ContainsSubstring("facet 6"));
}

TEST_CASE("Coplanar neighbours are joined by option, but for markers, listed segments and bends") {
  PlcOptions join;
  join.join_coplanar_degrees = 0.1;
  const auto seed = GENERATE(0u, 1u, 2u);
  const Plc triangles = moved(in_triangles(box()), seed, 1, 1);
  CHECK(check_plc(triangles).facets.size() == 12);
  const PolyhedralDomain domain = check_plc(triangles, join);
  REQUIRE(domain.facets.size() == 6);
  CHECK(domain.segments.size() == 12);
  for (const auto& f : domain.facets) {
    CHECK(area(domain, f) == Approx(1));
    CHECK(f.segments.size() == 4);
  }
  CHECK_THAT(notes(domain), ContainsSubstring("12 facets were joined with coplanar neighbours into 6"));
  Plc marked = triangles;
  marked.facets[0].marker = 77;
  CHECK(check_plc(marked, join).facets.size() == 7);
  Plc listed = triangles;
  listed.segments = {{0, 2}};
  CHECK(check_plc(listed, join).facets.size() == 6);
  CHECK(check_plc(listed, join).segments.size() == 13);
}

TEST_CASE("A joined facet keeps its opening and its inner vertices, and a curved surface does not become one facet") {
  PlcOptions join;
  join.join_coplanar_degrees = 1;
  Plc frame = box({0, 0, 0}, {3, 3, 1});  // a box with a square tunnel, its lids as four trapezoids each
  frame.points.insert(frame.points.end(),
                      {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}});
  frame.facets.erase(frame.facets.begin(), frame.facets.begin() + 2);
  for (const Plc::Index z : {0u, 4u})
    for (Plc::Index i = 0; i < 4; ++i) frame.facets.push_back(facet({{z + i, z + (i + 1) % 4, z + 8 + (i + 1) % 4, z + 8 + i}}));
  for (Plc::Index i = 0; i < 4; ++i) frame.facets.push_back(facet({{8 + i, 8 + (i + 1) % 4, 12 + (i + 1) % 4, 12 + i}}));
  const PolyhedralDomain domain = check_plc(frame, join);
  CHECK(domain.facets.size() == 10);
  double total = 0;
  for (const auto& f : domain.facets) total += area(domain, f);
  CHECK(total == Approx(2 * 8 + 12 + 4));

  Plc prism;  // of 720 sides, which bend by half a degree
  const Plc::Index n = 720;
  for (const double z : {0.0, 1.0})
    for (Plc::Index i = 0; i < n; ++i)
      prism.points.push_back({std::cos(6.283185307179586 * i / n), std::sin(6.283185307179586 * i / n), z});
  std::vector<Plc::Index> lid(n);
  for (Plc::Index i = 0; i < n; ++i) lid[i] = i;
  prism.facets.push_back(facet({lid}));
  for (Plc::Index& v : lid) v += n;
  prism.facets.push_back(facet({lid}));
  for (Plc::Index i = 0; i < n; ++i) prism.facets.push_back(facet({{i, (i + 1) % n, n + (i + 1) % n, n + i}}));
  const std::size_t count = check_plc(prism, join).facets.size();
  CHECK(count > 300);
  join.planarity_tolerance = 1e-2;
  CHECK(check_plc(prism, join).facets.size() < count);
}

TEST_CASE("A wedge lists its dihedral angle and its sharp segments, and only its slanted facets are not Gabriel") {
  const double degrees = GENERATE(80.0, 45.0, 5.0);
  const double angle = degrees * 3.141592653589793 / 180;
  Plc plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0},
                {0, 0, 1}, {1, 0, 1}, {std::cos(angle), std::sin(angle), 1}};
  plc.facets = {facet({{0, 1, 2}}), facet({{3, 4, 5}}), facet({{0, 1, 4, 3}}), facet({{1, 2, 5, 4}}), facet({{2, 0, 3, 5}})};
  const PolyhedralDomain domain = check_plc(plc);
  const auto found =
      std::ranges::find(domain.small_angles, PolyhedralDomain::SmallAngle::Kind::facets, &PolyhedralDomain::SmallAngle::kind);
  REQUIRE(found != domain.small_angles.end());
  const auto apex = std::ranges::find_if(domain.small_angles, [](const auto& a) {
    return a.kind == PolyhedralDomain::SmallAngle::Kind::facets && a.elements == std::array<Plc::Index, 2>{2, 4};
  });
  REQUIRE(apex != domain.small_angles.end());
  CHECK(apex->degrees == Approx(degrees));
  CHECK(apex->place == Point3{0, 0, 0.5});
  CHECK(domain.facets[0].gabriel);
  CHECK(domain.facets[1].gabriel);
  CHECK_FALSE(domain.facets[2].gabriel);
  CHECK_FALSE(domain.facets[4].gabriel);
  CHECK(std::ranges::is_sorted(domain.small_angles, {}, &PolyhedralDomain::SmallAngle::degrees));
  // Cut into triangles it has the same angles between facets.
  const PolyhedralDomain cut = check_plc(in_triangles(plc));
  CHECK(
      std::ranges::count(cut.small_angles, PolyhedralDomain::SmallAngle::Kind::segments, &PolyhedralDomain::SmallAngle::kind) ==
      std::ranges::count(domain.small_angles, PolyhedralDomain::SmallAngle::Kind::segments, &PolyhedralDomain::SmallAngle::kind));
}

TEST_CASE("A segment that rises from a facet is listed with it, also where the facet's triangulation has an edge under it") {
  Plc plc = box();
  plc.points.push_back({0.5, 0.5, 0.25});
  plc.segments = {{0, 8}};
  const auto seed = GENERATE(0u, 1u, 2u);
  const PolyhedralDomain domain = check_plc(moved(plc, seed, 1, 0));
  REQUIRE(domain.small_angles.size() >= 3);
  const auto to_facets = std::ranges::count(domain.small_angles, PolyhedralDomain::SmallAngle::Kind::segment_and_facet,
                                            &PolyhedralDomain::SmallAngle::kind);
  CHECK(to_facets == 3);
  CHECK(domain.small_angles.front().degrees == Approx(std::atan2(0.25, std::sqrt(0.5)) * 180 / 3.141592653589793));
}

TEST_CASE("Facets around an edge are listed pairwise with their neighbours only") {
  Plc plc = box({-2, -2, -2}, {2, 2, 2});
  plc.points.insert(plc.points.end(), {{0, 0, -1}, {0, 0, 1}});
  for (int k = 0; k < 6; ++k) {
    const double angle = k * 10 * 3.141592653589793 / 180;
    const auto v = static_cast<Plc::Index>(plc.points.size());
    plc.points.push_back({std::cos(angle), std::sin(angle), -1});
    plc.points.push_back({std::cos(angle), std::sin(angle), 1});
    plc.facets.push_back(facet({{8, v, v + 1, 9}}));
  }
  const PolyhedralDomain domain = check_plc(plc);
  std::size_t count = 0;
  for (const auto& small : domain.small_angles)
    if (small.kind == PolyhedralDomain::SmallAngle::Kind::facets) {
      ++count;
      CHECK(small.degrees == Approx(10));
    }
  CHECK(count == 5);
}

TEST_CASE("Coordinates of any magnitude are scaled exactly, and messages speak the unit of the input") {
  const double unit = GENERATE(1e-150, 1e-30, 1e30, 1e150);
  Plc plc = box({0, 0, 0}, {unit, unit, unit});
  plc.regions = {{{unit / 2, unit / 2, unit / 2}, 1, 0}};
  const PolyhedralDomain domain = check_plc(plc);
  CHECK(domain.scale != 0);
  CHECK(std::ldexp(domain.points[6].x, -domain.scale) == unit);
  CHECK(std::ldexp(domain.regions[0].seed.x, -domain.scale) == unit / 2);
  CHECK(domain.small_angles.empty());
  plc.facets.pop_back();
  plc.points[3] = {0, 2 * unit, 0};
  CHECK_THAT(refusal(plc), ContainsSubstring("(0, " + describe(unit)) || ContainsSubstring("(0, " + describe(2 * unit)));
}

TEST_CASE("The check ends when it is told to") {
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(check_plc(box(), {}, Control({}, source.get_token())), Interrupted);
}

TEST_CASE("Options out of range are refused") {
  PlcOptions options;
  options.merge_tolerance = -1;
  CHECK_THAT(refusal(box(), options), ContainsSubstring("merge tolerance"));
  options = {};
  options.planarity_tolerance = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(box(), options), ContainsSubstring("planarity tolerance"));
  options = {};
  options.join_coplanar_degrees = 90;
  CHECK_THAT(refusal(box(), options), ContainsSubstring("90 degrees"));
}
