// SPDX-License-Identifier: MIT
//
// What a refinement rule is: the concept `MesherLevel` in named parts, each with the sentence that a compiler prints when it is
// missing. After Rineau and Yvinec, "A generic software design for Delaunay refinement meshing" (2007), sections 3.2 and 3.3,
// whose primitive methods these are.
//
// The smallest model (tests/concepts/archetypes.hpp compiles it and removes each member in turn):
//
//     struct Rule {
//       using Element = Tr::Face;
//       void scan_triangulation(Tr&);                                          // 1 Scans
//       bool empty() const; Element next_element(); void pop_next_element(Tr&);  // 2 Queues
//       Tr::Point refinement_point(const Tr&, const Element&);                 // 3 Proposes
//       Verdict check_refinement_point(Tr&, const Proposal<Tr>&);              // 4 Checks
//       void before_insertion(Tr&, const Proposal<Tr>&);                       // 5 Follows
//       void after_insertion(Tr&, Tr::Vertex, const Proposal<Tr>&);
//     };
//
// Laws that no compiler checks, and `delref/testing/laws.hpp` does:
//  - scan_triangulation makes the set exactly the elements that violate the rule, whatever it held before;
//  - an element that dies leaves the set in before_insertion, or in after_insertion at the latest where the triangulation does not
//    store it and the level tells by `holds` that it is gone; one that is new and violates the rule enters it in after_insertion;
//  - who answers `rejected` to a point of another level has put the encroached element into its own set, and never answers
//    `rejected` to its own points;
//  - `rejected_forever` puts nothing into any set;
//  - the same calls have the same effects: no clock, no address order, no unseeded randomness.
#pragma once

#include <concepts>

#include <delref/core/level_members.hpp>
#include <delref/core/proposal.hpp>
#include <delref/core/triangulation_concept.hpp>
#include <delref/core/verdict.hpp>

namespace delref {

/// Part 1. Fills the set of elements to refine from the whole triangulation.
template <class L, class Tr>
concept Scans = requires(L& level, Tr& tr) { level.scan_triangulation(tr); };

/// Part 2. Gives the set, one element after the other, in the order of the rule's queue.
template <class L, class Tr>
concept Queues = requires(L& level, const L& const_level, Tr& tr) {
  typename L::Element;
  { const_level.empty() } -> std::same_as<bool>;
  { level.next_element() } -> std::convertible_to<typename L::Element>;
  level.pop_next_element(tr);
};

/// Part 3. Gives the point whose insertion would kill an element.
template <class L, class Tr>
concept Proposes = requires(L& level, const Tr& tr, const typename L::Element& element) {
  { level.refinement_point(tr, element) } -> std::convertible_to<typename Tr::Point>;
};

/// Part 4. Judges a point that any level proposes.
template <class L, class Tr>
concept Checks = requires(L& level, Tr& tr, const Proposal<Tr>& proposal) {
  { level.check_refinement_point(tr, proposal) } -> std::same_as<Verdict>;
};

/// Part 5. Follows every insertion: drops what dies, looks at what is new.
template <class L, class Tr>
concept Follows = requires(L& level, Tr& tr, const Proposal<Tr>& proposal, typename Tr::Vertex v) {
  level.before_insertion(tr, proposal);
  level.after_insertion(tr, v, proposal);
};

/// A refinement rule on the triangulation `Tr`.
template <class L, class Tr>
concept MesherLevel = std::move_constructible<L> && Scans<L, Tr> && Queues<L, Tr> && Proposes<L, Tr> && Checks<L, Tr> && Follows<L, Tr>;

/// Fails to compile with one sentence per missing part, and per optional member that the frame would pass over. Write
/// `static_assert(delref::explain_level<MyLevel, Tr>());` beside a level of your own; `Mesher` does it for all of its levels.
template <class L, class Tr>
consteval bool explain_level() {
  static_assert(std::move_constructible<L>, "a mesher level needs: to be movable, since a mesher owns its levels by value");
  static_assert(Scans<L, Tr>, "a mesher level needs: scan_triangulation(tr) that fills its set from the whole triangulation");
  static_assert(Queues<L, Tr>,
                "a mesher level needs: a type Element, empty() const that gives bool, next_element() that gives an Element, and "
                "pop_next_element(tr)");
  static_assert(Proposes<L, Tr>,
                "a mesher level needs: refinement_point(tr, element) that gives the point whose insertion kills the element");
  static_assert(Checks<L, Tr>,
                "a mesher level needs: check_refinement_point(tr, proposal) that gives a delref::Verdict");
  static_assert(Follows<L, Tr>,
                "a mesher level needs: before_insertion(tr, proposal) that takes dying elements out of its set, and "
                "after_insertion(tr, vertex, proposal) that looks at the new ones");
  if constexpr (MesherLevel<L, Tr>) return explain_optional_members<L, Tr>();
  else return false;
}

}  // namespace delref
