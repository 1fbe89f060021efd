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
  std::optional<Stop> stop() const {
    if (token_.stop_requested()) return Stop::token;
    if (Clock::now() - start_ > budget_.time_limit) return Stop::time;
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

}  // namespace delref
