// SPDX-License-Identifier: MIT
//
// A level on a track with every optional member that the frame knows and each decision left to a function, so that a test says in a
// line how its level behaves. What is not set does nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/core/level_options.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/lifo_queue.hpp>

#include "track.hpp"

namespace track {

/// What a rule does. `on` and `self` are the track and the rule, in their state of the moment.
template <class Tr>
struct Rule {
  using Element = Piece;
  using Proposal = delref::Proposal<Tr>;

  std::string label = "rule";
  std::function<bool(const Tr& on, const Piece&)> violates{};
  std::function<double(const Tr& on, const Piece&)> target{};  // not set: the middle
  std::function<delref::Verdict(Rule& self, Tr& on, const Proposal&)> judge{};
  std::function<std::optional<delref::Verdict>(Rule& self, Tr& on, Knot wall)> judge_wall{};
  std::function<std::optional<delref::Reason>(const Piece&)> skip{};
  std::function<void(Rule& self, Tr& on, const Proposal&)> before{}, after{};
  std::function<bool(Knot)> vanishes{};
  delref::Reason reason = delref::Reason::rejected_by_level;
  std::optional<delref::Carrier> on_what{};
  // Ways to break the laws.
  bool keeps_the_dead = false, ignores_the_new = false, scans_without_clearing = false, hides_its_set = false;

  delref::ElementSet<Piece, delref::LifoQueue<Piece>> set{};
  std::size_t slot = 99;

  std::string_view name() const { return label; }
  void assign_slot(std::size_t k) { set.assign_slot(slot = k); }

  void scan_triangulation(Tr& tr) {
    if (!scans_without_clearing) set.clear();
    for (const Piece& e : tr.pieces()) test(tr, e);
  }
  bool empty() const { return hides_its_set || set.empty(); }
  Piece next_element() { return set.front(); }
  void pop_next_element(Tr& tr) { set.pop(tr); }
  template <class F>
  void for_each_queued(F&& f) const { set.for_each(f); }
  std::size_t queued() const { return set.size(); }

  Place refinement_point(const Tr& tr, const Piece& e) const {
    return {target ? target(tr, e) : 0.5 * tr.point(e.left).x + 0.5 * tr.point(e.right).x};
  }
  delref::Location<Tr> conflict_zone(Tr& tr, const Piece& e, const Place& p, typename Tr::Zone& zone) const {
    const auto location = tr.conflict_zone(p, e, zone);
    if (location.kind == Tr::Kind::zone && vanishes) tr.widen(zone, vanishes);
    return location;
  }
  delref::Carrier carrier(const Tr&, const Piece&) const { return on_what.value_or(delref::Carrier{1, delref::Carrier::none}); }
  std::optional<delref::Reason> give_up(const Tr&, const Piece& e) const { return skip ? skip(e) : std::nullopt; }
  void on_rejected_forever(Tr& tr, const Piece& e, delref::Reason) { set.give_up(tr, e); }
  std::string unmet_criterion(const Tr&, const Piece&) const { return label + " criterion"; }

  delref::Verdict check_refinement_point(Tr& tr, const Proposal& proposal) {
    return judge ? judge(*this, tr, proposal) : delref::Verdict::permitted;
  }
  std::optional<delref::Verdict> check_blocked(Tr& tr, Knot wall, const Proposal&) {
    return judge_wall ? judge_wall(*this, tr, wall) : std::nullopt;
  }
  delref::Reason rejection_reason() const { return reason; }

  void before_insertion(Tr& tr, const Proposal& proposal) {
    if (before) before(*this, tr, proposal);
    if (keeps_the_dead) return;
    for (const Piece& e : proposal.zone->dying) set.erase(tr, e);
  }
  void after_insertion(Tr& tr, Knot, const Proposal& proposal) {
    if (after) after(*this, tr, proposal);
    if (ignores_the_new) return;
    for (const Piece& e : proposal.zone->made) test(tr, e);
  }

 private:
  void test(Tr& tr, const Piece& e) {
    if (violates && violates(tr, e)) set.add(tr, e, tr.length(e));
  }
};

using Road = Track<2>;
using RoadRule = Rule<Road>;

/// The rule by which a road is refined until no piece is longer than `longest`.
inline RoadRule shorter_than(double longest, std::string label = "length") {
  return {.label = std::move(label), .violates = [longest](const Road& road, const Piece& e) { return road.length(e) > longest; }};
}

/// The rule by which nobody else may put a vertex into a piece that holds `x` before `x` is a vertex.
inline RoadRule first_at(double x, std::string label = "first") {
  const auto holds = [x](const Road& road, const Piece& e) { return road.point(e.left).x < x && x < road.point(e.right).x; };
  return {.label = std::move(label),
          .target = [x](const Road&, const Piece&) { return x; },
          .judge =
              [x, holds](RoadRule& self, Road& road, const RoadRule::Proposal& proposal) {
                const Piece& e = proposal.zone->dying.front();
                if (proposal.point.x == x || !holds(road, e)) return delref::Verdict::permitted;
                self.set.add(road, e, 0);
                return delref::Verdict::rejected;
              }};
}

}  // namespace track
