// SPDX-License-Identifier: MIT
//
// A level that does what another level does and notes every law that this breaks (the laws are listed in core/level_concepts.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <delref/core/level_options.hpp>
#include <delref/testing/law_book.hpp>

namespace delref::testing {

/// The level `L` of a mesher on `Tr`, watched. It has the optional members that `L` has. What waits in its set is seen through
/// `L::for_each_queued`; without that member fewer laws can be checked. Each hook takes the time to sort the set: for small meshes.
template <class L, class Tr>
class WatchedLevel {
 public:
  using Element = typename L::Element;
  using Point = typename Tr::Point;
  using Zone = typename Tr::Zone;
  /// The vertex numbers of an element, sorted: what an element is, whatever handle it has.
  using Key = std::array<std::size_t, 4>;

  /// `index` is its place in its mesher; `book` must outlive it.
  WatchedLevel(L level, LevelIndex index, LawBook& book)
      : level_(std::move(level)), index_(index), book_(&book), who_("level \"" + level_options::name(level_, index) + "\"") {}

  const std::string& who() const { return who_; }

  /// What waits in its set, sorted; empty when `L` does not list it.
  std::vector<Key> queued_keys(const Tr& tr) const {
    std::vector<Key> keys;
    level_options::for_each_queued(level_, [&](const Element& e) { keys.push_back(key(tr, e)); });
    std::ranges::sort(keys);
    return keys;
  }

  // -- the required members
  void scan_triangulation(Tr& tr) { level_.scan_triangulation(tr); }
  bool empty() const { return level_.empty(); }
  Element next_element() { return level_.next_element(); }
  void pop_next_element(Tr& tr) {
    std::vector<Key> before = queued_keys(tr);
    const Key next = key(tr, level_.next_element());
    level_.pop_next_element(tr);
    if (!lists) return;
    if (const auto found = std::ranges::find(before, next); found != before.end()) before.erase(found);
    if (queued_keys(tr) != before)
      breach("pops something else than its next element", "the next element has " + words(next));
  }
  Point refinement_point(const Tr& tr, const Element& e) { return level_.refinement_point(tr, e); }
  Verdict check_refinement_point(Tr& tr, const Proposal<Tr>& proposal) {
    return judge(tr, proposal, [&] { return level_.check_refinement_point(tr, proposal); });
  }

  void before_insertion(Tr& tr, const Proposal<Tr>& proposal) {
    std::vector<Key> expected = queued_keys(tr);
    const std::vector<Key> dying = dying_of(tr, *proposal.zone);
    level_.before_insertion(tr, proposal);
    const std::vector<Key> still_there = dying_of(tr, *proposal.zone);
    if (!still_there.empty()) {
      breach("keeps a dying element in its set", words(still_there.front()) + ", when " + describe(tr, proposal) + " is killed");
      book_->end_run();
    }
    if (!lists || !tells_death) return;
    for (const Key& k : dying) expected.erase(std::ranges::find(expected, k));
    expect_kept(tr, expected, proposal);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& proposal) {
    const std::vector<Key> before = queued_keys(tr);
    level_.after_insertion(tr, v, proposal);
    expect_kept(tr, before, proposal);
  }

  // -- the optional members
  std::string name() const { return level_options::name(level_, index_); }
  void assign_slot(std::size_t k) requires level_options::UsesSlot<L> { level_.assign_slot(k); }
  typename Tr::Hint hint(const Tr& tr, const Element& e) requires requires(L& l) { l.hint(tr, e); } { return level_.hint(tr, e); }
  Location<Tr> conflict_zone(Tr& tr, const Element& e, const Point& p, Zone& zone)
    requires requires(L& l) { l.conflict_zone(tr, e, p, zone); }
  {
    return level_.conflict_zone(tr, e, p, zone);
  }
  typename Tr::Vertex insert(Tr& tr, const Point& p, Zone& zone) requires requires(L& l) { l.insert(tr, p, zone); } {
    return level_.insert(tr, p, zone);
  }
  auto element_vertices(const Tr& tr, const Element& e) const requires requires(const L& l) { l.element_vertices(tr, e); } {
    return level_.element_vertices(tr, e);
  }
  bool dies(const Tr& tr, const Element& e, const Zone& zone) const requires requires(const L& l) { l.dies(tr, e, zone); } {
    return level_.dies(tr, e, zone);
  }
  Carrier carrier(const Tr& tr, const Element& e) const requires requires(const L& l) { l.carrier(tr, e); } {
    return level_.carrier(tr, e);
  }
  std::optional<Reason> give_up(Tr& tr, const Element& e) requires requires(L& l) { l.give_up(tr, e); } {
    return level_.give_up(tr, e);
  }
  void on_rejected_forever(Tr& tr, const Element& e, Reason reason) requires requires(L& l) { l.on_rejected_forever(tr, e, reason); } {
    level_.on_rejected_forever(tr, e, reason);
  }
  std::optional<Verdict> check_blocked(Tr& tr, const typename Tr::Edge& edge, const Proposal<Tr>& proposal)
    requires requires(L& l) { l.check_blocked(tr, edge, proposal); }
  {
    return judge(tr, proposal, [&] { return std::optional<Verdict>(level_.check_blocked(tr, edge, proposal)); });
  }
  Reason rejection_reason() const requires requires(const L& l) { l.rejection_reason(); } { return level_.rejection_reason(); }
  std::string unmet_criterion(const Tr& tr, const Element& e) const requires requires(const L& l) { l.unmet_criterion(tr, e); } {
    return std::string(level_.unmet_criterion(tr, e));
  }
  template <class F>
  void for_each_queued(F&& f) const requires requires(const L& l) { l.for_each_queued(f); } { level_.for_each_queued(f); }

 private:
  static constexpr bool lists = requires(const L& l, std::function<void(const Element&)> f) { l.for_each_queued(f); };
  static constexpr bool tells_death =
      StoresElement<Tr, Element> || requires(const L& l, const Tr& tr, const Element& e, const Zone& zone) { l.dies(tr, e, zone); };

  Key key(const Tr& tr, const Element& e) const {
    Key result;
    result.fill(std::numeric_limits<std::size_t>::max());
    std::size_t count = 0;
    for (const auto v : level_options::element_vertices(level_, tr, e))
      if (count < result.size()) result[count++] = tr.index(v);
    std::ranges::sort(result);
    return result;
  }
  static std::string words(const Key& k) {
    std::string text = "vertices";
    for (const std::size_t v : k)
      if (v != std::numeric_limits<std::size_t>::max()) text += " " + std::to_string(v);
    return text;
  }
  static std::string describe(const Tr& tr, const Proposal<Tr>& proposal) {
    std::string text = "the element of level " + std::to_string(proposal.level) + " with vertices";
    for (const auto v : proposal.element_vertices()) text += " " + std::to_string(tr.index(v));
    return text;
  }
  void breach(std::string_view law, std::string_view where) { book_->breach(who_, law, where); }

  /// The elements of its set that the zone kills.
  std::vector<Key> dying_of(const Tr& tr, const Zone& zone) {
    std::vector<Key> keys;
    if constexpr (tells_death) {
      const auto look = [&](const Element& e) {
        if (level_options::dies(level_, tr, e, zone)) keys.push_back(key(tr, e));
      };
      if constexpr (lists) level_.for_each_queued(look);
      else if (!level_.empty()) look(level_.next_element());
    }
    return keys;
  }

  /// Nothing of `before` has left the set.
  void expect_kept(const Tr& tr, const std::vector<Key>& before, const Proposal<Tr>& proposal) {
    if (!lists || book_->ended()) return;
    const std::vector<Key> after = queued_keys(tr);
    std::vector<Key> lost;
    std::ranges::set_difference(before, after, std::back_inserter(lost));
    if (!lost.empty())
      breach("drops an element from its set that was not popped and does not die",
             words(lost.front()) + ", when " + describe(tr, proposal) + " is refined");
  }

  /// Asks, and holds the answer against the laws.
  template <class Ask>
  auto judge(const Tr& tr, const Proposal<Tr>& proposal, Ask&& ask) {
    const std::vector<Key> before = queued_keys(tr);
    const bool was_empty = level_.empty();
    const auto answer = ask();
    if (answer == Verdict::rejected) {
      if (proposal.level == index_) breach("rejects points of its own", describe(tr, proposal));
      else if (level_.empty()) breach("rejects a point and has no work of its own", describe(tr, proposal));
    }
    if (answer == Verdict::rejected_forever && (queued_keys(tr) != before || level_.empty() != was_empty))
      breach("rejects a point for ever and changes its set", describe(tr, proposal));
    expect_kept(tr, before, proposal);
    return answer;
  }

  L level_;
  LevelIndex index_;
  LawBook* book_;
  std::string who_;
};

}  // namespace delref::testing
