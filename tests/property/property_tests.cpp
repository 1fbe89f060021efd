// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of every mesh, tried on generated graphs: the verification, which shares nothing with the mesher, finds every
// promise kept; the run ends; the same input gives the same bytes; and so it is after vertices and segments were added.
#include <algorithm>
#include <string_view>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_range.hpp>

#include "additions.hpp"
#include "generators.hpp"
#include "promises.hpp"

using namespace delref;
using namespace delref::property;

namespace {

bool same_bytes(const PlanarMesh& a, const PlanarMesh& b) {
  return a.points == b.points && a.triangles == b.triangles && a.edges == b.edges && a.carriers == b.carriers &&
         a.provenance == b.provenance && a.regions == b.regions && a.edge_segments == b.edge_segments &&
         a.point_markers == b.point_markers && a.edge_markers == b.edge_markers;
}

/// Input in which there is less room than rounding needs: what is unmet there for want of precision is listed, and allowed.
bool is_at_the_limits(std::string_view name) {
  return name.starts_with("fan") || name.starts_with("needle") || name.starts_with("dirty_coast");
}

Control bounded(std::size_t max_vertices) {
  Budget budget;
  budget.max_vertices = max_vertices;
  return Control(budget);
}

}  // namespace

TEST_CASE("A mesh of a generated graph is what was promised") {
  const auto& mode = modes[GENERATE(range(std::size_t{0}, modes.size()))];
  CAPTURE(mode.name);
  for (std::uint64_t seed = 0; seed < seed_count(200); ++seed) {
    const NamedPslg input = generate(seed);
    CAPTURE(input.name, seed);
    const PlanarOptions options = mode.options(input.pslg);
    const PlanarResult result = mesh_planar(input.pslg, options, bounded(400'000));
    CHECK(result.outcome.complete());
    CHECK(broken_promises(input.pslg, result.mesh, promises(options, result.outcome)) == "");
    if (!is_at_the_limits(input.name)) CHECK(result.outcome.unmet.size() == result.outcome.unmet_count(Reason::small_input_angle));
  }
}

TEST_CASE("The same graph gives the same mesh twice") {
  for (std::uint64_t seed = 0; seed < seed_count(200) / 4; ++seed) {
    const NamedPslg input = generate(seed);
    CAPTURE(input.name);
    const PlanarOptions options = modes[seed % modes.size()].options(input.pslg);
    CHECK(same_bytes(mesh_planar(input.pslg, options).mesh, mesh_planar(input.pslg, options).mesh));
  }
}

TEST_CASE("A mesh is what was promised for all that was given after vertices, segments and seeds were added again and again") {
  std::size_t added = 0;
  for (std::uint64_t seed = 0; seed < seed_count(200); ++seed) {
    const NamedPslg input = generate(seed);
    const Mode& mode = modes[(seed / generators().size()) % modes.size()];
    CAPTURE(input.name, seed, mode.name);
    const PlanarOptions options = mode.options(input.pslg);
    PlanarRefinement refinement(input.pslg, options);
    // A segment across a needle of 1e-9 degrees leaves two segments side by side, 1e-11 apart: only the budget ends that.
    const std::size_t most = is_at_the_limits(input.name) ? 20'000 : 400'000;
    refinement.refine(bounded(most));
    for (std::uint64_t round = 0; round < 3; ++round) {
      CAPTURE(round);
      const PlanarMesh before = refinement.mesh();
      try {
        refinement.add(addition(before, 1000 * seed + round));
      } catch (const InvalidInput& refusal) {
        CAPTURE(refusal.what());
        CHECK(same_bytes(before, refinement.mesh()));
        continue;
      }
      ++added;
      const bool complete = refinement.refine(bounded(most)).complete();
      CHECK((complete || is_at_the_limits(input.name)));
      CHECK(broken_promises(refinement, options, is_at_the_limits(input.name)) == "");
    }
  }
  CHECK(added > seed_count(200));  // of three times as many
}
