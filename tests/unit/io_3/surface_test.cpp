// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstring>
#include <locale>
#include <cstdint>
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

TEST_CASE("coordinates that are no finite numbers are refused by every reader") {
  const auto refuses = [](const std::string& message) { return MessageMatches(ContainsSubstring(message)); };
  const std::string faces_off = "3 0 1 2\n";
  CHECK_THROWS_MATCHES(delref::parse_off("OFF\n3 1 0\n0 0 0\nnan 0 0\n0 0 1\n" + faces_off, "a.off"), delref::InvalidInput,
                       refuses("a.off, line 4: expected the three coordinates of a vertex, found \"nan 0 0\""));
  CHECK_THROWS_MATCHES(delref::parse_off("OFF\n3 1 0\n0 0 0\n1e999 0 0\n0 0 1\n" + faces_off, "a.off"), delref::InvalidInput,
                       refuses("a.off, line 4: expected the three coordinates of a vertex"));
  CHECK_THROWS_MATCHES(delref::parse_obj("v 0 0 0\nv 0 -inf 0\nv 0 0 1\nf 1 2 3\n", "a.obj"), delref::InvalidInput,
                       refuses("a.obj, line 2: expected the three coordinates of vertex 2"));
  CHECK_THROWS_MATCHES(delref::parse_obj("v 0 0 0\nv 0 -1e999 0\nv 0 0 1\nf 1 2 3\n", "a.obj"), delref::InvalidInput, refuses("a.obj, line 2: expected the three coordinates of vertex 2"));
  std::string ply = binary_ply(std::endian::little);
  ply.replace(ply.find("end_header\n") + 11, 8, bytes(std::endian::little, std::nan("")));
  CHECK_THROWS_MATCHES(delref::parse_ply(ply, "a.ply"), delref::InvalidInput, refuses("a.ply: vertex 0 is (nan, 0, 0); every coordinate must be a finite number"));
  std::string stl = binary_stl();
  stl.replace(84 + 50 + 12, 4, bytes(std::endian::little, std::nanf("")));
  CHECK_THROWS_MATCHES(delref::parse_stl(stl, "a.stl"), delref::InvalidInput, refuses("a.stl: a corner of triangle 1 is (nan, 0, 0)"));
}

TEST_CASE("broken .off files are refused with the line") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "a.off, line 1: the file ends where OFF was expected"},
      {"OFF\n0 0 0\n", "a.off: the file has no vertices"},
      {"OFF\n1 0 0\n0 0 0\n", "a.off: the file has no faces"},
      {"OFF\n-1 0 0\n", "a.off, line 2: expected an integer that is not negative for the number of vertices, found \"-1\""},
      {"OFF\n2147483648 1 0\n0 0 0\n", "a.off, line 2: the number of vertices is 2147483648, but only 11 bytes follow"},
      {"OFF\n3 9223372036854775808 0\n0 0 0\n", "a.off, line 2: the number of faces is 9223372036854775808, but only 9 bytes follow"},
      {"OFF\n1 1 0\n0 0 0\n9223372036854775807 0 0 0\n", "a.off, line 4: the number of corners of a face is 9223372036854775807, but only 7 bytes follow"},
      {"OFF\n1 1 0\n0,0 0 0\n3 0 0 0\n", "a.off, line 3: there is a comma; numbers are separated by blanks and have a decimal point"},
      {"STOFF\n3 1 0\n0 0\n0 0 0\n1 0 0\n3 0 1 2\n", "a.off, line 3: expected the three coordinates of a vertex, found \"0 0\""},
      {"solid cube\n", "a.off, line 1: expected OFF: this is not a file in the Object File Format"},
      {"4OFF\n1 0 0\n0 0 0 0\n", "a.off, line 1: expected OFF: the points of 4OFF do not have three coordinates"},
      {"OFF BINARY\nxxxx", "a.off, line 1: the file is binary; only text is read: save it as text"},
      {"OFF\n1000000000000 4 0\n", "a.off, line 2: the number of vertices is 1000000000000, but only 5 bytes follow"},
      {"OFF\n1 1000000000000 0\n0 0 0\n", "a.off, line 2: the number of faces is 1000000000000, but only 9 bytes follow"},
      {"OFF\n1 0 0\n0 0 x\n", "a.off, line 3: expected the three coordinates of a vertex, found \"0 0 x\""},
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
  const delref::PlcFile line = delref::parse_obj("v 0 0 0\nv 1 0 0\ncurv 0 1 1 1\nunknown 7\nl\t1 -1 # all\r\n", "a.obj");
  CHECK(line.notes.size() == 1);
  CHECK(line.plc.facets.empty());
  CHECK(line.plc.segments.size() == 1);
}

TEST_CASE("broken .obj files are refused with the line") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "a.obj, line 1: the file ends without a vertex, that is a line that starts with v"},
      {"v 0 0\nf 1 1 1\n", "a.obj, line 1: expected the three coordinates of vertex 1, found \"v 0 0\""},
      {"v 0 0 0\n", "a.obj, line 2: the file ends without a face, that is a line that starts with f"},
      {"v 0,5 0 0\n", "a.obj, line 1: there is a comma; numbers are separated by blanks and have a decimal point"},
      {"v 0 0 0\nf 1,1,1\n", "a.obj, line 2: there is a comma; numbers are separated by blanks and have a decimal point"},
      {"v 0 0 0\nl 1 2\n", "a.obj: a corner of line 1 is vertex 2, but the vertices are numbered from 1 and there are 1"},
      {"v 0 0 0\nf 1 1 1 /1\n", "a.obj, line 2: expected the number of a vertex, alone or as in 1/2/3"},
      {"v 0 0 0\nf 1 1 1 \\\n1\n", "a.obj, line 2: expected the number of a vertex, alone or as in 1/2/3"},
      {"v 0 0 0\nf 0 1 1\nv 1 0 0\n", "a.obj, line 2: there is no vertex 0; vertices are numbered from 1, and from -1 backwards"},
      {"v 0 0 0\nf 1 1 2147483648\n", "a.obj, line 2: there is no vertex 2147483648"},
      {"v 0 0 0\nf 1 1 9223372036854775808\n", "a.obj, line 2: there is no vertex 9223372036854775808"},
      {"v 0 0 0\nf 1 1\n", "a.obj, line 2: face 1 has 2 corners; a polygon has three or more"},
      {"v 0 0 0\nf 1 1 x\n", "a.obj, line 2: expected the number of a vertex, alone or as in 1/2/3"},
      {"v 0 0 0\nf 1 1 0\n", "a.obj, line 2: there is no vertex 0; vertices are numbered from 1, and from -1 backwards"},
      {"v 0 0 0\nf 1 1 -2\n", "a.obj, line 2: there is no vertex -2; vertices are numbered from 1, and from -1 backwards"},
      {"v 0 0 0\nf 1 1 2\n", "a.obj: a corner of face 1 is vertex 2, but the vertices are numbered from 1 and there are 1"},
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
  const std::string counted = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n";
  const std::string whole_ply = binary_ply(std::endian::little);
  const std::string face = vertex + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n";
  const auto [text, message] = GENERATE_REF(table<std::string, std::string>({
      {"", "expected \"ply\" in the first line"},
      {"ply\nformat xml 1.0\n", "line 2: expected the format ascii, binary_little_endian or binary_big_endian"},
      {"ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nend_header\n", "the number of elements is 1000000000000, but only 1 bytes follow"},
      {"ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property comes before the first element"},
      {std::string("ply\nformat ascii 1.0\nelement a\0b 1\n", 35), "line 3: the name of an element has a character that no text has"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", "line 4: expected the type of a property"},
      {"ply\nformat ascii 1.0\nelement face 0\nproperty list float int v\n", "line 4: the length of a list is a real number"},
      {"ply\nformat ascii 1.0\nelement vertex 0\n", "line 4: the file ends where end_header was expected"},
      {"ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nend_header\n", "the element \"vertex\" has no property y"},
      {vertex + "end_header\n0 0", "line 8: expected the numbers of the next element after 0 vertices and 0 faces"},
      {vertex + "end_header\n0 0 x", "line 8: expected the numbers of the next element after 0 vertices and 0 faces"},
      {vertex + "end_header\n0 0 0\n", "a.ply: the file has no faces"},
      {vertex + "element face 1\nend_header\n0 0 0\n", "the element \"face\" has no list vertex_indices"},
      {vertex + "element face 1\nproperty int vertex_indices\nend_header\n0 0 0\n3", "the element \"face\" has no list vertex_indices"},
      {face + "2 0 0\n", "face 0 has 2 corners; a polygon has three or more"},
      {face + "3 0 0 1\n", "a corner of face 0 is vertex 1, but the vertices are numbered from 0 and there are 1"},
      {face + "3 0 0 -1\n", "a corner of face 0 is vertex -1"},
      {face + "200 0 0\n", "line 11: expected the numbers of the next element after 1 vertices and 0 faces"},
      {face + "-1 0 0\n", "expected the numbers of the next element"},
      {face + "2147483648 0 0\n", "expected the numbers of the next element"},
      {face + "9223372036854775808 0 0\n", "expected the numbers of the next element"},
      {face + "3 0 0 0\n3 0 0 0\n", "more follows after the last element; is one of the numbers in the header too small?"},
      {face + "3 0 0 0.5\n", "more follows after the last element"},
      {vertex + "element face -1\n", "line 7: expected an integer that is not negative for the number of elements, found \"-1\""},
      {vertex + "element face 2147483648\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n", "the number of elements is 2147483648, but only 7 bytes follow"},
      {vertex + "element face 9223372036854775808\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n", "the number of elements is 9223372036854775808"},
      {counted + "property list int int vertex_indices\nend_header\n" + std::string(12, '\0') + bytes(std::endian::little, -1), "face 0: the file ends here; is it cut off?"},
      {counted + "property list uint int vertex_indices\nend_header\n" + std::string(12, '\0') + bytes(std::endian::little, 0x80000000U), "face 0: the file ends here; is it cut off?"},
      {counted + "property list char int vertex_indices\nend_header\n" + std::string(12, '\0') + std::string(1100, '\xff'), "a.ply: has a list of a negative length"},
      {counted + "property list uchar short vertex_indices\nend_header\n" + std::string(20, '\0'), "the list vertex_indices is of type short; binary files are read with int or uint"},
      {"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nend_header\n" + std::string(12, '\0'), "x of the element \"vertex\" is of type int; binary files are read with float or double"},
      {whole_ply.substr(0, whole_ply.size() - 3), "face 3: the file ends here"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_ply(text, "a.ply"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("an .stl file is read from text and from bytes, equal points as one") {
  std::string text = "solid a name\n";
  for (const auto& f : faces) {
    text += "facet normal 0 0 nan\n outer loop\n";
    for (const auto v : f) text += fmt::format("  vertex {} {} {}\n", corners[v].x, corners[v].y, corners[v].z);
    text += " endloop\nendfacet\n";
  }
  text += "endsolid a name\n";
  for (const std::string& file : {text, text + text, binary_stl(), "solid\n" + text.substr(text.find('\n')), "  \r\n" + text}) {
    const delref::Plc plc = delref::parse_stl(file, "a.stl");
    CHECK(plc.points == std::vector<delref::Point3>{corners[0], corners[2], corners[1], corners[3]});
    REQUIRE(plc.facets.size() == (file == text + text ? 8 : 4));
    CHECK(plc.facets[3].polygons == Polygons{{2, 1, 3}});
  }
  const std::string names = "solid a solid facet\n" + text.substr(text.find('\n') + 1);
  CHECK(delref::parse_stl(names, "a.stl").facets.size() == 4);
  std::string bytes_like_text = binary_stl();
  bytes_like_text.replace(0, 16, "solid x endsolid");
  CHECK(delref::parse_stl(bytes_like_text, "a.stl").facets.size() == 4);
}

TEST_CASE("broken .stl files are refused in words") {
  const std::string whole = binary_stl();
  std::string many = whole;
  many.replace(0, 5, "STLB!").replace(80, 4, "\xff\xff\xff\xff");
  const auto [text, message] = GENERATE_REF(table<std::string, std::string>({
      {"", "neither begins with \"solid\", as text does, nor has the 84 bytes"},
      {many, "announces 4294967295 triangles and should then have 214748364834 bytes, but has 284; is it cut off?"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 5: the text is no whole surface up to here"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\nvertex 0 0 0\n", "line 4: the text is no whole surface up to here"},
      {"solid\nfacet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet\nfacet", "line 3: the text is no whole surface up to here"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\nendsolid", "line 6: the text is no whole surface up to here"},
      {"solid\n", "line 2: the text is no whole surface up to here"},
      {"solid\nendsolid\n", "a.stl: the file has no vertices"},
      {std::string(84, '\0'), "a.stl: the file has no vertices"},
      {whole.substr(0, 200), "announces 4 triangles and should then have 284 bytes, but has 200; is it cut off?"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_stl(text, "a.stl"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("a file cut off anywhere is refused in words or read without a bad index") {
  std::string stl = "solid a\n";
  for (int i = 0; i != 2; ++i) stl += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  stl += "endsolid a\n";
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto [name, whole] = GENERATE_REF(table<std::string, std::string>({
      {"a.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 .5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 .5\nf 1 3 2\nf 1 2 4\nf 1/2/3 4 3\nf -3 -2 -1\nl 1 2\n"},
      {"a.ply", ply},
      {"a.ply", binary_ply(std::endian::little)},
      {"a.ply", binary_ply(std::endian::big)},
      {"a.stl", stl},
      {"a.stl", binary_stl()},
  }));
  const Scratch folder;
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    CAPTURE(name, size);
    try {
      const delref::Plc plc = delref::read_plc(folder.write(name, whole.substr(0, size))).plc;
      CHECK(!plc.points.empty());
      for (const auto& polygon : polygons(plc)) for (const auto corner : polygon) CHECK(corner < plc.points.size());
    } catch (const delref::InvalidInput& error) {
      CHECK_THAT(error.what(), ContainsSubstring(name));
    }
  }
}

TEST_CASE("a surface of many triangles is given up while the library reads it") {
  std::string text = "solid a\n";
  for (int i = 0; i != 3000; ++i) text += fmt::format("facet normal 0 0 1 outer loop vertex {0} 0 0 vertex {0} 1 0 vertex {0} 0 1 endloop endfacet ", i);
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(delref::parse_stl(text + "endsolid\n", "a.stl", delref::Control({}, stop.get_token())), delref::Interrupted);
}

TEST_CASE("a locale in which CGAL would misread numbers is told, not obeyed") {
  struct Comma final : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  CHECK_THROWS_MATCHES(delref::parse_obj("v 0.5 0 0\nf 1 1 1\n", "a.obj"), delref::InvalidInput, MessageMatches(ContainsSubstring("another decimal sign than the point")));
  std::locale::global(before);
}

TEST_CASE("surfaces are read by the extension of their file") {
  const Scratch folder;
  CHECK(delref::read_plc(folder.write("a.OFF", "OFF 1 1 0\n0 0 0\n3 0 0 0\n")).plc.points.size() == 1);
  CHECK(delref::read_plc(folder.write("a.obj", "v 0 0 0\nf 1 1 1\n")).plc.points.size() == 1);
  CHECK(delref::read_plc(folder.write("a.stl", binary_stl())).plc.points.size() == 4);
  CHECK(delref::read_plc(folder.write("a.ply", binary_ply(std::endian::little))).plc.points.size() == 4);
  CHECK_THROWS_MATCHES(delref::read_plc("a.step"), delref::InvalidInput,
                       Message("a.step: \".step\" is not the extension of a polyhedral domain; known are .poly, .smesh, .node, .off, .obj, .ply and .stl"));
}

TEST_CASE("reading stops when the control says so") {
  const Scratch folder;
  std::stop_source stop;
  stop.request_stop();
  const delref::Control control({}, stop.get_token());
  CHECK_THROWS_AS(delref::read_plc(folder.write("a.off", "OFF 1 1 0\n0 0 0\n3 0 0 0\n"), control), delref::Interrupted);
}
