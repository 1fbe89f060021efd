// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/geojson.hpp>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

delref::PslgFile read(const std::string& text) { return delref::parse_geojson(text, "in.geojson"); }

std::string feature(const std::string& coordinates, const std::string& properties = "{}") {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":{"type":"Polygon","coordinates":)" + coordinates + "}}";
}

std::string collection(const std::string& features) { return R"({"type":"FeatureCollection","features":[)" + features + "]}"; }

bool inside(const std::vector<delref::Point2>& ring, delref::Point2 p) {
  bool odd = false;
  for (std::size_t i = 0; i != ring.size(); ++i) {
    const delref::Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y) > p.x) odd = !odd;
  }
  return odd;
}

const std::string square = "[[[0,0],[10,0],[10,10],[0,10],[0,0]]]";

}  // namespace

TEST_CASE("a polygon is a region and its inner ring a hole") {
  const auto [pslg, notes] = read(feature("[[[0,0],[10,0],[10,10],[0,10],[0,0]],[[1,1],[1,4],[4,4],[4,1],[1,1]]]"));
  CHECK(pslg.points.size() == 8);
  CHECK(pslg.segments.size() == 8);
  CHECK(pslg.segment_markers == std::vector<int>(8, 1));
  REQUIRE(pslg.regions.size() == 1);
  CHECK(pslg.regions[0].label == 1);
  REQUIRE(pslg.holes.size() == 1);
  CHECK(inside({{1, 1}, {4, 1}, {4, 4}, {1, 4}}, pslg.holes[0]));
  CHECK_FALSE(inside({{1, 1}, {4, 1}, {4, 4}, {1, 4}}, pslg.regions[0].seed));
  CHECK(notes.empty());
}

TEST_CASE("neighbours share their border, and properties give label and area bound") {
  const auto file = read(collection(feature(square, R"({"region":-7,"max_area":0.5})") + "," + feature("[[[10,0],[20,0],[20,10],[10,10],[10,0]]]")));
  CHECK(file.pslg.points.size() == 6);
  CHECK(file.pslg.segments.size() == 7);
  REQUIRE(file.pslg.regions.size() == 2);
  CHECK(file.pslg.regions[0].label == -7);
  CHECK(file.pslg.regions[0].max_area == 0.5);
  CHECK(file.pslg.regions[1].label == 2);
  CHECK(file.pslg.holes.empty());
}

TEST_CASE("an inner ring that another polygon fills is no hole") {
  const auto file = read(collection(feature("[[[0,0],[10,0],[10,10],[0,10],[0,0]],[[1,1],[4,1],[4,4],[1,4],[1,1]]]") + "," +
                                    feature("[[[1,1],[4,1],[4,4],[1,4],[1,1]]]")));
  CHECK(file.pslg.holes.empty());
  CHECK(file.pslg.segments.size() == 8);
}

TEST_CASE("the seed of a lake is not on its island") {
  const auto file = read(collection(feature("[[[0,0],[10,0],[10,10],[0,10],[0,0]],[[1,1],[9,1],[9,9],[1,9],[1,1]]]") + "," +
                                    feature("[[[1.5,1.5],[8.5,1.5],[8.5,8.5],[1.5,8.5],[1.5,1.5]]]")));
  REQUIRE(file.pslg.holes.size() == 1);
  CHECK(inside({{1, 1}, {9, 1}, {9, 9}, {1, 9}}, file.pslg.holes[0]));
  CHECK_FALSE(inside({{1.5, 1.5}, {8.5, 1.5}, {8.5, 8.5}, {1.5, 8.5}}, file.pslg.holes[0]));
}

TEST_CASE("a lake that neighbours enclose together is a hole") {
  const auto file = read(collection(feature("[[[0,0],[10,0],[10,4],[6,4],[4,4],[0,4],[0,0]]]") + "," +
                                    feature("[[[0,4],[4,4],[4,6],[6,6],[6,4],[10,4],[10,10],[0,10],[0,4]]]")));
  REQUIRE(file.pslg.holes.size() == 1);
  CHECK(inside({{4, 4}, {6, 4}, {6, 6}, {4, 6}}, file.pslg.holes[0]));
}

TEST_CASE("seeds are inside rings that wind") {
  const int turns = GENERATE(1, 3, 12);
  std::vector<delref::Point2> ring;
  for (int i = 0; i <= 40 * turns; ++i) ring.push_back({(i + 5) * std::cos(0.157 * i), (i + 5) * std::sin(0.157 * i)});
  for (int i = 40 * turns; i >= 0; --i) ring.push_back({(i + 5.2) * std::cos(0.157 * i), (i + 5.2) * std::sin(0.157 * i)});
  const double far = 2 * (40.0 * turns + 10);
  const auto file = delref::polygons_to_pslg({{3, 0, {{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, ring}}});
  REQUIRE(file.pslg.holes.size() == 1);
  CHECK(inside(ring, file.pslg.holes[0]));
  REQUIRE(file.pslg.regions.size() == 1);
  CHECK_FALSE(inside(ring, file.pslg.regions[0].seed));
}

TEST_CASE("what has no inside is passed over with a note, and open rings are closed with one") {
  const auto file = read(R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[0,0]},
    {"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1]]],[[[5,5],[6,5],[5,6],[5,5]]]]}]})");
  CHECK(file.pslg.regions.size() == 2);
  CHECK(file.pslg.regions[0].label == 2);
  REQUIRE(file.notes.size() == 2);
  CHECK_THAT(file.notes[0], ContainsSubstring("1 of type Point passed over"));
  CHECK_THAT(file.notes[1], ContainsSubstring("1 rings did not end where they began"));
}

TEST_CASE("broken GeoJSON is refused in words") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "in.geojson, line 1: is not JSON"},
      {"{\n\n\"type\": }", "in.geojson, line 3: is not JSON"},
      {"[1,2]", "in.geojson: the file is array, not an object"},
      {R"({"type":5})", "the file has a \"type\" that is number, not string"},
      {R"({"type":"Topology"})", "feature 1 has a geometry of type \"Topology\", which GeoJSON does not know"},
      {R"({"type":"FeatureCollection"})", "the file has no \"features\""},
      {R"({"type":"FeatureCollection","features":[]})", "holds no polygon; nothing to mesh"},
      {R"({"type":"FeatureCollection","features":[7]})", "feature 1 is number, not an object"},
      {R"({"type":"Feature"})", "feature 1 has no \"geometry\""},
      {R"({"type":"Polygon","coordinates":{}})", "feature 1 has a \"coordinates\" that is object, not array"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,0]]]})", "feature 1, ring 1 of polygon 1 of the file, has 2 different positions"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[1,"a"],[0,0]]]})", "has at place 2 something that is no position"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[1,1e999],[0,0]]]})", "number overflow"},
      {R"({"type":"Feature","properties":{"region":3000000000},"geometry":null})", "has a property \"region\" that 32 bits cannot hold"},
      {R"({"type":"Feature","properties":{"max_area":0},"geometry":null})", "has a property \"max_area\" that is not positive"},
      {std::string(100'000, '['), "is nested more than 64 deep"},
  }));
  CHECK_THROWS_MATCHES(read(text), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}
