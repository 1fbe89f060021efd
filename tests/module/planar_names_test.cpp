// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each name of the module delref's planar meshing, used once, by a program that only imports.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

import delref;

#include "scenes.hpp"

using Catch::Approx;

TEST_CASE("a domain is meshed, judged and verified by import") {
  const delref::Pslg pslg = square_with_hole();
  delref::PlanarOptions options;
  options.min_angle = delref::AngleBound::degrees(25);
  options.max_area = 0.02;
  options.encroachment = delref::Encroachment::circle;
  options.points = delref::PointChoice::off_centre;
  const delref::PlanarResult result = delref::mesh_planar(pslg, options);
  REQUIRE(result.outcome.complete());
  CHECK(result.outcome.unmet.empty());

  const delref::PlanarQuality quality = delref::planar_quality(result.mesh);
  CHECK(quality.total_area == Approx(3));
  CHECK(quality.smallest_angle >= 25);
  CHECK(delref::quality_table(quality).find("triangles") != std::string::npos);
  CHECK_FALSE(delref::histogram_text(quality.smallest_angles, quality.degrees_per_bin).empty());
  const auto [a, b, c] = result.mesh.triangles.front();
  const delref::TriangleMeasures measures(result.mesh.points[a], result.mesh.points[b], result.mesh.points[c]);
  CHECK(measures.area() > 0);
  CHECK(delref::angle_degrees(delref::Vector2{1, 0}, delref::Vector2{0, 1}) == Approx(90));

  delref::PlanarCriteria criteria;
  criteria.min_angle_degrees = 25;
  criteria.max_area = 0.02;
  criteria.circle = true;
  const delref::VerifyReport report = delref::verify_planar(pslg, result.mesh, criteria);
  INFO(delref::verify_table(report));
  CHECK(report.ok());
  const delref::Finding& finding = report.findings.front();
  CHECK(finding.status == delref::CheckStatus::passed);
}

TEST_CASE("a refinement is stopped, looked at, gone on with and added to by import") {
  delref::PlanarRefinement refinement(square_with_hole());
  CHECK(refinement.step() == delref::Step::inserted);
  CHECK_FALSE(refinement.mesh().triangles.empty());
  CHECK(refinement.refine().complete());
  delref::Pslg extra;
  extra.points = {{0.25, 0.75}};
  refinement.add(extra);
  CHECK(refinement.refine().complete());
  CHECK(refinement.done());
}

TEST_CASE("criteria are asked by import") {
  const delref::TriangleShape t({0, 0}, {1, 0}, {0, 1}, 1);
  CHECK(delref::MinimumAngle{}.is_met(t));
  CHECK_FALSE(delref::MaximumArea{0.1}.is_met(t));
  CHECK(delref::MaximumEdge{2}.is_met(t));
  const std::vector<delref::Pslg::Region> regions{{{0, 0}, 0, 0}, {{1, 1}, 7, 0.1}};
  CHECK_FALSE(delref::MaximumRegionArea(regions).is_met(t));

  const auto field = [](delref::Point2) { return 1.0; };
  static_assert(delref::SizingField2<decltype(field)>);
  delref::explain_sizing_field<decltype(field)>();
  CHECK(delref::checked_size(field, delref::Point2{0, 0}) == 1);
  CHECK_FALSE(delref::SizeAtCentroid(field).is_met(t));
  const std::vector<delref::Point2> places{{0, 0}};
  const std::vector<double> sizes{0.5};
  CHECK(delref::PointSizing2(places, sizes, 1.0)({3, 4}) == 5.5);

  static_assert(delref::explain_encroachment<delref::DiametralCircle, delref::ConstrainedDelaunay2<>>());
  static_assert(delref::explain_point_choice<delref::Circumcentre>());
  static_assert(delref::TriangleCriterion<delref::MaximumArea> && delref::explain_triangle_criterion<delref::MaximumArea>());
  const delref::TriangleCriteria both(delref::MinimumAngle{}, delref::MaximumArea{0.1});
  static_assert(std::same_as<decltype(both), const delref::SimplexCriteria<delref::TriangleShape, delref::MinimumAngle, delref::MaximumArea>>);
  static_assert(delref::SimplexCriterion<delref::MaximumArea, delref::TriangleShape>);
  static_assert(delref::explain_criterion<delref::TriangleShape, delref::MaximumArea>());
  CHECK(both.unmet(t) == "maximum area");
}

TEST_CASE("input is checked by import, and refused in words") {
  CHECK_THROWS_AS(delref::AngleBound::degrees(60), delref::InvalidInput);
  delref::Pslg bowtie;
  bowtie.points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  bowtie.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const delref::CheckedPslg checked = delref::check_pslg(bowtie, delref::PslgCheckOptions{}, delref::Control{});
  const std::vector<delref::Defect> defects = delref::find_crossings(checked, delref::Control{});
  REQUIRE(defects.size() == 1);
  CHECK_FALSE(delref::all_collinear(bowtie.points, delref::Control{}));
  CHECK(delref::describe(delref::Point2{0.5, 0.5}) == "(0.5, 0.5)");
  CHECK_THROWS_AS(delref::mesh_planar(bowtie, {}), delref::InvalidInput);
}

TEST_CASE("texts are parsed by import, and what is no mesh is refused") {
  const delref::PslgFile geojson =
      delref::parse_geojson(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})", "text");
  CHECK(geojson.pslg.segments.size() == 3);
  CHECK(delref::parse_triangle_node("1 2 0 0\n0 1.5 2.5\n", "text").points.front() == delref::Point2{1.5, 2.5});
  const std::vector<delref::LabelledPolygon> polygons{{3, 0, {{{0, 0}, {1, 0}, {0, 1}}}}};
  CHECK(delref::polygons_to_pslg(polygons).pslg.points.size() == 3);
  const delref::TriangleMeshText mesh{"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", "1 3 0\n0 0 1 2\n", "", ""};
  CHECK(delref::parse_triangle_mesh(mesh, "text").triangles.size() == 1);
  CHECK_THROWS_AS(delref::parse_vtu("nothing", "text"), delref::InvalidInput);
  CHECK_THROWS_AS(delref::parse_msh("nothing", "text"), delref::InvalidInput);
  CHECK_THROWS_AS(delref::read_geojson("there_is_no_such_file.geojson"), delref::InvalidInput);
}

TEST_CASE("files are written and read by import") {
  const delref::Pslg pslg = square_with_hole();
  const delref::PlanarResult result = delref::mesh_planar(pslg, {});
  delref::PlanarFileContext context;
  context.input = &pslg;
  const delref::SvgOptions picture{delref::SvgColouring::region, 500, "a picture", {}};
  context.picture = picture;
  for (const char* name : {"module_test.node", "module_test.vtu", "module_test.msh", "module_test.mesh", "module_test.off", "module_test.svg"}) {
    delref::check_planar_output(name);
    delref::write_planar_mesh(name, result.mesh, context);
    CHECK_FALSE(delref::planar_mesh_files(name).empty());
  }
  CHECK_THROWS_AS(delref::check_planar_output("module_test.unknown"), delref::OutputError);
  delref::write_triangle_mesh("module_test_again.node", result.mesh, pslg);
  delref::write_vtu("module_test_again.vtu", result.mesh);
  delref::write_msh("module_test_again.msh", result.mesh);
  delref::write_medit("module_test_again.mesh", result.mesh);
  delref::write_off("module_test_again.off", result.mesh);
  delref::write_svg("module_test_again.svg", result.mesh, picture);

  CHECK(delref::read_triangle_mesh("module_test.ele").triangles == result.mesh.triangles);
  CHECK(delref::read_vtu("module_test.vtu").triangles == result.mesh.triangles);
  CHECK(delref::read_msh("module_test.msh").points == result.mesh.points);
  CHECK(delref::read_planar_mesh("module_test_again.vtu").points == result.mesh.points);
  CHECK(delref::read_triangle_poly("module_test.poly").holes == pslg.holes);
  CHECK(delref::read_pslg("module_test.poly").pslg.holes == pslg.holes);
  CHECK(delref::read_triangle_node("module_test.node").points.size() == result.mesh.points.size());
}

TEST_CASE("a report is written and read by import") {
  delref::RunReport report;
  report.options = delref::ReportedOptions{};
  report.options.min_angle_degrees = 20;
  report.input = delref::ReportedCounts{4, 4, 0, 0, 0};
  report.outcome.levels.push_back({"edges", 1, 0, 0, 0});
  CHECK(delref::parse_report(delref::report_text(report), "text").options.min_angle_degrees == 20);
  delref::write_report("module_test.json", report);
  const delref::ReportedPromise promise = delref::read_report("module_test.json");
  CHECK(promise.level_names == std::vector<std::string>{"edges"});
}
