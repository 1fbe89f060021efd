// SPDX-License-Identifier: MIT
//
// The optional members of a level, and what happens without them. This is the one place that asks for them.
//
//   name() const                             what reports call the level                        default: "level N"
//   assign_slot(k)                           takes the slot number in its elements              default: it uses none
//   hint(tr, e)                              where the search for the point starts               default: the element
//   conflict_zone(tr, e, p, zone)            a zone of its own, e.g. with vanishing vertices     default: tr.conflict_zone
//   insert(tr, p, zone)                      an insertion of its own, e.g. with a weight         default: tr.insert
//   element_vertices(tr, e)                  the vertices of its element, 4 at most              default: tr.vertices(e)
//   dies(tr, e, zone)                        whether the zone kills its element                  default: tr.dies(e, zone)
//   carrier(tr, e)                           what the new vertex lies on                         default: the inside
//   give_up(tr, e)                           an optional Reason to leave e alone, before asking  default: never
//   on_rejected_forever(tr, e, reason)       remembers that e was dropped                        default: nothing
//   check_blocked(tr, edge, proposal)        its Verdict on a constraint that hides the point    default: not mine
//   rejection_reason() const                 why it last answered rejected_forever               default: rejected_by_level
//   unmet_criterion(tr, e)                   the name of what e violates                         default: the level's name
//   for_each_queued(f)                       calls f(e) for each element still in its set        default: not listed
//   holds(tr, vertices) const                whether an element it gave up is still its own      default: tr.is_simplex(vertices)
//   queued() const                           how many elements are in its set, in O(1)           default: 1 unless empty
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <delref/core/level_concepts.hpp>

namespace delref::level_options {

template <class L>
std::string name(const L& level, LevelIndex index) {
  if constexpr (requires { std::string(level.name()); }) return std::string(level.name());
  else return "level " + std::to_string(index);
}

template <class L>
concept UsesSlot = requires(L& level, std::size_t k) { level.assign_slot(k); };

template <class L, class Tr, class E>
typename Tr::Hint hint(L& level, const Tr& tr, const E& e) {
  if constexpr (requires { level.hint(tr, e); }) return level.hint(tr, e);
  else {
    static_assert(StoresElement<Tr, E>, "a level whose elements the triangulation does not store needs: hint(tr, element)");
    return typename Tr::Hint(e);
  }
}

template <class L, class Tr, class E>
Location<Tr> conflict_zone(L& level, Tr& tr, const E& e, const typename Tr::Point& p, typename Tr::Zone& zone) {
  if constexpr (requires { level.conflict_zone(tr, e, p, zone); }) return level.conflict_zone(tr, e, p, zone);
  else return tr.conflict_zone(p, hint(level, tr, e), zone);
}

template <class L, class Tr>
typename Tr::Vertex insert(L& level, Tr& tr, const typename Tr::Point& p, typename Tr::Zone& zone) {
  if constexpr (requires { level.insert(tr, p, zone); }) return level.insert(tr, p, zone);
  else return tr.insert(p, zone);
}

template <class L, class Tr, class E>
auto element_vertices(const L& level, const Tr& tr, const E& e) {
  if constexpr (requires { level.element_vertices(tr, e); }) return level.element_vertices(tr, e);
  else {
    static_assert(StoresElement<Tr, E>,
                  "a level whose elements the triangulation does not store needs: element_vertices(tr, element)");
    return tr.vertices(e);
  }
}

template <class L, class Tr, class E>
bool dies(const L& level, const Tr& tr, const E& e, const typename Tr::Zone& zone) {
  if constexpr (requires { level.dies(tr, e, zone); }) return level.dies(tr, e, zone);
  else if constexpr (StoresElement<Tr, E>) return tr.dies(e, zone);
  else return true;
}

template <class L, class Tr, class E>
Carrier carrier(const L& level, const Tr& tr, const E& e) {
  if constexpr (requires { level.carrier(tr, e); }) return level.carrier(tr, e);
  else return Carrier{static_cast<std::uint8_t>(Tr::dimension), Carrier::none};
}

template <class L, class Tr, class E>
std::optional<Reason> give_up(L& level, Tr& tr, const E& e) {
  if constexpr (requires { level.give_up(tr, e); }) return level.give_up(tr, e);
  else return std::nullopt;
}

template <class L, class Tr, class E>
void on_rejected_forever(L& level, Tr& tr, const E& e, Reason reason) {
  if constexpr (requires { level.on_rejected_forever(tr, e, reason); }) level.on_rejected_forever(tr, e, reason);
}

/// Nothing when the constraint is no business of this level.
template <class L, class Tr>
std::optional<Verdict> check_blocked(L& level, Tr& tr, const typename Tr::Edge& edge, const Proposal<Tr>& proposal) {
  if constexpr (requires { level.check_blocked(tr, edge, proposal); }) return level.check_blocked(tr, edge, proposal);
  else return std::nullopt;
}

template <class L>
Reason rejection_reason(const L& level) {
  if constexpr (requires { level.rejection_reason(); }) return level.rejection_reason();
  else return Reason::rejected_by_level;
}

template <class L, class Tr, class E>
std::string unmet_criterion(const L& level, LevelIndex index, const Tr& tr, const E& e) {
  if constexpr (requires { level.unmet_criterion(tr, e); }) return std::string(level.unmet_criterion(tr, e));
  else return name(level, index);
}

/// Whether an element that was given up is still there. A level whose elements the triangulation does not store, or which may be
/// missing from it, answers for itself.
template <class L, class Tr>
bool holds(const L& level, const Tr& tr, std::span<const typename Tr::Vertex> vertices) {
  if constexpr (requires { level.holds(tr, vertices); }) return level.holds(tr, vertices);
  else return tr.is_simplex(vertices);
}

template <class L, class F>
void for_each_queued(const L& level, F&& f) {
  if constexpr (requires { level.for_each_queued(f); }) level.for_each_queued(f);
}

template <class L>
std::size_t queued(const L& level) {
  if constexpr (requires { std::size_t{level.queued()}; }) return level.queued();
  else return level.empty() ? 0 : 1;
}

}  // namespace delref::level_options
