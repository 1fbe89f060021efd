// SPDX-License-Identifier: MIT
//
// The frame refines the archetype triangulation by two levels. Compiled where no header of CGAL can be found.
#if __has_include(<CGAL/version.h>)
#error "this test must be compiled with CGAL off the include path"
#endif

#include <catch2/catch_test_macros.hpp>

#include <delref/core/mesher.hpp>

#include "archetypes.hpp"

namespace {

using namespace archetypes;

/// Keeps other vertices away from a place: whoever proposes a point in the interval that holds the place waits until the place is
/// a vertex. Has the required members and no other.
class Reserves {
 public:
  using Element = Interval;
  explicit Reserves(double x) : x_(x) {}

  void scan_triangulation(Line&) { set_.clear(); }
  bool empty() const { return set_.empty(); }
  Interval next_element() { return set_.back(); }
  void pop_next_element(Line&) { set_.pop_back(); }
  Place<true> refinement_point(const Line&, const Interval&) { return {x_}; }
  delref::Verdict check_refinement_point(Line& tr, const delref::Proposal<Line>& proposal) {
    const Interval& e = proposal.zone->dying;
    if (proposal.point.x == x_ || !(tr.point(e.left).x < x_ && x_ < tr.point(e.right).x)) return delref::Verdict::permitted;
    set_.push_back(e);
    return delref::Verdict::rejected;
  }
  void before_insertion(Line&, const delref::Proposal<Line>& proposal) { std::erase(set_, proposal.zone->dying); }
  void after_insertion(Line&, Knot, const delref::Proposal<Line>&) {}

 private:
  double x_;
  std::vector<Interval> set_;
};

TEST_CASE("a mesher refines the archetype triangulation by two levels, in the order of their priority") {
  Line line(0, 1);
  delref::Mesher mesher(line, Reserves(0.3), Halves(0.25));
  const auto outcome = mesher.refine();

  CHECK(outcome.complete());
  CHECK(outcome.unmet.empty());
  CHECK(outcome.levels[0].inserted == 1);
  CHECK(outcome.levels[1].rejected == 1);
  CHECK(line.point({2}).x == 0.3);
  CHECK(line.provenance({2}) == 0);
  CHECK(line.provenance({3}) == 1);
  for (const Interval& e : intervals_of(line)) CHECK(line.point(e.right).x - line.point(e.left).x <= 0.25);
}

}  // namespace
