// SPDX-License-Identifier: MIT
//
// A level that does what another level does and notes every law that this breaks (the laws are listed in core/level_concepts.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
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
    for (const Listed& e : listed(tr)) keys.push_back(e.key);
    return keys;
  }

  // -- the required members
  void scan_triangulation(Tr& tr) { level_.scan_triangulation(tr); }
  bool empty() const { return level_.empty(); }
  Element next_element() { return level_.next_element(); }
  void pop_next_element(Tr& tr) {
    std::vector<Key> before = queued_keys(tr);
    const Key next = list(tr, level_.next_element()).key;
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
    std::vector<Listed> expected = listed(tr);
    const std::vector<Listed> dying = dying_of(tr, *proposal.zone);
    changing_ = changing_of(tr, *proposal.zone);
    level_.before_insertion(tr, proposal);
    const std::vector<Listed> still_there = dying_of(tr, *proposal.zone);
    if (!still_there.empty()) {
      breach("keeps a dying element in its set", words(still_there.front().key) + ", when " + describe(tr, proposal) + " is killed");
      book_->end_run();
    }
    // Listed now: after the insertion an element may be known by a handle that is no more.
    kept_ = without_changing(listed(tr));
    if (!lists || (!tells_death && !knows_dead)) return;
    for (const Listed& e : dying) expected.erase(std::ranges::find(expected, e));
    expect_kept(tr, without_changing(expected), proposal);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& proposal) {
    level_.after_insertion(tr, v, proposal);
    expect_kept(tr, kept_, proposal);
    for (const Listed& e : listed(tr))
      if (is_dead(tr, e)) breach("keeps a dead element in its set", words(e.key) + ", after " + describe(tr, proposal) + " was killed");
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
  bool holds(const Tr& tr, std::span<const typename Tr::Vertex> vertices) const
    requires requires(const L& l) { l.holds(tr, vertices); }
  {
    return level_.holds(tr, vertices);
  }
  std::size_t queued() const requires requires(const L& l) { std::size_t{l.queued()}; } { return level_.queued(); }
  template <class F>
  void for_each_queued(F&& f) const requires requires(const L& l) { l.for_each_queued(f); } { level_.for_each_queued(f); }

 private:
  static constexpr bool lists = requires(const L& l, std::function<void(const Element&)> f) { l.for_each_queued(f); };
  /// It says itself which of its elements are no more.
  static constexpr bool knows_dead =
      requires(const L& l, const Tr& tr, std::span<const typename Tr::Vertex> v) { l.holds(tr, v); };
  /// Its elements die before the insertion: not those of a table of its own, which it may change after it.
  static constexpr bool tells_death =
      StoresElement<Tr, Element> ||
      (!knows_dead && requires(const L& l, const Tr& tr, const Element& e, const Zone& zone) { l.dies(tr, e, zone); });

  /// An element of its set, which may have died since.
  struct Listed {
    Key key;
    std::vector<typename Tr::Vertex> vertices;
    friend bool operator==(const Listed& a, const Listed& b) { return a.key == b.key; }
    friend auto operator<=>(const Listed& a, const Listed& b) { return a.key <=> b.key; }
  };
  Listed list(const Tr& tr, const Element& e) const {
    Listed result;
    result.key.fill(std::numeric_limits<std::size_t>::max());
    for (const auto v : level_options::element_vertices(level_, tr, e)) {
      if (result.vertices.size() == result.key.size()) break;
      result.key[result.vertices.size()] = tr.index(v);
      result.vertices.push_back(v);
    }
    std::ranges::sort(result.key);
    return result;
  }
  std::vector<Listed> listed(const Tr& tr) const {
    std::vector<Listed> elements;
    level_options::for_each_queued(level_, [&](const Element& e) { elements.push_back(list(tr, e)); });
    std::ranges::sort(elements);
    return elements;
  }
  bool is_dead(const Tr& tr, const Listed& e) const {
    if constexpr (knows_dead) return !level_.holds(tr, std::span<const typename Tr::Vertex>(e.vertices));
    else return false;
  }
  static std::string words(const Key& key) {
    std::string text = "vertices";
    for (const std::size_t v : key)
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
  std::vector<Listed> dying_of(const Tr& tr, const Zone& zone) {
    std::vector<Listed> dying;
    if constexpr (tells_death) {
      const auto look = [&](const Element& e) {
        if (is_killed(tr, e, zone)) dying.push_back(list(tr, e));
      };
      if constexpr (lists) level_.for_each_queued(look);
      else if (!level_.empty()) look(level_.next_element());
    }
    return dying;
  }

  /// What the triangulation stores dies with it; of other elements the level knows.
  bool is_killed(const Tr& tr, const Element& e, const Zone& zone) const {
    if constexpr (StoresElement<Tr, Element>) return tr.dies(e, zone);
    else return level_options::dies(level_, tr, e, zone);
  }
  /// The elements of its set that stay in the triangulation but are others for the level when the zone is filled: they may leave its set,
  /// at any time.
  std::vector<Listed> changing_of(const Tr& tr, const Zone& zone) const {
    std::vector<Listed> changing;
    if constexpr (StoresElement<Tr, Element> && lists)
      level_.for_each_queued([&](const Element& e) {
        if (level_options::dies(level_, tr, e, zone) && !tr.dies(e, zone)) changing.push_back(list(tr, e));
      });
    std::ranges::sort(changing);
    return changing;
  }
  std::vector<Listed> without_changing(const std::vector<Listed>& elements) const {
    std::vector<Listed> rest;
    std::ranges::set_difference(elements, changing_, std::back_inserter(rest));
    return rest;
  }

  /// Nothing of `before` has left the set, but what is dead by now.
  void expect_kept(const Tr& tr, const std::vector<Listed>& before, const Proposal<Tr>& proposal) {
    if (!lists || book_->ended()) return;
    const std::vector<Listed> after = listed(tr);
    std::vector<Listed> lost;
    std::ranges::set_difference(before, after, std::back_inserter(lost));
    std::erase_if(lost, [&](const Listed& e) { return is_dead(tr, e); });
    if (!lost.empty())
      breach("drops an element from its set that was not popped and does not die",
             words(lost.front().key) + ", when " + describe(tr, proposal) + " is refined");
  }

  /// Asks, and holds the answer against the laws.
  template <class Ask>
  auto judge(const Tr& tr, const Proposal<Tr>& proposal, Ask&& ask) {
    const std::vector<Listed> before = listed(tr);
    const bool was_empty = level_.empty();
    const auto answer = ask();
    if (answer == Verdict::rejected) {
      if (proposal.level == index_) breach("rejects points of its own", describe(tr, proposal));
      else if (level_.empty()) breach("rejects a point and has no work of its own", describe(tr, proposal));
    }
    if (answer == Verdict::rejected_forever && (listed(tr) != before || level_.empty() != was_empty))
      breach("rejects a point for ever and changes its set", describe(tr, proposal));
    expect_kept(tr, before, proposal);
    return answer;
  }

  L level_;
  LevelIndex index_;
  LawBook* book_;
  std::string who_;
  std::vector<Listed> changing_, kept_;  // by the insertion that is under way
};

}  // namespace delref::testing
