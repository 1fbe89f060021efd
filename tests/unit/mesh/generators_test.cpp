// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <catch2/catch_test_macros.hpp>

#include <delref/mesh/quality.hpp>
#include <delref/mesh/verify_planar.hpp>

#include "../../property/generators.hpp"
#include "test_mesh.hpp"

using namespace delref;
using namespace delref::property;

namespace {

struct Facts {
  std::string problem;
  bool repeated_vertex = false, overlap = false, vertex_in_segment = false;
};

/// What exact predicates say of a graph.
Facts facts(const Pslg& p) {
  const PowerOfTwoScaling scaling(largest_absolute_coordinate(p.points));
  const std::vector<Point2> points = scaling(p.points);
  const Control control;
  const verification::InputDomain domain(p, points, scaling, control);
  Facts f;
  if (!domain.problems().empty()) {
    f.problem = domain.problems()[0];
    return f;
  }
  for (verification::Index v = 0; v < points.size(); ++v) f.repeated_vertex |= domain.canonical(v) != v;
  for (const verification::Piece& piece : domain.pieces()) f.overlap |= piece.segments.size() != 1;
  f.vertex_in_segment = domain.pieces().size() != p.segments.size();
  return f;
}

}  // namespace

TEST_CASE("splitmix64 gives its published numbers") {
  Random random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
}

TEST_CASE("generated graphs have no crossings, overlaps or repeated vertices, and bound a region") {
  for (const Generator& g : generators())
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
      INFO(g.name << " " << seed);
      const Facts f = facts(g.make(seed));
      CHECK(f.problem == "");
      CHECK(!f.overlap);
      CHECK((g.has_vertices_in_segments || !f.repeated_vertex));
      CHECK((g.has_vertices_in_segments || !f.vertex_in_segment));
    }
}

TEST_CASE("a generator gives the same graph for the same seed") {
  for (const Generator& g : generators()) {
    const Pslg a = g.make(7), b = g.make(7);
    CHECK(a.points == b.points);
    CHECK(a.segments == b.segments);
    CHECK(a.segment_markers.size() == a.segments.size());
  }
}

TEST_CASE("seeds take the generators by turns and are in the name") {
  CHECK(generate(0).name == "star 0");
  CHECK(generate(generators().size() + 1).name == "comb " + std::to_string(generators().size() + 1));
}

TEST_CASE("a fan has angles down to a billionth of a degree, a dirty coast segments of 1e-14") {
  double smallest = 180, shortest = 1;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    smallest = std::min(smallest, planar_quality(testing_mesh::triangulated(needle(seed))).smallest_angle);
    const Pslg p = dirty_coast(seed);
    for (const auto& [a, b] : p.segments) shortest = std::min(shortest, std::sqrt(squared_distance(p.points[a], p.points[b])));
  }
  CHECK(smallest < 1e-8);
  CHECK(shortest < 2e-14);
}

TEST_CASE("the constrained Delaunay triangulation of a generated graph is verified") {
  for (const Generator& g : generators())
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      INFO(g.name << " " << seed);
      const Pslg p = g.make(seed);
      PlanarCriteria criteria;
      criteria.complete = false;  // nothing was refined: area bounds of regions need not be met
      const VerifyReport report = verify_planar(p, testing_mesh::triangulated(p), criteria);
      INFO(verify_table(report));
      CHECK(report.ok());
    }
}
