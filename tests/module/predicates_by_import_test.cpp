// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicates are exact on nearly degenerate input when a module brings them, compiled with the importer's own flags.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

import delref;

#include "scenes.hpp"

namespace {

constexpr double grid = 0x1p-52;

/// The sign of the scalar product of a - p and b - p, of points on the grid: computed in integers.
int exact_sign(delref::Point2 a, delref::Point2 b, delref::Point2 p) {
  const auto steps = [](double difference) { return static_cast<__int128>(static_cast<std::int64_t>(difference / grid)); };
  const __int128 s = steps(a.x - p.x) * steps(b.x - p.x) + steps(a.y - p.y) * steps(b.y - p.y);
  return s > 0 ? 1 : s < 0 ? -1 : 0;
}

}  // namespace

TEST_CASE("whether a point is in a diametral circle is exact within a few ulps of it after import") {
  delref::PlanarRefinement refinement(square_with_hole());
  const auto& tr = refinement.triangulation();
  std::size_t edges = 0, wrong = 0, naive_wrong = 0;
  for (const auto f : tr.domain_faces())
    for (int k = 0; k < 3; ++k) {
      const auto e = tr.edge(f, k);
      const delref::Point2 a = tr.point(tr.source(e)), b = tr.point(tr.target(e));
      if (a.y != 0 || b.y != 0) continue;
      ++edges;
      for (double angle = 0.1; angle < 3.1; angle += 0.1)
        for (int i = -30; i <= 30; ++i)
          for (int j = -30; j <= 30; ++j) {
            const auto near = [](double x, int offset) { return (std::floor(x / grid) + offset) * grid; };
            const delref::Point2 p{near(1 + std::cos(angle), i), near(std::sin(angle), j)};
            const bool truth = exact_sign(a, b, p) < 0;
            wrong += tr.in_diametral_circle(e, p) != truth;
            naive_wrong += ((a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y) < 0) != truth;
          }
    }
  CHECK(edges == 1);
  CHECK(wrong == 0);
  CHECK(naive_wrong > 0);  // otherwise the points above test nothing
}
