// SPDX-License-Identifier: MIT
//
// Everything that a run does, in order, to be compared with another run.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/observer.hpp>

namespace delref::testing {

/// An observer that keeps every event of a run on `Tr`.
template <class Tr>
class RunTrace {
 public:
  void on_scanned(const Tr& tr) { events_.push_back({"scan", 0, tr.number_of_vertices(), {}, {}, {}}); }
  void on_proposed(const Tr& tr, const Proposal<Tr>& p) { note("proposal", tr, p, 0); }
  void on_rejected(const Tr& tr, const Proposal<Tr>& p, LevelIndex by) { note("rejection", tr, p, by); }
  void on_rejected_forever(const Tr& tr, const Proposal<Tr>& p, Reason why) {
    note("rejection for ever", tr, p, static_cast<std::size_t>(why));
  }
  void on_after_insertion(const Tr& tr, typename Tr::Vertex v, const Proposal<Tr>& p) {
    events_.push_back({"insertion", p.level, tr.index(v), tr.point(v), tr.carrier(v), {}});
  }

  std::size_t size() const { return events_.size(); }

  /// Where two traces part, as words; empty when they do not.
  friend std::string difference(const RunTrace& a, const RunTrace& b) {
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
      if (!same(a.events_[i], b.events_[i])) {
        const std::string what = a.events_[i].what == b.events_[i].what ? "another " + b.events_[i].what : b.events_[i].what;
        return "event " + std::to_string(i) + " is a " + a.events_[i].what + " of level " + std::to_string(a.events_[i].level) +
               " in the first, " + what + " of level " + std::to_string(b.events_[i].level) + " in the second";
      }
    if (a.size() == b.size()) return {};
    return "one has " + std::to_string(a.size()) + " events, the other " + std::to_string(b.size());
  }

 private:
  using Point = typename Tr::Point;
  struct Event {
    std::string what;
    LevelIndex level = 0;
    std::size_t number = 0;  // of the vertex, the level or the reason that the event is about
    Point point{};
    Carrier carrier{};
    std::array<std::size_t, 4> vertices{};
  };

  void note(std::string what, const Tr& tr, const Proposal<Tr>& p, std::size_t number) {
    Event& e = events_.emplace_back(Event{std::move(what), p.level, number, p.point, p.carrier, {}});
    for (std::size_t i = 0; i < p.vertex_count; ++i) e.vertices[i] = tr.index(p.vertices[i]);
  }

  static bool same(const Event& a, const Event& b) {
    return a.what == b.what && a.level == b.level && a.number == b.number && a.carrier == b.carrier && a.vertices == b.vertices &&
           same_point(a.point, b.point);
  }
  static bool same_point(const Point& a, const Point& b) {
    if constexpr (std::equality_comparable<Point>) return a == b || (!is_finite(a) && !is_finite(b));
    else return is_finite(a) == is_finite(b);
  }

  std::vector<Event> events_;
};

}  // namespace delref::testing
