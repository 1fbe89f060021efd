// SPDX-License-Identifier: GPL-3.0-or-later
//
// Level sets counted by brute force: marching tetrahedra on a grid so fine that nothing depends on how a cube is read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/domain/disjoint_sets.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/trilinear.hpp>

namespace delref_test {

/// What can be told of a level set by counting.
struct Topology {
  std::int64_t components = 0, euler_characteristic = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

/// The topology of the boundary of { trilinear value >= iso }, closed at the border, sampled `fineness` times between voxels.
inline Topology topology_by_tetrahedra(const delref::Image<float>& image, double iso, int fineness) {
  const auto size = [&](std::size_t i) { return static_cast<std::size_t>((image.grid.size[i] - 1) * fineness + 3); };
  const std::array<std::size_t, 3> n{size(0), size(1), size(2)};
  const std::array<std::size_t, 3> step{1, n[0], n[0] * n[1]};
  std::vector<bool> inside(n[0] * n[1] * n[2]);
  const delref::detail::Trilinear value(image.grid, image.values.data());
  for (std::size_t z = 1; z + 1 < n[2]; ++z) {
    for (std::size_t y = 1; y + 1 < n[1]; ++y) {
      for (std::size_t x = 1; x + 1 < n[0]; ++x) {
        const auto at = [&](std::size_t i) { return static_cast<double>(i - 1) / fineness; };
        inside[x + y * step[1] + z * step[2]] = value({at(x), at(y), at(z)}) >= iso;
      }
    }
  }
  // Kuhn's six tetrahedra of a cube: from corner 0 to corner 7 by one axis after the other. An edge is its lower end and its direction.
  constexpr std::array<std::array<std::size_t, 3>, 6> orders{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  delref::DisjointSets sets;
  std::vector<std::uint32_t> node(8 * inside.size(), 0);
  std::int64_t corners_of_pieces = 0, pieces = 0;
  for (std::size_t z = 0; z + 1 < n[2]; ++z) {
    for (std::size_t y = 0; y + 1 < n[1]; ++y) {
      for (std::size_t x = 0; x + 1 < n[0]; ++x) {
        for (const auto& order : orders) {
          std::array<std::size_t, 4> vertex{x + y * step[1] + z * step[2]}, bits{};
          for (std::size_t i = 0; i != 3; ++i) vertex[i + 1] = vertex[i] + step[order[i]], bits[i + 1] = bits[i] | std::size_t{1} << order[i];
          std::uint32_t first = 0;
          for (std::size_t i = 0; i != 4; ++i) {
            for (std::size_t j = i + 1; j != 4; ++j) {
              if (inside[vertex[i]] == inside[vertex[j]]) continue;
              std::uint32_t& entry = node[8 * vertex[i] + (bits[j] ^ bits[i])];
              if (entry == 0) entry = sets.add() + 1;
              if (first == 0) ++pieces, first = entry;
              sets.unite(first - 1, entry - 1);
              ++corners_of_pieces;
            }
          }
        }
      }
    }
  }
  const auto crossings = static_cast<std::int64_t>(sets.size());
  return {static_cast<std::int64_t>(sets.groups().begin.size()) - 1, crossings - corners_of_pieces / 2 + pieces};
}

}  // namespace delref_test
