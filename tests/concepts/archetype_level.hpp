// SPDX-License-Identifier: MIT
//
// The smallest refinement rule: intervals of the archetype triangulation that are longer than asked are halved. It has the members
// that `MesherLevel` requires and no other; the argument of `HalvesWithout` takes one of them away.
#pragma once

#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/core/verdict.hpp>

#include "archetype_triangulation.hpp"

namespace archetypes {

/// What is left out of an archetype level.
enum class LevelPart {
  none, move, scan_triangulation,
  element_type, empty, next_element, pop_next_element,
  refinement_point, check_refinement_point, before_insertion, after_insertion
};

template <LevelPart> struct HasElement { using Element = Interval; };
template <> struct HasElement<LevelPart::element_type> {};

/// Halves every interval longer than `longest`. `without` is the part that it lacks.
template <LevelPart without, class Tr = Line>
class HalvesWithout : public HasElement<without> {
  static constexpr bool has(LevelPart part) { return without != part; }

 public:
  explicit HalvesWithout(double longest) : longest_(longest) {}
  HalvesWithout(HalvesWithout&&) requires (has(LevelPart::move)) = default;

  void scan_triangulation(Tr& tr) requires (has(LevelPart::scan_triangulation)) {
    set_.clear();
    for (const Interval& e : intervals_of(tr)) test(tr, e);
  }

  bool empty() const requires (has(LevelPart::empty)) { return set_.empty(); }
  Interval next_element() requires (has(LevelPart::next_element)) { return set_.back(); }
  void pop_next_element(Tr&) requires (has(LevelPart::pop_next_element)) { set_.pop_back(); }

  Place<true> refinement_point(const Tr& tr, const Interval& e) requires (has(LevelPart::refinement_point)) {
    return {0.5 * (tr.point(e.left).x + tr.point(e.right).x)};
  }

  delref::Verdict check_refinement_point(Tr&, const delref::Proposal<Tr>&) requires (has(LevelPart::check_refinement_point)) {
    return delref::Verdict::permitted;
  }

  void before_insertion(Tr&, const delref::Proposal<Tr>& proposal) requires (has(LevelPart::before_insertion)) {
    std::erase(set_, proposal.zone->dying);
  }
  void after_insertion(Tr& tr, Knot, const delref::Proposal<Tr>& proposal) requires (has(LevelPart::after_insertion)) {
    for (const Interval& e : proposal.zone->made) test(tr, e);
  }

 private:
  void test(const Tr& tr, const Interval& e) {
    if (tr.point(e.right).x - tr.point(e.left).x > longest_) set_.push_back(e);
  }

  double longest_;
  std::vector<Interval> set_;
};

/// With all its parts.
using Halves = HalvesWithout<LevelPart::none>;

}  // namespace archetypes
