// SPDX-License-Identifier: MIT
//
// The frame: refines a triangulation by a stack of levels, the first of which has the highest priority. After Rineau and Yvinec,
// "A generic software design for Delaunay refinement meshing" (2007): their `previous` references and nested visitors are here
// the order of a parameter pack and a fold over a tuple.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/level_options.hpp>
#include <delref/core/observer.hpp>
#include <delref/core/outcome.hpp>

namespace delref {

/// What one step of a mesher did.
enum class Step : unsigned char {
  inserted,          ///< a refinement point was inserted
  rejected,          ///< a level of higher priority rejected it and has work of its own now
  rejected_forever,  ///< an element left its set for good
  done               ///< every set is empty
};

/// Refines `tr` by `Levels...`, in the order of their priority.
///
/// One step takes the first level whose set is not empty, its next element, the refinement point of that, and the conflict zone of
/// the point; asks the levels from the first down to the proposing one; and inserts the point into that zone when all permit it.
/// When one rejects it the element stays where it is, and the rejecting level has work that comes first. When one rejects it for
/// ever, or the point cannot be inserted (not finite, outside, on a vertex, not killing its element), the element leaves the set
/// for good and is kept with its reason.
///
/// The mesher owns the levels and refers to the triangulation, which must outlive it. Between steps the triangulation may be looked
/// at; after it was changed from outside, call `scan`. If user code throws, the triangulation is valid and the next step scans
/// anew. Refinement ends when every set is empty (whether that happens is a theorem about the levels) or the control says stop.
template <class Tr, class... Levels>
class Mesher {
  static_assert(explain_triangulation<Tr>());
  static_assert((explain_level<Levels, Tr>() && ...));
  static_assert(sizeof...(Levels) > 0 && sizeof...(Levels) < input_level, "a mesher needs between 1 and 254 levels");

 public:
  using Point = typename Tr::Point;
  using Vertex = typename Tr::Vertex;
  static constexpr std::size_t level_count = sizeof...(Levels);

  explicit Mesher(Tr& tr, Levels... levels) : Mesher(tr, std::tuple<Levels...>(std::move(levels)...)) {}

  Mesher(Tr& tr, std::tuple<Levels...> levels) : tr_(&tr), levels_(std::move(levels)) {
    each_level([&](auto index, auto& level) {
      counts_[index].name = level_options::name(level, static_cast<LevelIndex>(index));
      assign_slot<index>(level);
    });
  }

  Tr& triangulation() { return *tr_; }
  const Tr& triangulation() const { return *tr_; }
  template <std::size_t I>
  auto& level() { return std::get<I>(levels_); }
  template <std::size_t I>
  const auto& level() const { return std::get<I>(levels_); }

  /// Gives a level away, with its state, to be used in another mesher. This mesher must not be used any more.
  template <std::size_t I>
  auto release() { return std::move(std::get<I>(levels_)); }

  /// Empties all sets and fills them from the whole triangulation. What was rejected for ever is reconsidered.
  template <class... Observers>
  void scan(Observers&... observers) {
    static_assert((explain_observer<Observers, Tr>() && ...));
    scanned_ = false;
    tr_->clear_slots();
    given_up_.clear();
    each_level([&](auto, auto& level) { level.scan_triangulation(*tr_); });
    notify::scanned(std::as_const(*tr_), observers...);
    scanned_ = true;
  }

  /// Does one step, scanning first if that was not done yet.
  template <class... Observers>
  Step step(Observers&... observers) {
    static_assert((explain_observer<Observers, Tr>() && ...));
    if (!scanned_) scan(observers...);
    scanned_ = false;  // stays so if user code throws
    const Step result = step_from<0>(observers...);
    scanned_ = true;
    return result;
  }

  /// True when every set is empty.
  bool done() const {
    return scanned_ && std::apply([](const auto&... level) { return (level.empty() && ...); }, levels_);
  }

  /// How many elements wait in the set of each level, as far as the levels tell: a level without `queued()` counts for 1 unless its
  /// set is empty. Constant time.
  std::array<std::size_t, level_count> queued() const {
    std::array<std::size_t, level_count> counts{};
    each_level([&](auto index, const auto& level) { counts[index] = level_options::queued(level); });
    return counts;
  }

  /// Steps until every set is empty or the control says stop; may be called again to go on.
  template <class... Observers>
  Outcome<Point> refine(const Control& control = Control{}, Observers&... observers) {
    if (!scanned_) scan(observers...);
    std::optional<Stop> stopped;
    for (std::size_t steps = 0; !stopped; ++steps) {
      if (tr_->number_of_vertices() >= control.budget().max_vertices && !done()) stopped = Stop::vertices;
      else if (steps % steps_between_looks == 0) stopped = look_up(control, observers...);
      if (!stopped && step(observers...) == Step::done) break;
    }
    Outcome<Point> result = outcome();
    result.stopped = stopped;
    return result;
  }

  /// What was done so far, and every element still in the mesh that was given up or is still queued.
  Outcome<Point> outcome() const {
    Outcome<Point> result;
    result.finished = done();
    result.levels.assign(counts_.begin(), counts_.end());
    for (const GivenUp& g : given_up_) {
      if (is_still_there(g)) result.unmet.push_back(describe(g));
    }
    each_level([&](auto index, const auto& level) {
      level_options::for_each_queued(level, [&](const auto& e) {
        if (++result.levels[index].queued > Outcome<Point>::listed_per_level) return;
        result.unmet.push_back(describe(given_up(level, static_cast<LevelIndex>(index), e, Reason::budget)));
      });
    });
    return result;
  }

 private:
  struct GivenUp {
    LevelIndex level;
    Reason reason;
    std::string criterion;
    std::array<Vertex, 4> vertices;
    std::array<std::size_t, 4> indices;
    std::size_t vertex_count;
  };

  /// What the clock and the token are asked after, and observers are told how far the run is.
  static constexpr std::size_t steps_between_looks = 256;

  template <class... Observers>
  std::optional<Stop> look_up(const Control& control, Observers&... observers) const {
    if constexpr ((ObservesProgress<Observers, Tr> || ...)) notify::progress(std::as_const(*tr_), queued(), observers...);
    const std::optional<Stop> stopped = control.stop_refining(tr_->number_of_vertices());
    return stopped && !done() ? stopped : std::nullopt;
  }

  template <class F>
  void each_level(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (f(std::integral_constant<std::size_t, I>{}, std::get<I>(levels_)), ...);
    }(std::index_sequence_for<Levels...>{});
  }
  template <class F>
  void each_level(F&& f) const {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (f(std::integral_constant<std::size_t, I>{}, std::get<I>(levels_)), ...);
    }(std::index_sequence_for<Levels...>{});
  }

  /// The number of levels before `I` that use a slot of the same element.
  template <std::size_t I>
  static consteval std::size_t slot_of() {
    using E = typename std::tuple_element_t<I, std::tuple<Levels...>>::Element;
    return []<std::size_t... J>(std::index_sequence<J...>) {
      return (std::size_t{0} + ... +
              std::size_t{level_options::UsesSlot<std::tuple_element_t<J, std::tuple<Levels...>>> &&
                          std::is_same_v<typename std::tuple_element_t<J, std::tuple<Levels...>>::Element, E>});
    }(std::make_index_sequence<I>{});
  }

  template <class E>
  static constexpr bool counts_slots = requires { Tr::template slot_count<E>; };

  template <std::size_t I, class L>
  static void assign_slot(L& level) {
    if constexpr (level_options::UsesSlot<L>) {
      static_assert(counts_slots<typename L::Element>,
                    "a triangulation whose elements keep the place of a level needs: a constant slot_count<Element>, slot(element, k) "
                    "and set_slot(element, k, position)");
      static_assert(slot_of<I>() < Tr::template slot_count<typename L::Element>,
                    "this triangulation has too few slots: more levels keep their place in an element than the element has slots; "
                    "use a triangulation type with more slots per element");
      level.assign_slot(slot_of<I>());
    }
  }

  template <std::size_t I, class... Observers>
  Step step_from(Observers&... observers) {
    if constexpr (I == sizeof...(Levels)) return Step::done;
    else {
      auto& level = std::get<I>(levels_);
      if (level.empty()) return step_from<I + 1>(observers...);
      return propose<I>(level, observers...);
    }
  }

  /// The per-element step of level I.
  template <std::size_t I, class L, class... Observers>
  Step propose(L& level, Observers&... observers) {
    const typename L::Element element = level.next_element();
    Proposal<Tr> proposal;
    proposal.level = static_cast<LevelIndex>(I);
    proposal.vertex_count = put_vertices(level, element, proposal.vertices);

    if (const auto reason = level_options::give_up(level, *tr_, element)) return drop<I>(element, proposal, *reason, observers...);
    proposal.point = level.refinement_point(std::as_const(*tr_), element);
    proposal.carrier = level_options::carrier(level, std::as_const(*tr_), element);
    notify::proposed(std::as_const(*tr_), proposal, observers...);
    if (!is_finite(proposal.point)) return drop<I>(element, proposal, Reason::precision, observers...);

    const Location<Tr> location = level_options::conflict_zone(level, *tr_, element, proposal.point, zone_);
    using Kind = typename Location<Tr>::Kind;
    if (location.kind == Kind::blocked) return blocked<I>(element, location.blocker, proposal, observers...);
    if (location.kind == Kind::outside) return drop<I>(element, proposal, Reason::outside, observers...);
    if (location.kind != Kind::zone || !level_options::dies(level, std::as_const(*tr_), element, zone_))
      return drop<I>(element, proposal, Reason::precision, observers...);
    proposal.zone = &zone_;

    if (const auto verdict = ask<I, 0>(element, proposal, observers...)) return *verdict;
    return insert<I>(proposal, observers...);
  }

  /// Asks level J and those after it, down to I. Nothing when all permit.
  template <std::size_t I, std::size_t J, class E, class... Observers>
  std::optional<Step> ask(const E& element, const Proposal<Tr>& proposal, Observers&... observers) {
    if constexpr (J > I) return std::nullopt;
    else {
      const Verdict verdict = std::get<J>(levels_).check_refinement_point(*tr_, proposal);
      if (verdict == Verdict::permitted) return ask<I, J + 1>(element, proposal, observers...);
      return refused<I, J>(element, proposal, verdict, observers...);
    }
  }

  /// Level J answered `rejected` or `rejected_forever` to a proposal of level I.
  template <std::size_t I, std::size_t J, class E, class... Observers>
  Step refused(const E& element, const Proposal<Tr>& proposal, Verdict verdict, Observers&... observers) {
    const auto& judge = std::get<J>(levels_);
    if (verdict == Verdict::rejected_forever)
      return drop<I>(element, proposal, level_options::rejection_reason(judge), observers...);
    if (I == J || judge.empty()) return drop<I>(element, proposal, Reason::level_contract, observers...);
    ++counts_[I].rejected;
    notify::rejected(std::as_const(*tr_), proposal, static_cast<LevelIndex>(J), observers...);
    return Step::rejected;
  }

  /// A constraint hides the point from its element: the first level that owns the constraint decides.
  template <std::size_t I, std::size_t J = 0, class E, class... Observers>
  Step blocked(const E& element, const typename Tr::Edge& blocker, const Proposal<Tr>& proposal, Observers&... observers) {
    if constexpr (J >= I) return drop<I>(element, proposal, Reason::blocked, observers...);
    else {
      const auto verdict = level_options::check_blocked(std::get<J>(levels_), *tr_, blocker, proposal);
      if (!verdict || *verdict == Verdict::permitted) return blocked<I, J + 1>(element, blocker, proposal, observers...);
      return refused<I, J>(element, proposal, *verdict, observers...);
    }
  }

  /// Takes the element out of the set of level I for good.
  template <std::size_t I, class E, class... Observers>
  Step drop(const E& element, const Proposal<Tr>& proposal, Reason reason, Observers&... observers) {
    auto& level = std::get<I>(levels_);
    given_up_.push_back(given_up(level, static_cast<LevelIndex>(I), element, reason));
    level.pop_next_element(*tr_);
    level_options::on_rejected_forever(level, *tr_, element, reason);
    ++counts_[I].rejected_forever;
    notify::rejected_forever(std::as_const(*tr_), proposal, reason, observers...);
    return Step::rejected_forever;
  }

  /// Everybody permits: the point is inserted into its zone.
  template <std::size_t I, class... Observers>
  Step insert(const Proposal<Tr>& proposal, Observers&... observers) {
    for (const Vertex gone : zone_.vanishing()) forget(tr_->index(gone));
    each_level([&](auto, auto& l) { l.before_insertion(*tr_, proposal); });
    notify::before_insertion(std::as_const(*tr_), proposal, observers...);
    const Vertex v = level_options::insert(std::get<I>(levels_), *tr_, proposal.point, zone_);
    ++counts_[I].inserted;
    tr_->set_origin(v, proposal.carrier, proposal.level);
    each_level([&](auto, auto& l) { l.after_insertion(*tr_, v, proposal); });
    notify::after_insertion(std::as_const(*tr_), v, proposal, observers...);
    return Step::inserted;
  }

  /// A vertex is about to vanish: its handle must not be used any more.
  void forget(std::size_t gone) {
    if (gone >= vanished_.size()) vanished_.resize(gone + gone / 2 + 1);
    vanished_[gone] = true;
  }
  bool is_still_there(const GivenUp& g) const {
    for (std::size_t i = 0; i < g.vertex_count; ++i)
      if (g.indices[i] < vanished_.size() && vanished_[g.indices[i]]) return false;
    const std::span<const Vertex> vertices(g.vertices.data(), g.vertex_count);
    bool holds = false;
    each_level([&](auto index, const auto& level) {
      if (index == g.level) holds = level_options::holds(level, std::as_const(*tr_), vertices);
    });
    return holds;
  }

  template <class L, class E>
  GivenUp given_up(const L& level, LevelIndex index, const E& element, Reason reason) const {
    GivenUp g{index, reason, level_options::unmet_criterion(level, index, std::as_const(*tr_), element), {}, {}, 0};
    g.vertex_count = put_vertices(level, element, g.vertices);
    for (std::size_t i = 0; i < g.vertex_count; ++i) g.indices[i] = tr_->index(g.vertices[i]);
    return g;
  }

  /// Gives their number. An element of too many vertices is refused: when compiling where its range tells its size, else when met.
  template <class L, class E>
  std::size_t put_vertices(const L& level, const E& element, std::array<Vertex, Proposal<Tr>::max_vertices>& out) const {
    auto&& vertices = level_options::element_vertices(level, std::as_const(*tr_), element);
    using Range = std::remove_cvref_t<decltype(vertices)>;
    constexpr bool tells_size = requires { std::tuple_size<Range>::value; };
    if constexpr (tells_size)
      static_assert(std::tuple_size<Range>::value <= Proposal<Tr>::max_vertices,
                    "an element of a level has at most 4 vertices, and element_vertices(tr, element) gives more");
    std::size_t count = 0;
    for (const Vertex v : vertices) {
      if constexpr (!tells_size)
        if (count == out.size()) throw std::length_error("delref: a level has an element of more than 4 vertices");
      out[count++] = v;
    }
    return count;
  }

  Unmet<Point> describe(const GivenUp& g) const {
    const std::span<const Vertex> vertices(g.vertices.data(), g.vertex_count);
    Unmet<Point> u{g.level, g.criterion, g.reason, tr_->barycentre(vertices), g.indices, g.vertex_count};
    return u;
  }

  Tr* tr_;
  std::tuple<Levels...> levels_;
  typename Tr::Zone zone_{};
  std::array<LevelCounts, sizeof...(Levels)> counts_{};
  std::vector<GivenUp> given_up_;
  std::vector<bool> vanished_;  // by vertex number
  bool scanned_ = false;
};

template <class Tr, class... Levels>
Mesher(Tr&, std::tuple<Levels...>) -> Mesher<Tr, Levels...>;

}  // namespace delref
