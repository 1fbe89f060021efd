// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/point_set_reader.hpp>

#include "../io/scratch.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using delref_test::Scratch;

namespace {

const std::vector<delref::Point3> points{{0, 0, 0}, {1, 0.1, 0}, {0, 1, -2e-3}, {0, 1, -2e-3}};
const std::vector<delref::Vector3> normals{{0, 0, 1}, {0, 0, 2}, {1, 0, 0}, {1, 0, 0}};

std::string text_ply(bool with_normals) {
  std::string text = "ply\nformat ascii 1.0\ncomment scanned\nelement vertex 4\nproperty float x\nproperty float y\nproperty uchar red\nproperty float z\n";
  if (with_normals) text += "property float nx\nproperty float ny\nproperty float nz\n";
  text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i != points.size(); ++i) {
    text += fmt::format("{} {} 255 {}", points[i].x, points[i].y, points[i].z);
    if (with_normals) text += fmt::format(" {} {} {}", normals[i].x, normals[i].y, normals[i].z);
    text += '\n';
  }
  return text + "3 0 1 2\n";
}

std::string binary_ply(double first) {
  std::string text = std::string("ply\nformat binary_") + (std::endian::native == std::endian::little ? "little" : "big") +
                     "_endian 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  for (const double value : {first, 2.0, 3.0}) {
    std::string one(sizeof value, '\0');
    std::memcpy(one.data(), &value, sizeof value);
    text += one;
  }
  return text;
}

}  // namespace

TEST_CASE("a set of points is read from .xyz and .ply, with normals or without, and keeps points that coincide") {
  const auto text = GENERATE(as<std::string>(), "0 0 0\n1 .1 0\n0 1 -2e-3\n0 1 -0.002\n", "# scanned\n\n 0\t0 0 \r\n\t\r\n1 0.1 0 # the second\r\n+0 1 -2e-3\n0 1 -2e-3");
  CHECK(delref::parse_xyz(text, "a.xyz").points == points);
  CHECK(delref::parse_xyz(text, "a.xyz").normals.empty());
  const delref::PointSet set = delref::parse_xyz("0 0 0 0 0 1\n1 0.1 0 0 0 2\n0 1 -2e-3 1 0 0\n0 1 -2e-3 1 0 0\n", "a.xyz");
  CHECK(set.points == points);
  CHECK(set.normals == normals);
  CHECK(delref::parse_ply_points(text_ply(false), "a.ply").points == points);
  CHECK(delref::parse_ply_points(text_ply(false), "a.ply").normals.empty());
  CHECK(delref::parse_ply_points(text_ply(true), "a.ply").points == points);
  CHECK(delref::parse_ply_points(text_ply(true), "a.ply").normals == normals);
  CHECK(delref::parse_ply_points(binary_ply(1), "a.ply").points == std::vector<delref::Point3>{{1, 2, 3}});
}

TEST_CASE("broken .xyz files are refused with the line") {
  const auto [text, message] = GENERATE(table<std::string, std::string>({
      {"", "a.xyz: the file has no points"},
      {"# nothing\n \n", "a.xyz: the file has no points"},
      {"0 0\n", "line 1: point 0 has 2 numbers; three are read, or six with a normal"},
      {"0 0 0\n0 0 0 1\n", "line 2: point 1 has 4 numbers; three are read, or six with a normal"},
      {"0 0 0\n\n0 0 0 0 0 1\n", "line 3: point 1 has 6 numbers, those before it 3; either all have normals or none"},
      {"0 0 nan\n", "line 1: point 0 has a coordinate that is not a finite number"},
      {"0 0 0 0 0 -inf\n", "line 1: point 0 has a coordinate that is not a finite number"},
      {"0 0 1e999\n", "line 1: point 0 is 1e999, which no double can hold"},
      {"0 0 1.2.3\n", "line 1: expected a number for point 0, found \"1.2.3\""},
      {"0,5 0,5 0,5\n", "line 1: there is a comma"},
      {"0 0 0\n,\n", "line 2: there is a comma"},
      {std::string("0 0 0\n0 0 \0\n", 12), "line 2: expected a number for point 1"},
  }));
  std::ostringstream printed;
  std::streambuf* const before = std::cerr.rdbuf(printed.rdbuf());
  CHECK_THROWS_MATCHES(delref::parse_xyz(text, "a.xyz"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
  std::cerr.rdbuf(before);
  CHECK(printed.str().empty());
}

TEST_CASE("broken sets of points in .ply files are refused in words") {
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const auto [text, message] = GENERATE_REF(table<std::string, std::string>({
      {"", "expected \"ply\" in the first line"},
      {"ply\nformat ascii 1.0\nelement face 0\nend_header\n", "the file has no element \"vertex\""},
      {"ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n", "the file has no points"},
      {head + "property float nx\nend_header\n0 0 0 1\n", "the element \"vertex\" has no property ny"},
      {head + "element vertex 1\nproperty float x\nend_header\n0 0 0 1\n", "there are several elements \"vertex\""},
      {head + "end_header\n0 0 nan\n", "line 8: expected the numbers of the next element"},
      {head + "end_header\n0 0 0\n0 0 1\n", "more follows after the last element"},
      {binary_ply(std::nan("")), "a.ply: point 0 is (nan, 2, 3)"},
      {binary_ply(INFINITY), "a.ply: point 0 is (inf, 2, 3)"},
      {binary_ply(1).substr(0, binary_ply(1).size() - 1), "vertex 0: the file ends here"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_ply_points(text, "a.ply"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("sets of points are read by the extension of their file, until the control says stop") {
  const Scratch folder;
  CHECK(delref::read_point_set(folder.write("a.XYZ", "0 0 0\n")).points.size() == 1);
  CHECK(delref::read_point_set(folder.write("a.ply", text_ply(true))).points.size() == 4);
  CHECK_THROWS_MATCHES(delref::read_point_set("a.las"), delref::InvalidInput,
                       MessageMatches(ContainsSubstring("\".las\" is not the extension of a set of points; known are .xyz and .ply")));
  CHECK_THROWS_MATCHES(delref::read_point_set(folder / "none.xyz"), delref::InvalidInput, MessageMatches(ContainsSubstring("there is no such file")));
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(delref::read_point_set(folder.write("b.xyz", "0 0 0\n"), delref::Control({}, stop.get_token())), delref::Interrupted);
}
