// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/report_json.hpp>
#include <delref/io/smallest_angles.hpp>
#include <delref/io/svg.hpp>

#include "scratch.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using delref_test::Scratch;

namespace {

delref::RunReport sample_report() {
  delref::RunReport report;
  report.input_file = "coast \"1\".poly";
  report.options.min_angle_degrees = 20.7;
  report.options.max_area = 0.1;
  report.options.encroachment = "lens";
  report.outcome.levels = {{.name = "edges"}, {.name = "faces", .inserted = 12}};
  for (int i = 0; i != 3; ++i) {
    delref::Unmet<delref::Point2> unmet;
    unmet.level = 1;
    unmet.criterion = "minimum angle";
    unmet.reason = i == 1 ? delref::Reason::precision : delref::Reason::small_input_angle;
    unmet.place = {1.0 / 3 + i, -1e-150};
    report.outcome.unmet.push_back(unmet);
  }
  report.seconds = {{"refining", 1.5}};
  return report;
}

}  // namespace

TEST_CASE("the smallest angle is right for every order of the corners and every size") {
  for (const double size : {1e-150, 1.0, 1e150}) {
    delref::PlanarMesh mesh;
    mesh.points = {{0, 0}, {2 * size, 0}, {0, size}};
    mesh.triangles = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 0, 1}};
    const delref::SmallestAngles angles(mesh);
    for (std::size_t i = 0; i != 3; ++i) CHECK(angles(i) == Catch::Approx(26.56505117707799));
    CHECK(angles(3) == 0);
  }
}

TEST_CASE("a picture of a mesh that is unmet as a rule keeps its colours and outlines what is unmet") {
  const Scratch folder;
  delref::PlanarMesh mesh;
  std::vector<delref::Unmet<delref::Point2>> unmet;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const double x = 3.0 * i;
    mesh.points.insert(mesh.points.end(), {{x, 0}, {x + 3, 0}, {x, 3}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    unmet.emplace_back().place = {x + 1, 1};
  }
  delref::SvgOptions options;
  options.unmet = unmet;
  delref::write_svg(folder / "m.svg", mesh, options);
  const std::string text = delref::read_file(folder / "m.svg");
  CHECK_THAT(text, ContainsSubstring("fill=\"none\" stroke=\"#d6006c\" d=\"m"));
  CHECK_THAT(text, !ContainsSubstring("fill=\"#d6006c\""));
  CHECK_THAT(text, ContainsSubstring("60 unmet"));
}

TEST_CASE("a picture has every triangle and marks what is unmet") {
  const Scratch folder;
  delref::PlanarMesh mesh;
  mesh.points = {{0, 0}, {9, 0}, {9, 6}, {0, 6}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.edges = {{0, 1}};
  delref::SvgOptions options;
  options.title = "a < b & c";
  std::vector<delref::Unmet<delref::Point2>> unmet(1);
  unmet[0].place = {6, 2};
  options.unmet = unmet;
  delref::write_svg(folder / "m.svg", mesh, options);
  const std::string text = delref::read_file(folder / "m.svg");
  CHECK_THAT(text, ContainsSubstring("fill=\"#d6006c\" stroke=\"#d6006c\" d=\"m"));
  CHECK_THAT(text, ContainsSubstring("z\" />"));
  CHECK_THAT(text, ContainsSubstring("a &lt; b &amp; c"));
  CHECK_THAT(text, ContainsSubstring("1 unmet"));
  CHECK_THAT(text, ContainsSubstring("2 triangles, 4 vertices, smallest angle 33.7"));
  delref::write_svg(folder / "empty.svg", {});
}

TEST_CASE("the promise of a report is read back, with places to the last digit") {
  const delref::RunReport report = sample_report();
  const delref::ReportedPromise promise = delref::parse_report(delref::report_text(report), "r.json");
  CHECK(promise.input_file == report.input_file);
  CHECK(promise.options == report.options);
  CHECK(promise.complete);
  REQUIRE(promise.unmet.size() == 3);
  CHECK(promise.unmet[0].level == 1);
  CHECK(promise.unmet[0].criterion == "minimum angle");
  CHECK(promise.unmet[0].reason == delref::Reason::small_input_angle);
  CHECK(promise.unmet[0].place == report.outcome.unmet[0].place);
  CHECK(promise.unmet[1].place == report.outcome.unmet[2].place);
}

TEST_CASE("all that differs between two runs is in the times") {
  delref::RunReport report = sample_report();
  const std::string once = delref::report_text(report);
  report.seconds = {{"refining", 99}};
  const std::string again = delref::report_text(report);
  CHECK(once.substr(0, once.find("\"times\"")) == again.substr(0, again.find("\"times\"")));
  CHECK(once != again);
}

TEST_CASE("what is no report is refused in words") {
  CHECK_THROWS_MATCHES(delref::parse_report("{}", "r.json"), delref::InvalidInput, MessageMatches(ContainsSubstring("r.json: is not a report of delref")));
  CHECK_THROWS_MATCHES(delref::parse_report("[", "r.json"), delref::InvalidInput, MessageMatches(ContainsSubstring("is not JSON")));
}
