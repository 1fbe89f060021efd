// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the facets of a surface at a vertex are a topological disk: then the surface is a manifold there. After Cheng, Dey, Ramos
// and Ray, "Sampling and meshing a surface with guaranteed topology and geometry" (2007), section 4.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace delref {

/// The link of a vertex in a surface: an edge per facet at the vertex, between the numbers of its other two corners, with the two
/// regions that the facet lies between. Reused from one vertex to the next.
class Umbrella {
 public:
  struct Spoke {
    std::array<int, 2> regions;
    std::size_t from, to;
  };

  void clear() { spokes_.clear(); }
  void add(std::array<int, 2> regions, std::size_t from, std::size_t to) { spokes_.push_back({regions, from, to}); }
  bool empty() const { return spokes_.empty(); }

  /// Whether the facets between each two regions are one disk: a closed umbrella around the vertex, or, where other regions meet
  /// there too, a fan with two free edges.
  bool is_disk() {
    std::ranges::sort(spokes_, {}, &Spoke::regions);
    bool several = false;
    for (std::size_t first = 0; first < spokes_.size();) {
      std::size_t last = first;
      while (last < spokes_.size() && spokes_[last].regions == spokes_[first].regions) ++last;
      several = several || last < spokes_.size();
      if (!is_one_disk(std::span(spokes_).subspan(first, last - first), several)) return false;
      first = last;
    }
    return true;
  }

 private:
  /// Follows the link from a free end, or from anywhere, and sees whether it comes by every spoke.
  bool is_one_disk(std::span<Spoke> spokes, bool may_be_open) {
    ends_.clear();
    for (std::size_t i = 0; i < spokes.size(); ++i) ends_.push_back({spokes[i].from, i}), ends_.push_back({spokes[i].to, i});
    std::ranges::sort(ends_);
    std::size_t start = spokes[0].from, free_ends = 0;
    for (std::size_t i = 0; i < ends_.size();) {
      std::size_t j = i;
      while (j < ends_.size() && ends_[j].first == ends_[i].first) ++j;
      if (j - i > 2) return false;
      if (j - i == 1) ++free_ends, start = ends_[i].first;
      i = j;
    }
    if (free_ends != 0 && !(may_be_open && free_ends == 2)) return false;
    std::size_t at = start, seen = 0, last = spokes.size();
    do {
      auto next = std::ranges::lower_bound(ends_, std::pair(at, std::size_t{0}));
      if (next->second == last) ++next;
      if (next == ends_.end() || next->first != at) break;  // the other free end
      last = next->second;
      at = spokes[last].from == at ? spokes[last].to : spokes[last].from;
      ++seen;
    } while (at != start);
    return seen == spokes.size();
  }

  std::vector<Spoke> spokes_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;  // corner, spoke
};

}  // namespace delref
