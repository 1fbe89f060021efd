// SPDX-License-Identifier: GPL-3.0-or-later
//
// First step of an extension: the Steiner vertices of the old triangulation that go over into the new one, and the input vertices
// that now cut an old segment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/chain_line.hpp>
#include <delref/domain/extension_state.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/pslg_scale.hpp>

namespace delref::detail {

/// Those that have the coordinates of an input vertex become that vertex, and cut the segment that they are on.
template <class Tr>
void collect_steiner(PlanarExtension<Tr>& x) {
  using Vertex = typename Tr::Vertex;
  PairTable input(x.domain.pslg.points.size());
  for (Pslg::Index i = 0; i < x.domain.pslg.points.size(); ++i) input[PairTable::key(x.point(i))] = i;
  std::vector<Vertex> found;
  for (const Vertex v : x.before.finite_vertices())
    if (x.before.provenance(v) != input_level && x.before.carrier(v).dimension > 0) found.push_back(v);
  std::ranges::sort(found, {}, [&](Vertex v) { return x.before.index(v); });
  for (const Vertex v : found) {
    const Carrier c = x.before.carrier(v);
    ExtensionSteiner s{scaled(x.before.point(v), x.domain.scale - x.old.scale), x.before.provenance(v), ExtensionSteiner::none, false};
    if (c.dimension == 1) s.on = x.old.segments[c.index].original;
    const Pslg::Index same = input.find(PairTable::key(s.point));
    if (same == PairTable::none) {
      if (s.on != ExtensionSteiner::none) x.chains[s.on].push_back(static_cast<std::uint32_t>(x.steiner.size()));
      x.steiner.push_back(s);
    } else if (s.on != ExtensionSteiner::none) {
      x.cuts[s.on].push_back(same);
    }
  }
}

/// New vertices beside a subsegment cut its segment.
template <class Tr>
void find_new_vertices_on_segments(PlanarExtension<Tr>& x) {
  typename Tr::CgalFace near{};
  for (Pslg::Index i = 0; i < x.domain.pslg.points.size(); ++i) {
    if (!x.is_new_point(i)) continue;
    if (i % 4096 == 0) throw_if_stopped(x.control);
    const Point2 p = scaled(x.point(i), x.old.scale - x.domain.scale);
    typename Tr::Cgal::Locate_type type;
    int k = 0;
    near = x.before.cgal().locate({p.x, p.y}, type, k, near);
    if (type == Tr::Cgal::VERTEX) continue;
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t on = ExtensionSteiner::none;
    const auto look_at = [&](typename Tr::CgalFace f) {
      for (int j = 0; j < 3; ++j) {
        const typename Tr::Edge e{f, j};
        if (!x.before.is_constrained(e)) continue;
        const ChainLine line(x.before.point(x.before.source(e)), x.before.point(x.before.target(e)));
        if (!line.holds(p) || line.distance(p) >= least) continue;
        least = line.distance(p);
        on = x.old.segments[x.before.segment(e)].original;
      }
    };
    look_at(near);
    for (int j = 0; j < 3; ++j) look_at(near->neighbor(j));
    if (on != ExtensionSteiner::none) x.cuts[on].push_back(i);
  }
}

}  // namespace delref::detail
