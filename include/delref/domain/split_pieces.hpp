// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bookkeeping of cutting segments at vertices: cuts sorted along their segments, and pieces that several segments share kept
// once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/pair_table.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/pslg_merge.hpp>

namespace delref {

/// A segment is to be cut at a vertex.
struct Cut {
  Pslg::Index segment, vertex;
};

/// Sorts cuts by segment and along each, and drops repeated ones. `points` holds the vertices of the cuts, `pslg` the segments.
/// The order is that of coordinates: exact, since points on a segment were rounded monotonically in each coordinate.
inline void sort_cuts(const Pslg& pslg, const std::vector<Point2>& points, std::vector<Cut>& cuts) {
  std::ranges::sort(cuts, [&](const Cut& a, const Cut& b) {
    if (a.segment != b.segment) return a.segment < b.segment;
    const Ends2 ends = pslg_crossings::ends(pslg, a.segment);
    const Point2 p = points[a.vertex], q = points[b.vertex];
    if (p.x != q.x) return (p.x < q.x) == (ends[0].x < ends[1].x);
    if (p.y != q.y) return (p.y < q.y) == (ends[0].y < ends[1].y);
    return a.vertex < b.vertex;
  });
  const auto same = [](const Cut& a, const Cut& b) { return a.segment == b.segment && a.vertex == b.vertex; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
}

/// The segments of a graph as they are rebuilt: pieces with the same ends become one, with the first marker that is not 0.
class SplitPieces {
 public:
  SplitPieces(std::size_t capacity, bool marked) : first_(capacity), marked_(marked) {}

  /// Adds a piece of the segment `original`, unless it has no length.
  void add(Pslg::Index a, Pslg::Index b, int marker, Pslg::Index original) {
    if (a == b) return;
    std::uint32_t& same = first_[{std::min(a, b), std::max(a, b)}];
    if (same == PairTable::none) {
      same = static_cast<std::uint32_t>(segments_.size());
      segments_.push_back({a, b});
      if (marked_) markers_.push_back(marker);
      originals_.push_back(original);
      return;
    }
    if (originals_[same] != original) ++shared_;
    if (!marked_ || marker == markers_[same] || marker == 0) return;
    if (markers_[same] != 0) {
      ++conflicts_;
      return;
    }
    markers_[same] = marker;
    originals_[same] = original;
  }

  void move_into(CheckedPslg& checked) {
    checked.pslg.segments = std::move(segments_);
    checked.pslg.segment_markers = std::move(markers_);
    checked.original_segment = std::move(originals_);
  }
  /// How often a piece was there already, for another segment.
  std::size_t shared() const { return shared_; }
  /// How often it had another marker, neither being 0.
  std::size_t conflicts() const { return conflicts_; }

 private:
  PairTable first_;
  bool marked_;
  std::vector<std::array<Pslg::Index, 2>> segments_;
  std::vector<int> markers_;
  std::vector<Pslg::Index> originals_;
  std::size_t shared_ = 0, conflicts_ = 0;
};

}  // namespace delref
