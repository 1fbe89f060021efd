// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cells of a triangulation belong to the domain, and to which region: components of space between facets, from the hull inwards.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/polyhedral_domain.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Regions of a labelled domain: what the region number of a cell means.
struct PolyhedralRegions {
  /// By region number. Components that no seed names have the label 0; if there is no seed at all and more than one component, 1 and
  /// so on in the order of their first vertices.
  std::vector<Plc::Region> regions;
  std::vector<std::string> notes;
};

/// Gives every cell of `tr`, whose marked facets are those of the whole complex, its region: -1 outside and in holes. Throws
/// `InvalidInput` when nothing is left, `Interrupted` when the control says stop. Linear time.
template <SpatialTriangulation Tr>
class PolyhedralDomainLabeller {
  using Cell = typename Tr::Cell;

 public:
  PolyhedralDomainLabeller(Tr& tr, const PolyhedralDomain& domain, const Control& control)
      : tr_(tr), domain_(domain), control_(control) {
    for (const Cell c : tr.all_cells()) tr.set_region(c, untouched);
    flood(tr.infinite_cell(), outside);
    dig_holes();
    name_regions();
    number_the_rest();
    for (const Cell c : tr.all_cells())
      if (tr.region(c) < 0) tr.set_region(c, -1);
  }
  PolyhedralRegions take() && { return std::move(result_); }

 private:
  static constexpr int untouched = -3, outside = -2;

  std::size_t flood(Cell start, int region) {
    if (tr_.region(start) != untouched) return 0;
    stack_.assign(1, start);
    tr_.set_region(start, region);
    std::size_t count = 0;
    while (!stack_.empty()) {
      const Cell c = stack_.back();
      stack_.pop_back();
      if (++count % 65536 == 0) throw_if_stopped(control_);
      for (const auto v : tr_.vertices(c))
        if (!tr_.is_infinite(v)) lowest_ = std::min(lowest_, tr_.index(v));
      for (int i = 0; i < 4; ++i) {
        const auto f = tr_.facet(c, i);
        if (tr_.is_marked(f)) continue;
        const Cell n = tr_.cell(tr_.mirror(f));
        if (tr_.region(n) != untouched) continue;
        tr_.set_region(n, region);
        stack_.push_back(n);
      }
    }
    return count;
  }

  void dig_holes() {
    for (std::size_t i = 0; i < domain_.holes.size(); ++i) {
      const auto c = tr_.locate(domain_.holes[i]);
      if (!c || (flood(*c, outside) == 0 && tr_.region(*c) == outside))
        result_.notes.push_back("hole seed " + std::to_string(i + domain_.first_index) + " at " + describe(domain_.holes[i]) +
                                " is outside the domain or in a hole already: it has no effect");
    }
  }
  void name_regions() {
    for (std::size_t i = 0; i < domain_.regions.size(); ++i) {
      const Plc::Region& r = domain_.regions[i];
      const auto c = tr_.locate(r.seed);
      if (c && tr_.region(*c) == untouched) {
        flood(*c, static_cast<int>(result_.regions.size()));
        result_.regions.push_back(r);
        continue;
      }
      const std::string what = "region seed " + std::to_string(i + domain_.first_index) + " at " + describe(r.seed);
      result_.notes.push_back(!c || tr_.region(*c) == outside
                                  ? what + " is outside the domain: it has no effect"
                                  : what + " is in a component that an earlier seed names: it has no effect");
    }
  }
  void number_the_rest() {
    std::vector<std::pair<std::size_t, std::size_t>> components;  // by the first input vertex of each
    for (const Cell c : tr_.finite_cells()) {
      if (tr_.region(c) != untouched) continue;
      lowest_ = std::numeric_limits<std::size_t>::max();
      flood(c, static_cast<int>(result_.regions.size()));
      components.emplace_back(lowest_, result_.regions.size());
      result_.regions.push_back({});
    }
    if (domain_.regions.empty() && components.size() > 1) {
      std::ranges::sort(components);
      for (std::size_t k = 0; k < components.size(); ++k) result_.regions[components[k].second].label = static_cast<int>(k + 1);
    }
    if (result_.regions.empty())
      throw InvalidInput(domain_.holes.empty()
                             ? "the facets enclose no volume: close the surface"
                             : "nothing is left of the domain: the hole seeds are in every component of it; remove one of them");
  }

  Tr& tr_;
  const PolyhedralDomain& domain_;
  const Control& control_;
  PolyhedralRegions result_;
  std::vector<Cell> stack_;
  std::size_t lowest_ = 0;  // the number of the first vertex that a flood met
};

}  // namespace delref
