// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/cut_svg.hpp>
#include <delref/io/tetrahedral_formats.hpp>

#include "../io/scratch.hpp"
#include "meshes.hpp"

using Catch::Matchers::ContainsSubstring;
using delref_test::Scratch;

namespace {

/// A row of unit cubes along the x axis, of five tetrahedra each, in two regions.
delref::TetrahedralMesh row_of_cubes(std::uint32_t count) {
  delref::TetrahedralMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = i;
    for (const delref::Point3 p : {delref::Point3{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 1, 0}, {x, 1, 0}, {x, 0, 1}, {x + 1, 0, 1}, {x + 1, 1, 1}, {x, 1, 1}})
      mesh.points.push_back(p);
    const std::uint32_t n = 8 * i;
    for (const auto& [a, b, c, d] : {std::array{0U, 1U, 2U, 5U}, {0, 2, 3, 7}, {0, 5, 7, 4}, {2, 7, 5, 6}, {0, 2, 7, 5}}) {
      mesh.tetrahedra.push_back({n + a, n + b, n + c, n + d});
      mesh.regions.push_back(i < 2 ? 1 : 2);
    }
  }
  return mesh;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::set<std::string> colours(const std::string& text) {
  std::set<std::string> result;
  for (std::size_t at = text.find("path fill=\""); at != std::string::npos; at = text.find("path fill=\"", at + 1))
    result.insert(text.substr(at + 11, 7));
  return result;
}

std::string draw(const delref::TetrahedralMesh& mesh, const delref::CutSvgOptions& options = {}) {
  const Scratch folder;
  delref::write_cut_svg(folder / "m.svg", mesh, options);
  return delref::read_file(folder / "m.svg");
}

}  // namespace

TEST_CASE("a cut takes away what is on the near side of the plane, and shows what is behind it") {
  delref::CutSvgOptions options;
  options.normal = {1, 0, 0};
  options.position = 1;
  const std::string whole = draw(row_of_cubes(4), options);
  options.position = 0.5;
  const std::string half = draw(row_of_cubes(4), options);
  // Region 1 alone is left, with the faces between the second cube and the third in the colour of the cut.
  CHECK(colours(whole).size() > colours(half).size());
  CHECK(std::ranges::any_of(colours(half), [&](const std::string& colour) { return !colours(whole).contains(colour); }));
  CHECK_THAT(half, ContainsSubstring("20 tetrahedra, 32 vertices"));
}

TEST_CASE("the faces of a picture that others hide are left out") {
  delref::CutSvgOptions options;
  options.normal = {1, 0, 0};
  options.turn = options.tilt = 0;
  options.position = 1;
  const std::string text = draw(row_of_cubes(50), options);  // seen from the end of the row
  CHECK(count_of(text, "z\"") + count_of(text, "zm") == 2);
}

TEST_CASE("regions have colours of their own, and a title is text") {
  delref::CutSvgOptions options;
  options.normal = {0, -1, 0};
  options.title = "a < b & c";
  const std::string text = draw(row_of_cubes(4), options);
  CHECK_THAT(text, ContainsSubstring("a &lt; b &amp; c"));
  delref::TetrahedralMesh one = row_of_cubes(4);
  one.regions.clear();
  CHECK(colours(text).size() > colours(draw(one, options)).size());
}

TEST_CASE("a mesh is drawn whatever its coordinates, and an empty one too") {
  CHECK_THAT(draw(delref_test::two_tetrahedra()), ContainsSubstring("2 tetrahedra, 5 vertices"));
  CHECK_THAT(draw({}), ContainsSubstring("0 tetrahedra, 0 vertices"));
  const Scratch folder;
  delref::write_tetrahedral_mesh(folder / "m.svg", row_of_cubes(3));
  CHECK_THAT(delref::read_file(folder / "m.svg"), ContainsSubstring("</svg>"));
}
