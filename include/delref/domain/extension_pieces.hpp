// SPDX-License-Identifier: GPL-3.0-or-later
//
// Second step of an extension: every segment in pieces between the input vertices on its way, with its Steiner vertices: those of an
// old segment, and for a new one those that it happens to run over.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/chain_line.hpp>
#include <delref/domain/extension_state.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/walk_along.hpp>

namespace delref::detail {

/// A vertex on the way of a segment: an input vertex, or a Steiner vertex, by its place in `steiner`.
struct ExtensionItem {
  double order;
  std::uint32_t number;
  bool is_input;
};

/// Cutting moves a segment a little: vertices that are then too far from their part are left out.
template <class Tr>
void add_piece(PlanarExtension<Tr>& x, ExtensionPiece piece) {
  const ChainLine line(x.point(piece.ends[0]), x.point(piece.ends[1]));
  std::erase_if(piece.chain, [&](std::uint32_t v) { return !line.is_between(x.steiner[v].point) || line.distance(x.steiner[v].point) > 3.5 * line.ulp(); });
  x.pieces.push_back(std::move(piece));
}

/// Segment `s` of the united graph, cut at the input vertices among `items`.
template <class Tr>
void add_pieces(PlanarExtension<Tr>& x, std::size_t s, std::vector<ExtensionItem> items) {
  std::ranges::sort(items, {}, &ExtensionItem::order);
  const auto [first, last] = x.domain.pslg.segments[s];
  ExtensionPiece piece{{first, last}, s, {}};
  for (const ExtensionItem& item : items) {
    if (!item.is_input) {
      piece.chain.push_back(item.number);
      continue;
    }
    if (item.number == piece.ends[0]) continue;  // found twice
    piece.ends[1] = item.number;
    add_piece(x, std::exchange(piece, {{item.number, last}, s, {}}));
  }
  add_piece(x, std::move(piece));
}

/// The segments of the old graph with their Steiner vertices. What is on none of the parts any more is left out.
template <class Tr>
void cut_old_segments(PlanarExtension<Tr>& x) {
  for (std::size_t s = 0; s < x.domain.pslg.segments.size(); ++s) {
    if (x.is_new_segment(s)) continue;
    if (s % 4096 == 0) throw_if_stopped(x.control);
    const auto source = x.united.segment_source[s];
    const auto [a, b] = x.domain.pslg.segments[s];
    const ChainLine line(x.point(a), x.point(b));
    std::vector<ExtensionItem> items;
    for (const std::uint32_t v : x.chains[source])
      if (line.is_between(x.steiner[v].point)) items.push_back({line.order(x.steiner[v].point), v, false});
    for (const Pslg::Index i : x.cuts[source])
      if (line.is_between(x.point(i))) items.push_back({line.order(x.point(i)), i, true});
    add_pieces(x, s, std::move(items));
  }
  std::vector<bool> is_placed(x.steiner.size());
  for (const ExtensionPiece& piece : x.pieces)
    for (const std::uint32_t v : piece.chain) is_placed[v] = true;
  for (std::size_t v = 0; v < x.steiner.size(); ++v)
    if (x.steiner[v].on != ExtensionSteiner::none && !is_placed[v]) x.steiner[v].dropped = true;
  x.old_pieces = x.pieces.size();
}

/// The squared distance from `v` to its nearest neighbour that is no new input vertex.
template <class Tr>
double squared_space(const PlanarExtension<Tr>& x, typename Tr::Vertex v) {
  using Vertex = typename Tr::Vertex;
  double least = std::numeric_limits<double>::infinity();
  auto around = x.tr.cgal().incident_vertices(v.handle);
  const auto first = around;
  do {
    const Vertex w{around};
    if (x.tr.cgal().is_infinite(w.handle) || (x.tr.carrier(w).dimension == 0 && x.is_new_point(x.tr.carrier(w).index))) continue;
    least = std::min(least, squared_distance(x.tr.point(v), x.tr.point(w)));
  } while (++around != first);
  return least;
}

/// The vertices on the way of a new segment; adds the free ones that are beside it and too near.
template <class Tr>
std::vector<ExtensionItem> vertices_on_way(PlanarExtension<Tr>& x, std::size_t s, std::vector<std::uint32_t>& beside) {
  using Vertex = typename Tr::Vertex;
  const auto [a, b] = x.domain.pslg.segments[s];
  const ChainLine line(x.point(a), x.point(b));
  std::vector<ExtensionItem> items;
  for (const Vertex v : vertices_along(x.tr, x.vertices[a], x.vertices[b])) {
    const Point2 p = x.tr.point(v);
    if (!line.is_between(p)) continue;
    const bool is_input = x.tr.carrier(v).dimension == 0;
    const std::uint32_t number = is_input ? x.tr.carrier(v).index : x.steiner_at[x.tr.index(v)];
    if (!is_input && (number == ExtensionSteiner::none || x.steiner[number].on != ExtensionSteiner::none)) continue;
    const double distance = line.distance(p);
    if (distance <= line.tolerance()) items.push_back({line.order(p), number, is_input});
    else if (!is_input && 16 * distance * distance < squared_space(x, v)) beside.push_back(number);
  }
  return items;
}

/// The way of each new segment. A part that is there already is dropped.
template <class Tr>
void cut_new_segments(PlanarExtension<Tr>& x) {
  std::vector<std::uint32_t> beside;
  for (std::size_t s = 0; s < x.domain.pslg.segments.size(); ++s) {
    if (!x.is_new_segment(s)) continue;
    throw_if_stopped(x.control);
    add_pieces(x, s, vertices_on_way(x, s, beside));
  }
  for (std::size_t k = x.old_pieces; k < x.pieces.size(); ++k)
    for (const std::uint32_t v : x.pieces[k].chain) x.steiner[v].on = static_cast<std::uint32_t>(x.pieces[k].of);
  for (const std::uint32_t v : beside)
    if (x.steiner[v].on == ExtensionSteiner::none) x.steiner[v].dropped = true;
  PairTable known(x.pieces.size());
  std::size_t kept = 0;
  for (ExtensionPiece& piece : x.pieces) {
    auto& first = known[{std::min(piece.ends[0], piece.ends[1]), std::max(piece.ends[0], piece.ends[1])}];
    if (first != PairTable::none) {
      for (const std::uint32_t v : piece.chain) x.steiner[v].dropped = true;
      auto& markers = x.united.checked.pslg.segment_markers;
      if (!markers.empty() && markers[x.pieces[first].of] == 0) markers[x.pieces[first].of] = markers[piece.of];
      continue;
    }
    first = static_cast<std::uint32_t>(kept);
    if (&x.pieces[kept] != &piece) x.pieces[kept] = std::move(piece);
    ++kept;
  }
  x.pieces.resize(kept);
}

}  // namespace delref::detail
