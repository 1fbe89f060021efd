// SPDX-License-Identifier: MIT
//
// How much a run may cost, and the one object through which every long stage of it (reading, checking, building, refining,
// writing) learns that it must stop.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>

namespace delref {

/// What a run may use. The defaults are generous, and finite: every run returns.
struct Budget {
  /// No more vertices than this in the triangulation, the input's included.
  std::size_t max_vertices = 20'000'000;
  /// Wall-clock time from the construction of the `Control`.
  std::chrono::duration<double> time_limit = std::chrono::hours(1);
  /// What refinement keeps back of the limit for each vertex in the triangulation, for what is done with the mesh afterwards.
  /// Someone who has to write the mesh within the limit says here how long that takes.
  std::chrono::duration<double> kept_back_per_vertex{0};
  /// An element whose shortest edge is not longer than this is not refined, in the unit of the input. 0: only where
  /// floating-point numbers end.
  double smallest_edge = 0;
};

/// Why a run stopped, if it did.
enum class Stop : unsigned char { vertices, time, token };

/// The budget and stop token of one run, with the clock started.
class Control {
 public:
  explicit Control(Budget budget = {}, std::stop_token token = {})
      : budget_(budget), token_(std::move(token)), start_(Clock::now()) {}

  const Budget& budget() const { return budget_; }

  /// Asks the token and the clock. Costs some 30 ns: ask once in a few hundred steps of a loop.
  std::optional<Stop> stop() const { return stop_refining(0); }

  /// The same for a refinement that has come to so many vertices: what is kept back for them counts as used.
  std::optional<Stop> stop_refining(std::size_t vertices) const {
    if (token_.stop_requested()) return Stop::token;
    const auto kept_back = static_cast<double>(vertices) * budget_.kept_back_per_vertex;
    if (Clock::now() - start_ + kept_back > budget_.time_limit) return Stop::time;
    return std::nullopt;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Budget budget_;
  std::stop_token token_;
  Clock::time_point start_;
};

/// Thrown by stages that have nothing to show yet (reading, checking, building) when `Control::stop` says so.
struct Interrupted {
  Stop cause;
};

/// Throws `Interrupted` when the control says stop.
inline void throw_if_stopped(const Control& control) {
  if (const auto cause = control.stop()) throw Interrupted{*cause};
}

/// `throw_if_stopped` for loops without a counter of their own, such as the comparisons of a sort: asks once in some thousand calls.
/// The control must outlive it.
class StopCheck {
 public:
  explicit StopCheck(const Control& control) : control_(&control) {}
  void operator()() {
    if (++calls_ % 8192 == 0) throw_if_stopped(*control_);
  }

 private:
  const Control* control_;
  std::size_t calls_ = 0;
};

}  // namespace delref
