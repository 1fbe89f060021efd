// SPDX-License-Identifier: GPL-3.0-or-later
//
// Third step of an extension: Steiner vertices that would force tiny triangles beside what is new are left out.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <delref/domain/extension_pieces.hpp>
#include <delref/domain/extension_state.hpp>

namespace delref::detail {

/// Where a new segment meets another at a tiny angle both are to be split at the same distances from the corner.
template <class Tr>
void drop_near_tiny_angles(PlanarExtension<Tr>& x) {
  std::vector<std::pair<Pslg::Index, std::size_t>> at;
  for (std::size_t k = 0; k < x.pieces.size(); ++k)
    for (const Pslg::Index end : x.pieces[k].ends) at.emplace_back(end, k);
  std::ranges::sort(at);
  const auto arm = [&](const ExtensionPiece& piece, Pslg::Index corner) { return x.point(piece.ends[piece.ends[0] == corner ? 1 : 0]) - x.point(corner); };
  const auto drop = [&](const ExtensionPiece& piece, Pslg::Index corner, double squared_reach) {
    for (const std::uint32_t v : piece.chain)
      if (squared_distance(x.steiner[v].point, x.point(corner)) <= squared_reach) x.steiner[v].dropped = true;
  };
  for (std::size_t k = 0; k < x.pieces.size(); ++k) {
    if (!x.is_new_segment(x.pieces[k].of)) continue;
    for (const Pslg::Index corner : x.pieces[k].ends)
      for (auto other = std::ranges::lower_bound(at, std::pair(corner, std::size_t{0})); other != at.end() && other->first == corner; ++other) {
        if (other->second == k) continue;
        const Vector2 u = arm(x.pieces[k], corner), w = arm(x.pieces[other->second], corner);
        if (dot(u, w) < PlanarDomain::tiny_angle_cosine * std::sqrt(squared_length(u) * squared_length(w))) continue;
        drop(x.pieces[k], corner, squared_length(w)), drop(x.pieces[other->second], corner, squared_length(u));
      }
  }
}

/// Beside a new vertex, those nearer to it than a quarter of the distance to their nearest neighbour.
template <class Tr>
void drop_near_new_vertices(PlanarExtension<Tr>& x) {
  using Vertex = typename Tr::Vertex;
  for (Pslg::Index i = 0; i < x.domain.pslg.points.size(); ++i) {
    if (!x.is_new_point(i)) continue;
    auto around = x.tr.cgal().incident_vertices(x.vertices[i].handle);
    const auto first = around;
    do {
      const Vertex w{around};
      if (x.tr.cgal().is_infinite(w.handle) || x.tr.carrier(w).dimension == 0) continue;
      const std::uint32_t v = x.steiner_at[x.tr.index(w)];
      if (v != ExtensionSteiner::none && 16 * squared_distance(x.tr.point(w), x.point(i)) < squared_space(x, w)) x.steiner[v].dropped = true;
    } while (++around != first);
  }
}

/// Takes them out of the new triangulation, which knows no segments yet.
template <class Tr>
void remove_dropped(PlanarExtension<Tr>& x) {
  for (std::size_t v = 0; v < x.steiner.size(); ++v)
    if (x.steiner[v].dropped && x.place[v] != 0) x.tr.cgal().remove(x.vertices[x.place[v]].handle);
  for (ExtensionPiece& piece : x.pieces) std::erase_if(piece.chain, [&](std::uint32_t v) { return x.steiner[v].dropped; });
}

}  // namespace delref::detail
