// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/polyhedral_formats.hpp>

#include "../io/scratch.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Message;
using Catch::Matchers::MessageMatches;
using delref_test::Scratch;
using Polygons = std::vector<std::vector<delref::Plc::Index>>;

namespace {

delref::Plc parse(std::string_view text, delref::TetgenFile kind = delref::TetgenFile::poly) {
  return delref::parse_tetgen_poly(text, "in.poly", kind, []() -> delref::Plc { throw delref::InvalidInput("no separate vertices"); });
}

}  // namespace

TEST_CASE("a polyhedral .poly file with everything in it is read") {
  const delref::Plc plc = parse(
      "# comment\n\n"
      "4 3 2 1 # header\r\n"
      "1 0 0 0  1.5 -2  7\n2, 1, +0, 0, 0, 0, -8\n3 1 1 0 0 0 0\n4 nan -inf 2 0 0 0\n"
      "3 1\n"
      "2 1 5 # a facet with a hole\n3 1 2 3\n4 1 2\n3 4\n1 0.5 0.25 .125\n"
      "1\n2 1 4\n"
      "1 0 -6\n1 3\n"
      "1\n1 0.5 0.25 0.125\n"
      "3\n1 0.1 0.2 0.3 -3 0.5\n2 .5 1. 2 4\n3 1 1 1 2.0 -1\n");
  CHECK(plc.first_index == 1);
  REQUIRE(plc.points.size() == 4);
  CHECK(plc.points[1] == delref::Point3{1, 0, 0});
  CHECK(std::isnan(plc.points[3].x));
  CHECK(plc.points[3].y == -INFINITY);
  CHECK(plc.attribute_count == 2);
  CHECK(plc.attributes == std::vector<double>{1.5, -2, 0, 0, 0, 0, 0, 0});
  CHECK(plc.point_markers == std::vector<int>{7, -8, 0, 0});
  REQUIRE(plc.facets.size() == 3);
  CHECK(plc.facets[0].polygons == Polygons{{0, 1, 2}, {0, 1, 2, 3}});
  CHECK(plc.facets[0].holes == std::vector<delref::Point3>{{0.5, 0.25, 0.125}});
  CHECK(plc.facets[0].marker == 5);
  CHECK(plc.facets[1].polygons == Polygons{{0, 3}});
  CHECK(plc.facets[1].marker == 0);
  CHECK(plc.facets[2].polygons == Polygons{{2}});
  CHECK(plc.facets[2].marker == -6);
  CHECK(plc.holes == std::vector<delref::Point3>{{0.5, 0.25, 0.125}});
  REQUIRE(plc.regions.size() == 3);
  CHECK(plc.regions[0].seed == delref::Point3{0.1, 0.2, 0.3});
  CHECK(plc.regions[0].label == -3);
  CHECK(plc.regions[0].max_volume == 0.5);
  CHECK(plc.regions[1].max_volume == 0);
  CHECK(plc.regions[2].max_volume == 0);
}

TEST_CASE("a facet of a .smesh file is one polygon and a marker") {
  const delref::Plc plc = parse("3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n2 1\n3 0 1 2 9\n3 2 1\n 0\n0\n0\n", delref::TetgenFile::smesh);
  REQUIRE(plc.facets.size() == 2);
  CHECK(plc.facets[0].polygons == Polygons{{0, 1, 2}});
  CHECK(plc.facets[0].marker == 9);
  CHECK(plc.facets[1].polygons == Polygons{{2, 1, 0}});
  CHECK(plc.facets[1].marker == 0);
}

TEST_CASE("vertices of a polyhedral .poly file may stand in a .node file") {
  const Scratch folder;
  const auto poly = folder.write("in.poly", "0\n1 0\n1\n3 1 2 3\n0\n");
  CHECK_THROWS_MATCHES(delref::read_plc(poly), delref::InvalidInput, MessageMatches(ContainsSubstring("has no vertices, and there is no file")));
  const auto node = folder.write("in.node", "3 3\n1 0 0 0\n2 1 0 0\n3 0 1 0.5\n");
  const delref::Plc plc = delref::read_plc(poly).plc;
  CHECK(plc.points.size() == 3);
  CHECK(plc.facets[0].polygons == Polygons{{0, 1, 2}});
  CHECK(delref::read_plc(node).plc.points == plc.points);
  CHECK(delref::domain_dimension(poly) == delref::Dimension::space);
  CHECK(delref::domain_dimension(node) == delref::Dimension::space);
}

TEST_CASE("whether a domain lies in the plane or in space is told without reading it") {
  const Scratch folder;
  CHECK(delref::domain_dimension(folder.write("a.poly", "# square\n4 2 0 1\n")) == delref::Dimension::plane);
  CHECK(delref::domain_dimension(folder.write("b.poly", "8 3\n")) == delref::Dimension::space);
  CHECK(delref::domain_dimension(folder.write("c.node", "8\n")) == delref::Dimension::plane);
  CHECK(delref::domain_dimension("no.geojson") == delref::Dimension::plane);
  CHECK(delref::domain_dimension("no.OFF") == delref::Dimension::space);
  CHECK_THROWS_MATCHES(delref::domain_dimension(folder.write("d.poly", "8 4\n")), delref::InvalidInput,
                       MessageMatches(ContainsSubstring("the dimension is 4; it can be 2 or 3")));
  CHECK_THROWS_MATCHES(delref::domain_dimension("a.dxf"), delref::InvalidInput, MessageMatches(ContainsSubstring("\".dxf\" is not the extension of a domain")));
}

TEST_CASE("broken polyhedral .poly files are refused with the line and what was expected") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "in.poly, line 1: the file ends where the number of vertices was expected"},
      {"1 2 0 0\n0 0 0 0\n", "in.poly, line 1: the dimension is 2; polyhedral files have 3"},
      {"1000000000000 3 0 0\n", "in.poly, line 1: the number of vertices is 1000000000000, but only 7 bytes follow"},
      {"1 3\n0 0 0\n", "in.poly, line 2: the line ends where the z coordinate of vertex 0 was expected"},
      {"1 3\n0 0 0 1e999\n", "in.poly, line 2: the z coordinate of vertex 0 is 1e999, which no double can hold"},
      {"1 3\n0 0 0 0\n", "in.poly, line 3: the file ends where the number of facets was expected"},
      {"1 3\n0 0 0 0\n1000000000000 1\n", "in.poly, line 3: the number of facets is 1000000000000, but only 3 bytes follow"},
      {"1 3\n0 0 0 0\n1 0\n999999 0 0\n", "in.poly, line 4: the number of polygons of a facet is 999999, but only 5 bytes follow"},
      {"1 3\n0 0 0 0\n1 0\n1\n99999 0\n", "in.poly, line 5: the number of corners of a polygon is 99999, but only 3 bytes follow"},
      {"1 3\n0 0 0 0\n1 0\n1\n0 0\n", "in.poly, line 5: a polygon of facet 0 has no corners"},
      {"1 3\n1 0 0 0\n1 0\n1\n2 1 0\n", "in.poly, line 5: a corner of a polygon of facet 1 is vertex 0, but vertices are numbered from 1"},
      {"1 3\n1 0 0 0\n1 0\n1\n3 1 1\n", "in.poly, line 6: the file ends where a corner of a polygon of facet 1 was expected"},
      {"1 3\n0 0 0 0\n0\n0\n1\n1 0 0 0 1.5\n",
       "in.poly, line 6: the attribute of region 1 is 1.5; it is the label of the region and must be an integer of 32 bits"},
      {"1 3\n0 0 0 0\n0\n0\n1\n1 0 0 0 1 nan\n", "in.poly, line 6: the volume bound of region 1 is not a number"},
      {"1 3\n0 0 0 0\n0\n0\n0\n5\n", "in.poly, line 6: more follows after the last region; is one of the numbers of records too small?"},
  }));
  CHECK_THROWS_MATCHES(parse(text), delref::InvalidInput, Message(message));
}
