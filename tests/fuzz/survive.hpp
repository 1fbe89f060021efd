// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every fuzzer does with a reader: whatever the bytes are, it must give a mesh whose indices are good, or throw InvalidInput
// with words in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <delref/domain/invalid_input.hpp>
#include <delref/io/mesh_blocks.hpp>

namespace delref_fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

inline void require(bool condition) {
  if (!condition) std::abort();
}

/// Calls `read`, which may throw InvalidInput and nothing else.
template <class Read>
void survive(Read&& read) {
  try {
    read();
  } catch (const delref::InvalidInput& error) {
    require(std::string_view(error.what()).size() > 10);
  }
}

/// Every index is one of a point, and every vector has its length or is empty.
template <delref::IndexedMesh Mesh>
void require_sound(const Mesh& mesh) {
  const auto fits = [](const auto& values, std::size_t size) { return values.empty() || values.size() == size; };
  require(fits(mesh.point_markers, mesh.points.size()) && fits(mesh.carriers, mesh.points.size()) && fits(mesh.provenance, mesh.points.size()));
  delref::detail::for_each_block(mesh, [&](const auto& block) {
    for (const auto& cell : block.cells) for (const auto v : cell) require(v < mesh.points.size());
    require(fits(block.labels, block.cells.size()));
    require(block.elements == nullptr || fits(*block.elements, block.cells.size()));
  });
}

}  // namespace delref_fuzz
