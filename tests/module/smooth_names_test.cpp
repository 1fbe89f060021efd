// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each name of the module delref's meshing of smooth domains, used by a program that only imports: the short way for functions, images
// and sets of points, an oracle and a criterion of one's own, and the level put together by hand.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

import delref;

using Catch::Approx;
using delref::Point3;

namespace {

double ball(Point3 p) { return p.x * p.x + p.y * p.y + p.z * p.z - 1; }
const delref::BoundingBox3 box{{-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}};

/// A ball of two regions, told by their radii: an oracle of one's own.
struct Onion {
  delref::BoundingBox3 bounds() const { return box; }
  static int region(Point3 p) {
    const double r = std::hypot(p.x, p.y, p.z);
    return r < 0.5 ? 0 : r < 1 ? 1 : delref::outside;
  }
  void label(std::span<const Point3> points, std::span<int> labels) const { std::ranges::transform(points, labels.begin(), region); }
  Point3 crossing(Point3 a, Point3 b, int label_a, double tolerance) const {
    while (squared_distance(a, b) > tolerance * tolerance) {
      const Point3 m = midpoint(a, b);
      if (squared_distance(m, a) <= 0 || squared_distance(m, b) <= 0) break;
      (region(m) == label_a ? a : b) = m;
    }
    return midpoint(a, b);
  }
};
static_assert(delref::Oracle<Onion> && delref::explain_oracle<Onion>() && !delref::FindsComponents<Onion>);

/// No facet is longer along z than so much: a criterion of one's own.
struct FacetHeight {
  static constexpr std::string_view name = "facet height";
  static constexpr bool bounds_size = true;
  double most = 1;
  bool is_met(const delref::SurfaceFacetShape& f) const {
    const auto [low, high] = std::ranges::minmax(f.corners, {}, &Point3::z);
    return high.z - low.z <= most;
  }
};
static_assert(delref::SurfaceFacetCriterion<FacetHeight> && delref::explain_surface_facet_criterion<FacetHeight>());

/// The ball with bounds of its values: for many points, and with a proof.
struct RangedBall {
  double operator()(Point3 p) const { return ball(p); }
  void operator()(std::span<const Point3> points, std::span<double> values) const { std::ranges::transform(points, values.begin(), ball); }
  delref::ValueRange range(const delref::BoundingBox3& b) const {
    const auto most = [](double low, double high) { return std::max(low * low, high * high); };
    const auto least = [](double low, double high) { return low <= 0 && high >= 0 ? 0 : std::min(low * low, high * high); };
    return {least(b.low.x, b.high.x) + least(b.low.y, b.high.y) + least(b.low.z, b.high.z) - 1,
            most(b.low.x, b.high.x) + most(b.low.y, b.high.y) + most(b.low.z, b.high.z) - 1};
  }
  bool is_regular(const delref::BoundingBox3&) const { return false; }
};
static_assert(delref::PointFunction<RangedBall> && delref::BatchFunction<RangedBall> && delref::RangedFunction<RangedBall> &&
              delref::RegularFunction<RangedBall> && delref::ImplicitFunction<RangedBall> && delref::explain_implicit_function<RangedBall>());

delref::SmoothOptions coarse() {
  delref::SmoothOptions options;
  options.facet_size = 0.4;
  options.facet_angle = delref::AngleBound::degrees(30);
  return options;
}

/// A ball of radius 4 voxels, brightest in the middle.
delref::Image<float> bright_ball() {
  delref::Image<float> image;
  image.grid.size = {11, 11, 11};
  for (int z = 0; z < 11; ++z)
    for (int y = 0; y < 11; ++y)
      for (int x = 0; x < 11; ++x) image.values.push_back(static_cast<float>(5 - std::hypot(x - 5, y - 5, z - 5)));
  return image;
}

}  // namespace

TEST_CASE("a function is meshed, judged, verified, written and read by import") {
  const delref::ImplicitDomain domain(RangedBall{}, box, {delref::AtBounds::refused, 0.1});
  delref::SmoothOptions options = coarse();
  delref::check_smooth_options(options);
  options.cell_size_field = [](Point3) { return 0.4; };
  delref::SmoothRefinement refinement(domain, options);
  const auto outcome = refinement.refine();
  REQUIRE(outcome.complete());
  CHECK(outcome.unmet.empty());
  const delref::ComponentCounts& components = refinement.components();
  CHECK(components.found == 1);
  CHECK(components.missed == 0);
  const delref::TetrahedralMesh mesh = refinement.mesh();

  const delref::SurfaceQuality quality = delref::surface_quality(mesh);
  CHECK(quality.euler_characteristic() == 2);
  CHECK(quality.smallest_angle >= 30);
  CHECK(!delref::quality_table(quality).empty());
  delref::SmoothExpectations expected;
  expected.components = 1;
  const delref::VerifyReport report = delref::verify_smooth(domain, mesh, refinement.options(), expected);
  INFO(delref::verify_table(report));
  CHECK(report.ok());
  REQUIRE(report.surfaces.size() == 1);
  const delref::SurfacePiece& piece = report.surfaces.front();
  CHECK(piece.volume > 3);

  REQUIRE(delref::is_surface_format("module_test_smooth.off"));
  delref::write_surface("module_test_smooth.off", mesh);
  CHECK(delref::read_plc("module_test_smooth.off").plc.facets.size() == mesh.triangles.size());
}

TEST_CASE("what is known of a function is asked by import") {
  CHECK(delref::function_value(RangedBall{}, {2, 0, 0}) == 3);
  std::array<double, 2> values{};
  const std::array<Point3, 2> points{{{0, 0, 0}, {1, 0, 0}}};
  delref::function_values(RangedBall{}, points, values);
  CHECK(values[0] == -1);
  CHECK(values[1] == 0);
  CHECK(delref::proved_inside(RangedBall{}.range({{0, 0, 0}, {0.1, 0.1, 0.1}})) == std::optional(true));
  CHECK((delref::Interval(-1, 2) + delref::Interval(1, 1)).high() == Approx(3));
  CHECK(delref::bracketed_root([](double t) { return t * t - 2; }, 1, -1, 2, 2, 1e-12) == Approx(std::sqrt(2)));
  CHECK(delref::sign_change(ball, box, {0, 0, 0}, {1.5, 0, 0}, 1e-9).x == Approx(1));
  CHECK(delref::rounding_near(Point3{1, 1, 1}) > 0);
  CHECK(squared_length(delref::to_circumcentre(delref::Vector3{2, 0, 0}, delref::Vector3{0, 2, 0})) == Approx(2));
  CHECK(delref::default_samples > 1);
}

TEST_CASE("several functions make several regions by import") {
  using Function = std::function<double(Point3)>;
  const delref::SignVector both = 3;
  const delref::MultiMaterialDomain<Function> domain({ball, [](Point3 p) { return p.z; }}, box, {1, both});
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, [] {
    delref::SmoothOptions options = coarse();
    options.smallest_facet = 0.05;  // there is a crease where the regions meet
    return options;
  }());
  CHECK(result.outcome.complete());
  CHECK(result.patches == std::vector<delref::SurfacePatch>{{{0, -1}}, {{1, -1}}, {{1, 0}}});
}

TEST_CASE("components are found by import") {
  const delref::Control control;
  CHECK(delref::sample_components(Onion{}, 0.1, control).components.size() == 2);
  const auto nothing_is_proved = [](const delref::BoundingBox3&) { return std::optional<int>(); };
  delref::SurfaceComponents found = delref::interval_components(Onion{}, 0.2, control, nothing_is_proved);
  CHECK(found.components.size() == 2);
  CHECK(delref::spread_points(found.components.front(), 3).size() == 3);
  CHECK(delref::bounding_box_3(found.components.front()).extent() > 0.5);
  const Onion onion;
  const delref::AnchorPoints anchors = delref::AnchorFinder(onion, 1e-3, 1e-3, 1).around({1, 0, 0});
  CHECK(!anchors.points.empty());
}

TEST_CASE("images are meshed by import") {
  const delref::Image<float> image = bright_ball();
  delref::check_image(image);
  delref::check_grid(image.grid);
  CHECK(delref::longest_image_axis > 11);
  const delref::ImageGrid& grid = delref::grid_of(delref::AnyImage(image));
  CHECK(squared_distance(delref::WorldToIndex(image.grid)({1, 2, 3}), {1, 2, 3}) < 1e-20);
  CHECK(image.grid.voxels() == 1331);
  static_cast<void>(grid);

  delref::GreyLevelOptions how;
  how.close_at_border = true;
  const delref::GreyLevelImage grey(image, 1.25, how);
  const std::vector<delref::LevelSetComponent> pieces = grey.level_set();
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].euler_characteristic == 2);
  CHECK(delref::level_set_components(image.grid, std::span(image.values), 1.25, delref::Control{}).size() == 1);
  delref::SmoothOptions options;
  options.facet_size = 2;
  CHECK(delref::mesh_smooth_domain(grey, options).outcome.complete());

  delref::Image<std::int32_t> labels{image.grid, {}};
  for (const float v : image.values) labels.values.push_back(v > 3 ? 7 : v > 1.25F ? 5 : 0);
  delref::LabelOptions smoothed;
  smoothed.smoothing = 1;
  const delref::LabelledImage regions(labels, smoothed);
  CHECK(delref::region_labels(regions, 2) == std::vector<int>{5, 7});
  const delref::SmoothResult result = delref::mesh_smooth_domain(regions, options);
  CHECK(std::ranges::count(result.mesh.regions, 7) > 0);
}

TEST_CASE("a set of points is read and meshed by import") {
  std::string text;
  for (int i = 0; i < 400; ++i) {  // a spiral on a sphere, as uneven as a scanner would have it
    const double z = 1 - (2 * i + 1) / 400.0, r = std::sqrt(1 - z * z), turn = 2.4 * i, off = 1 + 0.01 * std::sin(7.0 * i);
    for (const double c : {r * std::cos(turn), r * std::sin(turn), z}) text += std::to_string(off * c) + " ";
    text += "\n";
  }
  const delref::PointSet set = delref::parse_xyz(text, "sphere.xyz");
  CHECK(set.points.size() == 400);
  CHECK_THROWS_AS(delref::read_point_set("no_such_file.xyz"), delref::InvalidInput);
  CHECK_THROWS_AS(delref::parse_ply_points("ply\n", "short.ply"), delref::InvalidInput);
  delref::PointSetOptions how;
  how.neighbours = 12;
  const delref::PointSetDomain domain(set, how);
  delref::SmoothOptions options;
  options.surface_only = true;
  options.facet_size = domain.default_facet_size();
  const delref::SmoothResult result = delref::mesh_smooth_domain(domain, options);
  CHECK(result.outcome.complete());
  CHECK(delref::surface_quality(result.mesh).euler_characteristic() == 2);
}

TEST_CASE("an oracle of one's own is meshed by import") {
  std::vector<std::string> notes;
  delref::SmoothOptions options = delref::with_default_sizes(coarse(), box, notes);
  options.facet_distance = 0.02;
  CHECK(options.smallest_facet > 0);
  const delref::SmoothResult result = delref::mesh_smooth_domain(Onion{}, options);
  CHECK(result.outcome.complete());
  CHECK(result.patches.size() == 2);
  CHECK(delref::tetrahedral_quality(result.mesh).total_volume == Approx(4.19).epsilon(0.05));
}

TEST_CASE("the levels of smooth domains are put together by import, with an oracle and a criterion of one's own") {
  using Tr = delref::Delaunay3<1, 1>;
  const Onion domain;
  const delref::Control control;
  delref::PolyhedralDomain first;
  for (const double x : {-5, 5})
    for (const double y : {-5, 5})
      for (const double z : {-5, 5}) first.points.push_back({x, y, z});
  for (const auto& seeds : delref::sample_components(domain, 0.1, control).components)
    first.points.insert(first.points.end(), seeds.begin(), seeds.end());
  Tr tr;
  const auto vertices = delref::insert_input_points(tr, first, control);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    tr.set_origin(vertices[i], i < 8 ? delref::Carrier{} : delref::Carrier{2, 0}, delref::input_level);

  using Criteria = delref::SurfaceFacetCriteria<delref::MinimumFacetAngle, delref::MaximumFacetSize, delref::MaximumFacetDistance, FacetHeight,
                                                delref::FacetSizeAtCentre<double (*)(Point3)>, delref::FacetDistanceAtCentre<double (*)(Point3)>>;
  const auto one = [](Point3) { return 1.0; };
  const Criteria criteria({}, {0.5}, {0.1}, {0.3}, {one}, {one});
  delref::SurfaceLevelOptions how;
  how.smallest_radius = 1e-3;
  using Tetrahedra = delref::TetrahedraLevel3<Tr, delref::TetrahedronCriteria<delref::RadiusEdge, delref::MaximumRegionCircumradius>,
                                              delref::LabelledCells<Tr>>;
  const delref::TetrahedronCriteria cells(delref::RadiusEdge{2}, delref::MaximumRegionCircumradius{{0.3, 0.6}});
  delref::Mesher mesher(tr, std::tuple(delref::SurfaceLevel3<Tr, Onion, Criteria>(domain, criteria, how), Tetrahedra(cells, {})));
  const auto outcome = mesher.refine(control);
  CHECK(outcome.complete());
  CHECK(outcome.unmet.empty());

  const delref::SurfaceComplex<Tr>& complex = mesher.level<0>().complex();
  std::size_t tall = 0;
  complex.for_each([&](const auto& r) {
    const auto [a, b, c] = tr.vertices(r.facet);
    if (!FacetHeight{0.3}.is_met({{tr.point(a), tr.point(b), tr.point(c)}, r.centre, r.regions})) ++tall;
  });
  CHECK(tall == 0);
  const auto patches = delref::surface_patches(complex);
  const delref::TetrahedralMesh mesh = delref::extract_smooth_mesh(tr, complex, patches, {1, 2}, false, {"surface", "tetrahedra"});
  CHECK(delref::surface_quality(mesh).border_edges == 0);
}

TEST_CASE("the stacks of smooth domains and what they are made of have names") {
  using Tr = delref::Delaunay3<1, 1>;
  const Onion domain;
  CHECK(std::tuple_size_v<decltype(delref::surface_levels<Tr>(domain, coarse()))> == 1);
  CHECK(std::tuple_size_v<decltype(delref::volume_levels<Tr>(domain, coarse()))> == 2);
  const delref::CellLabels<Tr, Onion> labels(domain);
  static_cast<void>(labels);
  delref::Umbrella umbrella;
  for (const auto& [from, to] : {std::pair(1U, 2U), std::pair(2U, 3U), std::pair(3U, 1U)}) umbrella.add({0, -1}, from, to);
  CHECK(umbrella.is_disk());
  delref::RegionRepair<Tr> repair;
  const delref::PolyhedralDomain nothing;
  const delref::SmallAngleGuard guard(nothing);
  const delref::PolyhedralCells<Tr> rules(repair, guard);
  CHECK(!rules.may_be_inside(Tr(), Tr().infinite_cell()));
}

TEST_CASE("what a run tells of a smooth domain has names in a report") {
  delref::PolyhedralRunReport report;
  report.surface = delref::ReportedSurface{};
  report.surface->patches.push_back(delref::ReportedPatch{});
  report.surface->boundaries.push_back(delref::ReportedBoundary{});
  report.options.smooth = delref::ReportedSmoothOptions{};
  CHECK(delref::report_text(report).find("surface") != std::string::npos);
}
