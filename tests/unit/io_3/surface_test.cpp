// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstring>
#include <stop_token>
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

Polygons polygons(const delref::Plc& plc) {
  Polygons all;
  for (const auto& facet : plc.facets) {
    REQUIRE(facet.polygons.size() == 1);
    all.push_back(facet.polygons[0]);
  }
  return all;
}

const std::vector<delref::Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
const Polygons faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// The bytes of numbers, in the order asked for.
template <class... Numbers>
std::string bytes(std::endian order, Numbers... numbers) {
  std::string all;
  const auto put = [&](auto number) {
    std::string one(sizeof number, '\0');
    std::memcpy(one.data(), &number, sizeof number);
    all += order == std::endian::native ? one : std::string(one.rbegin(), one.rend());
  };
  (put(numbers), ...);
  return all;
}

std::string binary_ply(std::endian order) {
  std::string text = std::string("ply\nformat binary_") + (order == std::endian::little ? "little" : "big") +
                     "_endian 1.0\nelement vertex 4\nproperty double x\nproperty uchar red\nproperty float y\nproperty float64 z\n"
                     "element camera 1\nproperty short a\nelement face 4\nproperty list uchar int vertex_index\nproperty int8 b\nend_header\n";
  for (const auto& p : corners) text += bytes(order, p.x, std::uint8_t{9}, static_cast<float>(p.y), p.z);
  text += bytes(order, std::int16_t{1});
  for (const auto& f : faces) {
    text += bytes(order, std::uint8_t{3}, static_cast<std::int32_t>(f[0]), static_cast<std::int32_t>(f[1]), static_cast<std::int32_t>(f[2]), std::int8_t{0});
  }
  return text;
}

std::string binary_stl() {
  std::string text = "solid, which a binary file may begin with";
  text.resize(80, ' ');
  text += bytes(std::endian::little, std::uint32_t{4});
  for (const auto& f : faces) {
    text += bytes(std::endian::little, 0.f, 0.f, std::nanf(""));
    for (const auto v : f) {
      text += bytes(std::endian::little, static_cast<float>(corners[v].x), static_cast<float>(corners[v].y), static_cast<float>(corners[v].z));
    }
    text += bytes(std::endian::little, std::uint16_t{7});
  }
  return text;
}

}  // namespace

TEST_CASE("an .off file may have comments, colours, a bare header and polygons of any size") {
  const auto text = GENERATE(as<std::string>(), "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 .5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
                             "# made by hand\nCOFF 4 4 # counts\n\n0 0 0 255 0 0\n1 0 0 1 1 1\n0 1 0\n0 0 0.5\r\n3 0 2 1 0.5 0.5 0.5\n3 0 1 3\n3 0 3\n2\n3 1 2 3",
                             "4 4\n0 0 0\n1 0 0\n0 1 0\n0 0 5e-1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const delref::Plc plc = delref::parse_off(text, "a.off");
  CHECK(plc.points == corners);
  CHECK(polygons(plc) == faces);
  CHECK(plc.first_index == 0);
  CHECK(polygons(delref::parse_off("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.off")) == Polygons{{0, 1, 2, 3}});
}

TEST_CASE("coordinates that are no finite numbers are kept for the check to name") {
  const delref::Plc plc = delref::parse_off("OFF\n3 0 0\nnan 0 0\n0 -inf 0\n0 0 inf\n", "a.off");
  CHECK(std::isnan(plc.points[0].x));
  CHECK(std::isinf(plc.points[1].y));
}

TEST_CASE("broken .off files are refused with the line") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "a.off, line 1: the file ends where OFF was expected"},
      {"solid cube\n", "a.off, line 1: expected OFF: this is not a file in the Object File Format"},
      {"4OFF\n1 0 0\n0 0 0 0\n", "a.off, line 1: expected OFF: the points of 4OFF do not have three coordinates"},
      {"OFF BINARY\nxxxx", "a.off, line 1: the file is binary; only text is read: save it as text"},
      {"OFF\n1000000000000 4 0\n", "a.off, line 2: the number of vertices is 1000000000000, but only 5 bytes follow"},
      {"OFF\n1 1000000000000 0\n0 0 0\n", "a.off, line 2: the number of faces is 1000000000000, but only 9 bytes follow"},
      {"OFF\n1 0 0\n0 0 x\n", "a.off, line 3: expected a number for the z coordinate of vertex 0, found \"x\""},
      {"OFF\n2 0 0\n0 0 0    \n    \n", "a.off, line 5: the file ends where vertex 1 was expected"},
      {"OFF\n1 1 0\n0 0 0\n2 0 0    \n", "a.off, line 4: face 0 has 2 corners; a polygon has three or more"},
      {"OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "a.off, line 4: a corner of face 0 is vertex 1, but the vertices are numbered from 0 and there are 1"},
      {"OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "a.off, line 4: a corner of face 0 is vertex -1, but the vertices are numbered from 0 and there are 1"},
      {"OFF\n1 0 0\n0 0 0\n3 0 0 0\n", "a.off, line 4: more follows after the last of 0 faces; is one of the numbers in the header too small?"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_off(text, "a.off"), delref::InvalidInput, Message(message));
}

TEST_CASE("an .obj file numbers from 1 and backwards, and its lines are segments") {
  const delref::PlcFile file = delref::parse_obj(
      "# tetrahedron\nmtllib a.mtl\no t\nv 0 0 0\nv 1 0 0 1.0\nvt 0 0\nvn 0 0 1\nv 0 1 0 0.5 0.5 0.5\ng sides\nusemtl m\ns off\n"
      "f 1/1/1 3//1 2/1\nf 1 2 4\nv 0 0 .5\nf -4 -1 -2\nf 2 3 4\nl 1 2 3\n",
      "a.obj");
  CHECK(file.plc.points == corners);
  CHECK(polygons(file.plc) == faces);
  CHECK(file.plc.segments == std::vector<std::array<delref::Plc::Index, 2>>{{0, 1}, {1, 2}});
  CHECK(file.plc.first_index == 1);
  CHECK(file.notes.empty());
  CHECK(delref::parse_obj("v 0 0 0\ncurv 0 1 1 1\n", "a.obj").notes.size() == 1);
}

TEST_CASE("broken .obj files are refused with the line") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "a.obj, line 1: the file ends without a vertex, that is a line that starts with v"},
      {"v 0 0\n", "a.obj, line 1: the line ends where the z coordinate of vertex 1 was expected"},
      {"v 0 0 0\nf 1 1\n", "a.obj, line 2: face 1 has 2 corners; a polygon has three or more"},
      {"v 0 0 0\nf 1 1 x\n", "a.obj, line 2: expected the number of a vertex, alone or as in 1/2/3"},
      {"v 0 0 0\nf 1 1 0\n", "a.obj, line 2: there is no vertex 0; vertices are numbered from 1, and from -1 backwards"},
      {"v 0 0 0\nf 1 1 -2\n", "a.obj, line 2: there is no vertex -2; vertices are numbered from 1, and from -1 backwards"},
      {"v 0 0 0\nf 1 1 2\n", "a.obj, line 3: a face or line has the vertex 2, but there are 1"},
      {"v 0 0 0\nf 1 1 99999999999\n", "a.obj, line 2: there is no vertex 99999999999"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_obj(text, "a.obj"), delref::InvalidInput, Message(message));
}

TEST_CASE("a .ply file is read from text and from bytes in either order") {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\ncomment # by hand, with a comma\r\nelement vertex 4\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n"
      "element face 4\r\nproperty list uchar int vertex_indices\r\nend_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 0.5\r\n3 0 2 1\r\n3 0 1 3\r\n3 0 3 2\r\n3 1 2 3\r\n";
  for (const std::string& file : {text, binary_ply(std::endian::little), binary_ply(std::endian::big)}) {
    const delref::Plc plc = delref::parse_ply(file, "a.ply").plc;
    CHECK(plc.points == corners);
    CHECK(polygons(plc) == faces);
  }
  CHECK(delref::parse_ply(binary_ply(std::endian::big), "a.ply").notes == std::vector<std::string>{"1 elements \"camera\" are passed over"});
}

TEST_CASE("broken .ply files are refused in words") {
  const std::string vertex = "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n";
  const std::string whole_ply = binary_ply(std::endian::little);
  const std::string face = vertex + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  const auto [text, message] = GENERATE_REF(table<std::string, std::string>({
      {"", "expected \"ply\" in the first line"},
      {"ply\nformat xml 1.0\n", "line 2: expected the format ascii, binary_little_endian or binary_big_endian"},
      {"ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nend_header\n", "the number of elements is 1000000000000, but only 1 bytes follow"},
      {"ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property comes before the first element"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", "line 4: expected the type of a property"},
      {"ply\nformat ascii 1.0\nelement face 0\nproperty list float int v\n", "line 4: the length of a list is a real number"},
      {"ply\nformat ascii 1.0\nelement vertex 0\n", "line 4: the file ends where end_header was expected"},
      {"ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nend_header\n", "the element \"vertex\" has no properties x, y and z"},
      {vertex + "end_header\n0 0", "the file ends where a property was expected"},
      {vertex + "end_header\n0 0 x", "expected a number for a property, found \"x\""},
      {vertex + "end_header\n0 0 \n", "the file ends where a property was expected"},
      {face + "2 0 0\n", "face 0: it has 2 corners; a polygon has three or more"},
      {face + "3 0 0 1\n", "face 0: a corner is vertex 1, but the vertices are numbered from 0 and there are 1"},
      {face + "3 0 0 -1\n", "face 0: a corner is vertex -1"},
      {face + "200 0 0\n", "face 0: a list has the length 200, but only"},
      {whole_ply.substr(0, whole_ply.size() - 3), "face 3: the file ends here"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_ply(text, "a.ply"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("an .stl file is read from text and from bytes, three points for each triangle") {
  std::string text = "solid a name\n";
  for (const auto& f : faces) {
    text += "facet normal 0 0 nan\n outer loop\n";
    for (const auto v : f) text += fmt::format("  vertex {} {} {}\n", corners[v].x, corners[v].y, corners[v].z);
    text += " endloop\nendfacet\n";
  }
  text += "endsolid a name\n";
  for (const std::string& file : {text, text + text, binary_stl()}) {
    const delref::Plc plc = delref::parse_stl(file, "a.stl");
    REQUIRE(plc.points.size() >= 12);
    CHECK(plc.facets.size() == plc.points.size() / 3);
    CHECK(plc.points[1] == corners[2]);
    CHECK(plc.points[11] == corners[3]);
    CHECK(plc.facets[3].polygons == Polygons{{9, 10, 11}});
  }
}

TEST_CASE("broken .stl files are refused in words") {
  const std::string whole = binary_stl();
  std::string many = whole;
  many.replace(0, 5, "STLB!").replace(80, 4, "\xff\xff\xff\xff");
  const auto [text, message] = GENERATE_REF(table<std::string, std::string>({
      {"", "neither begins with \"solid\", as text does, nor has the 84 bytes"},
      {many, "announces 4294967295 triangles and should then have 214748364834 bytes, but has 284; is it cut off?"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 5: the file ends where the z coordinate of vertex 0 was expected"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", "line 5: expected \"vertex\""},
      {"solid\n", "line 2: the file ends where facet or endsolid was expected"},
      {whole.substr(0, 200), "announces 4 triangles and should then have 284 bytes, but has 200; is it cut off?"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_stl(text, "a.stl"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("surfaces are read by the extension of their file") {
  const Scratch folder;
  CHECK(delref::read_plc(folder.write("a.OFF", "OFF 1 0 0\n0 0 0\n")).plc.points.size() == 1);
  CHECK(delref::read_plc(folder.write("a.obj", "v 0 0 0\n")).plc.points.size() == 1);
  CHECK(delref::read_plc(folder.write("a.stl", binary_stl())).plc.points.size() == 12);
  CHECK(delref::read_plc(folder.write("a.ply", binary_ply(std::endian::little))).plc.points.size() == 4);
  CHECK_THROWS_MATCHES(delref::read_plc("a.step"), delref::InvalidInput,
                       Message("a.step: \".step\" is not the extension of a polyhedral domain; known are .poly, .smesh, .node, .off, .obj, .ply and .stl"));
}

TEST_CASE("reading stops when the control says so") {
  const Scratch folder;
  std::stop_source stop;
  stop.request_stop();
  const delref::Control control({}, stop.get_token());
  CHECK_THROWS_AS(delref::read_plc(folder.write("a.off", "OFF 1 0 0\n0 0 0\n"), control), delref::Interrupted);
}
