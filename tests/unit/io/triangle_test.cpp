// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/triangle_mesh.hpp>

#include "scratch.hpp"

using Catch::Matchers::Message;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::ContainsSubstring;
using delref_test::Scratch;

namespace {

delref::Pslg parse(std::string_view text) {
  return delref::parse_triangle_poly(text, "in.poly", []() -> delref::Pslg { throw delref::InvalidInput("no separate vertices"); });
}

}  // namespace

TEST_CASE("a .poly file with everything in it is read") {
  const delref::Pslg pslg = parse(
      "# comment\n\n"
      "4 2 2 1 # header\r\n"
      "1 0 0  1.5 -2  7\n2, 1, +0, 0, 0, -8\n3 1 1 0 0 0\n4 nan -inf 0 0 0\n"
      "2 1\n1 1 2 5\n2 4 1 -6\n"
      "1\n1 0.5 0.25\n"
      "3\n1 0.1 0.2 -3 0.5\n2 .5 1. 4\n3 1 1 2.0 -1\n");
  CHECK(pslg.first_index == 1);
  REQUIRE(pslg.points.size() == 4);
  CHECK(pslg.points[1] == delref::Point2{1, 0});
  CHECK(std::isnan(pslg.points[3].x));
  CHECK(pslg.points[3].y == -INFINITY);
  CHECK(pslg.attribute_count == 2);
  CHECK(pslg.attributes == std::vector<double>{1.5, -2, 0, 0, 0, 0, 0, 0});
  CHECK(pslg.point_markers == std::vector<int>{7, -8, 0, 0});
  CHECK(pslg.segments == std::vector<std::array<delref::Pslg::Index, 2>>{{0, 1}, {3, 0}});
  CHECK(pslg.segment_markers == std::vector<int>{5, -6});
  CHECK(pslg.holes == std::vector<delref::Point2>{{0.5, 0.25}});
  REQUIRE(pslg.regions.size() == 3);
  CHECK(pslg.regions[0].label == -3);
  CHECK(pslg.regions[0].max_area == 0.5);
  CHECK(pslg.regions[1].max_area == 0);
  CHECK(pslg.regions[2].max_area == 0);
  CHECK(pslg.regions[2].label == 2);
}

TEST_CASE("a .poly file counts from 0 when its first vertex does, and keeps indices that are too large for the check") {
  const delref::Pslg pslg = parse("2 2\n0 0 0\n1 1 1\n1\n0 0 77\n0\n");
  CHECK(pslg.first_index == 0);
  CHECK(pslg.segments[0][1] == 77);
}

TEST_CASE("vertices may be in a .node file of the same stem") {
  const Scratch folder;
  const auto poly = folder.write("a.poly", "0 2 0 0\n1 0\n1 1 2\n0\n");
  CHECK_THROWS_MATCHES(delref::read_triangle_poly(poly), delref::InvalidInput, MessageMatches(ContainsSubstring("there is no file")));
  const auto node = folder.write("a.node", "2 2 0 1\n1 0 0 3\n2 1 0 4\n");
  const delref::Pslg pslg = delref::read_triangle_poly(poly);
  CHECK(pslg.points.size() == 2);
  CHECK(pslg.segments[0] == std::array<delref::Pslg::Index, 2>{0, 1});
  CHECK(delref::read_triangle_node(node).point_markers == std::vector<int>{3, 4});
}

TEST_CASE("a broken .poly file is refused with the line and what was expected") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "in.poly, line 1: the file ends where the number of vertices was expected"},
      {"x", "in.poly, line 1: expected an integer that is not negative for the number of vertices, found \"x\""},
      {"-1 2", "in.poly, line 1: expected an integer that is not negative for the number of vertices, found \"-1\""},
      {"4000000000 2 0 0\n", "in.poly, line 1: the number of vertices is 4000000000, but only 7 bytes follow"},
      {"99999999999999999999 2", "in.poly, line 1: the number of vertices is 99999999999999999999, which is beyond 18446744073709551615"},
      {"1 3 0 0\n0 0 0 0\n", "in.poly, line 1: the dimension is 3; planar files have 2"},
      {"1 2 0 2\n0 0 0 0 0\n", "in.poly, line 1: the number of vertex markers is 2; it can be 0 or 1"},
      {"1 2\n5 0 0\n", "in.poly, line 2: the first vertex has number 5; numbers start at 0 or 1"},
      {"2 2\n0 0 0\n7 0 0\n", "in.poly, line 3: expected vertex 1, found vertex 7"},
      {"2 2\n0 0 0\n1 0\n", "in.poly, line 3: the line ends where the y coordinate of vertex 1 was expected"},
      {"1 2\n0 1e999 0\n", "in.poly, line 2: the x coordinate of vertex 0 is 1e999, which no double can hold"},
      {"1 2\n0 0 1.2.3\n", "in.poly, line 2: expected a number for the y coordinate of vertex 0, found \"1.2.3\""},
      {"1 2 0 1\n0 0 0 1.5\n", "in.poly, line 2: expected an integer for the marker of vertex 0, found \"1.5\""},
      {"1 2\n0 0 0\n", "in.poly, line 3: the file ends where the number of segments was expected"},
      {"1 2\n1 0 0\n1 0\n1 0 1\n0\n", "in.poly, line 4: the first end of segment 1 is vertex 0, but vertices are numbered from 1"},
      {"1 2\n0 0 0\n1 0\n1 0 9999999999\n0\n", "in.poly, line 4: the second end of segment 1 is 9999999999, which is beyond 4294967295"},
      {"1 2\n0 0 0\n0\n", "in.poly, line 4: the file ends where the number of holes was expected"},
      {"1 2\n0 0 0\n0\n0\n1\n1 0 0 1.5\n",
       "in.poly, line 6: the attribute of region 1 is 1.5; it is the label of the region and must be an integer of 32 bits"},
      {"1 2\n0 0 0\n0\n0\n1\n1 0 0 1 nan\n", "in.poly, line 6: the area bound of region 1 is not a number"},
      {"1 2\n0 0 0\n0\n0\n0\n5\n", "in.poly, line 6: more follows after the last region; is one of the numbers of records too small?"},
  }));
  CHECK_THROWS_MATCHES(parse(text), delref::InvalidInput, Message(message));
}

TEST_CASE("a mesh survives the files of Triangle") {
  const Scratch folder;
  const delref::PlanarMesh mesh = delref_test::square_mesh();
  delref::Pslg input;
  input.first_index = GENERATE(0U, 1U);
  delref::write_triangle_mesh(folder / "m.ele", mesh, input);
  delref_test::check_same(delref::read_triangle_mesh(folder / "m.node"), mesh);
  std::filesystem::remove(folder / "m.poly");
  CHECK(delref::read_triangle_mesh(folder / "m.node").edge_markers.size() == 2);
}

TEST_CASE("the files of Triangle have the holes, regions and attributes of the input") {
  const Scratch folder;
  delref::Pslg input = parse("2 2 1 0\n1 0 0 2.5\n2 1 0 3.5\n1 1\n1 1 2 5\n1\n1 0.5 0.25\n1\n1 0.1 0.2 -3 0.5\n");
  const delref::PlanarMesh mesh = delref_test::square_mesh();
  delref::write_triangle_mesh(folder / "m.node", mesh, input);
  const delref::Pslg read = delref::read_triangle_poly(folder / "m.poly");
  CHECK(read.holes == input.holes);
  CHECK(read.regions[0].max_area == 0.5);
  CHECK(read.attributes == std::vector<double>{2.5, 0, 0, 3.5});
  CHECK(delref::read_file(folder / "m.edge") == "5 1\n1 1 2 7\n2 1 3 0\n3 1 4 0\n4 2 3 -2147483648\n5 3 4 0\n");
}

TEST_CASE("broken meshes of Triangle are refused with the line") {
  const std::string node = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  const auto read = [&](delref::TriangleMeshText text) { return delref::parse_triangle_mesh(text, "m"); };
  CHECK_THROWS_MATCHES(read({node, "1 3 0\n1 1 2 4\n", {}, {}}), delref::InvalidInput,
                       Message("m.ele, line 2: the third vertex of triangle 1 is vertex 4, but the vertices are numbered from 1 and there are 3"));
  CHECK_THROWS_MATCHES(read({node, "1 3 0\n1 0 2 3\n", {}, {}}), delref::InvalidInput,
                       Message("m.ele, line 2: the first vertex of triangle 1 is vertex 0, but vertices are numbered from 1"));
  CHECK_THROWS_MATCHES(read({node, "1 6 0\n1 1 2 3 1 2 3\n", {}, {}}), delref::InvalidInput,
                       Message("m.ele, line 1: the triangles have 6 vertices each; only triangles with 3 are read"));
  CHECK_THROWS_MATCHES(read({node, "1 3 0\n1 1 2 3\n", "0 2 0 0\n1 0\n1 1 9\n0\n", {}}), delref::InvalidInput,
                       Message("m.poly: segment 1 ends at vertex 9, but m.node has 3 vertices"));
  CHECK_THROWS_MATCHES(read({node, "1 3 0\n1 1 2 3\n", "1 2 0 0\n1 0 0\n0\n0\n", {}}), delref::InvalidInput,
                       MessageMatches(ContainsSubstring("has 1 vertices of its own")));
}
