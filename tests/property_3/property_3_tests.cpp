// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of every mesh of space, tried on generated complexes: the verification, which shares nothing with the mesher, finds
// every promise kept; nothing is given up but what a small input angle forces; the volume is that of the domain; the same input
// gives the same bytes.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/invalid_input.hpp>

#include "generators.hpp"
#include "meshing.hpp"

using namespace delref;
using namespace delref::property_3;
using Catch::Approx;

namespace {

constexpr std::size_t most_vertices = 20'000;

/// How many seeds each property is tried on: the environment variable DELREF_SEEDS, or `usual`.
std::uint64_t seed_count(std::uint64_t usual) {
  const char* given = std::getenv("DELREF_SEEDS");
  return given ? std::strtoull(given, nullptr, 10) : usual;
}

/// Every complex gets another bound when its turn comes again.
PolyhedralOptions options_for(const NamedComplex& input, std::uint64_t seed) {
  PolyhedralOptions options;
  const double extent = bounding_box_3(input.complex.plc.points).extent();
  switch ((seed / generator_count()) % 4) {
    case 1: options.cell_size = 0.15 * extent; break;
    case 2: options.max_volume = 1e-3 * extent * extent * extent; break;
    case 3:
      options.size = [centre = input.complex.plc.points.front(), extent](Point3 p) {
        return 0.05 * extent + 0.3 * std::sqrt(squared_distance(centre, p));
      };
      break;
    default: break;
  }
  return options;
}

}  // namespace

TEST_CASE("A mesh of a generated complex is what was promised") {
  std::size_t stopped = 0;
  const std::uint64_t count = seed_count(240);
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const NamedComplex input = generate(seed);
    CAPTURE(input.name, seed);
    const PolyhedralOptions options = options_for(input, seed);
    const Meshed result = meshed(input.complex.plc, options, most_vertices);
    if (result.outcome.stopped) ++stopped;
    CHECK((result.conforms || result.outcome.stopped));
    if (!result.conforms) continue;
    CHECK(broken_promises(input.complex.plc, options, result) == "");
    if (!result.outcome.stopped) CHECK(result.not_excused() == "");
    if (input.complex.volume) CHECK(volume(result.mesh) == Approx(*input.complex.volume).epsilon(1e-8));
  }
  CHECK(stopped <= count / 10);
}

TEST_CASE("The same complex gives the same mesh twice") {
  for (std::uint64_t seed = 0; seed < seed_count(240) / 4; ++seed) {
    const NamedComplex input = generate(seed);
    CAPTURE(input.name);
    const PolyhedralOptions options = options_for(input, seed);
    CHECK(same_bytes(meshed(input.complex.plc, options, most_vertices).mesh, meshed(input.complex.plc, options, most_vertices).mesh));
  }
}
