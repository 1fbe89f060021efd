// SPDX-License-Identifier: MIT
//
// A level's optional members are asked for by the way they are called, so that one with other arguments would be passed over
// without a word. This says so instead. Seen are members of which there is one, that are no templates and not private: of
// others a compiler cannot be asked whether they exist.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <delref/core/proposal.hpp>
#include <delref/core/triangulation_concept.hpp>
#include <delref/core/verdict.hpp>

namespace delref {

/// Fails to compile with one sentence per optional member of `L` that exists and cannot be called as the frame calls it. What
/// each is for: `core/level_options.hpp`. Requires a type `L::Element`.
template <class L, class Tr>
consteval bool explain_optional_members() {
  using E = typename L::Element;
  static_assert(!requires { &L::name; } || requires(const L& level) { std::string(level.name()); },
                "the member `name` of a level is passed over: it must be callable as name() const and give a string");
  static_assert(!requires { &L::assign_slot; } || requires(L& level, std::size_t k) { level.assign_slot(k); },
                "the member `assign_slot` of a level is passed over: it must be callable as assign_slot(std::size_t)");
  static_assert(!requires { &L::hint; } || requires(L& level, const Tr& tr, const E& e) { level.hint(tr, e); },
                "the member `hint` of a level is passed over: it must be callable as hint(const tr, element)");
  static_assert(!requires { &L::conflict_zone; } ||
                    requires(L& level, Tr& tr, const E& e, const typename Tr::Point& p, typename Tr::Zone& zone) {
                      level.conflict_zone(tr, e, p, zone);
                    },
                "the member `conflict_zone` of a level is passed over: it must be callable as conflict_zone(tr, element, point, zone)");
  static_assert(!requires { &L::insert; } ||
                    requires(L& level, Tr& tr, const typename Tr::Point& p, typename Tr::Zone& zone) { level.insert(tr, p, zone); },
                "the member `insert` of a level is passed over: it must be callable as insert(tr, point, zone)");
  static_assert(!requires { &L::element_vertices; } ||
                    requires(const L& level, const Tr& tr, const E& e) { level.element_vertices(tr, e); },
                "the member `element_vertices` of a level is passed over: it must be callable as element_vertices(const tr, element) const");
  static_assert(!requires { &L::dies; } ||
                    requires(const L& level, const Tr& tr, const E& e, const typename Tr::Zone& zone) { level.dies(tr, e, zone); },
                "the member `dies` of a level is passed over: it must be callable as dies(const tr, element, const zone) const");
  static_assert(!requires { &L::carrier; } || requires(const L& level, const Tr& tr, const E& e) { level.carrier(tr, e); },
                "the member `carrier` of a level is passed over: it must be callable as carrier(const tr, element) const");
  static_assert(!requires { &L::give_up; } || requires(L& level, Tr& tr, const E& e) { level.give_up(tr, e); },
                "the member `give_up` of a level is passed over: it must be callable as give_up(tr, element)");
  static_assert(!requires { &L::on_rejected_forever; } ||
                    requires(L& level, Tr& tr, const E& e, Reason reason) { level.on_rejected_forever(tr, e, reason); },
                "the member `on_rejected_forever` of a level is passed over: it must be callable as on_rejected_forever(tr, element, reason)");
  static_assert(!requires { &L::check_blocked; } ||
                    requires(L& level, Tr& tr, const typename Tr::Edge& edge, const Proposal<Tr>& proposal) {
                      level.check_blocked(tr, edge, proposal);
                    },
                "the member `check_blocked` of a level is passed over: it must be callable as check_blocked(tr, edge, proposal)");
  static_assert(!requires { &L::rejection_reason; } || requires(const L& level) { level.rejection_reason(); },
                "the member `rejection_reason` of a level is passed over: it must be callable as rejection_reason() const");
  static_assert(!requires { &L::unmet_criterion; } ||
                    requires(const L& level, const Tr& tr, const E& e) { level.unmet_criterion(tr, e); },
                "the member `unmet_criterion` of a level is passed over: it must be callable as unmet_criterion(const tr, element) const");
  static_assert(!requires { &L::holds; } ||
                    requires(const L& level, const Tr& tr, std::span<const typename Tr::Vertex> vertices) { level.holds(tr, vertices); },
                "the member `holds` of a level is passed over: it must be callable as holds(const tr, span of vertices) const");
  static_assert(!requires { &L::queued; } || requires(const L& level) { std::size_t{level.queued()}; },
                "the member `queued` of a level is passed over: it must be callable as queued() const and give a std::size_t");
  return true;
}

}  // namespace delref
