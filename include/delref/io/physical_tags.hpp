// SPDX-License-Identifier: GPL-3.0-or-later
//
// How labels and markers, which may be any integer, become physical tags of Gmsh, which must be positive: a positive label is its
// own tag; 0 and the negative ones take the smallest positive tags left over, in ascending order of the labels. The name of each
// physical group spells the label ("region -3", "marker 0", "facet marker 7"), and that is what a reader should trust.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace delref {

/// The tags of a set of labels.
class PhysicalTags {
 public:
  /// `labels` in any order and any number of times.
  explicit PhysicalTags(std::vector<int> labels) {
    std::ranges::sort(labels);
    const auto repeated = std::ranges::unique(labels);
    labels.erase(repeated.begin(), repeated.end());
    const auto first_positive = std::ranges::upper_bound(labels, 0);
    int tag = 1;
    auto taken = first_positive;
    for (auto label = labels.begin(); label != labels.end(); ++label) {
      if (*label > 0) {
        pairs_.emplace_back(*label, *label);
        continue;
      }
      for (; taken != labels.end() && *taken == tag; ++taken) ++tag;
      pairs_.emplace_back(*label, tag++);
    }
  }

  /// Every label with its tag, by ascending label.
  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  /// The position in `pairs()` of one of the labels.
  std::size_t position(int label) const {
    const auto pair = std::ranges::lower_bound(pairs_, label, {}, &std::pair<int, int>::first);
    return static_cast<std::size_t>(pair - pairs_.begin());
  }

 private:
  std::vector<std::pair<int, int>> pairs_;
};

/// The label in the name of a physical group: -3 for "region -3" when `kind` is "region". Nothing for any other name.
inline std::optional<int> label_in_physical_name(std::string_view name, std::string_view kind) {
  if (!name.starts_with(kind) || name.size() < kind.size() + 2 || name[kind.size()] != ' ') return std::nullopt;
  name.remove_prefix(kind.size() + 1);
  int label = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), label);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return label;
}

}  // namespace delref
