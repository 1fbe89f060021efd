// SPDX-License-Identifier: GPL-3.0-or-later
//
// One line on the terminal that says what the program is doing. A thread of its own draws it, so that it moves while files are
// read and checked as well; the work only stores a number now and then.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <thread>

namespace delref::program {

/// Draws at most five times a second on standard error while it lives, and wipes the line at the end. An observer of the mesher.
class Progress {
 public:
  /// Draws nothing unless `shown` and standard error is a terminal that can move its cursor. When `stop` is requested the line
  /// says so.
  Progress(bool shown, std::stop_token stop);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { finish(); }

  /// What is being done from now on, such as "reading"; the text must live as long as the program.
  void begin(const char* stage) { stage_.store(stage, std::memory_order_relaxed); }
  const char* stage() const { return stage_.load(std::memory_order_relaxed); }
  /// What waits in each level, as words, from the highest priority on; those of polyhedral meshes unless told. Before refining begins.
  void name_levels(const std::array<const char*, 3>& names) { std::ranges::copy(names, level_names_.begin()); }
  /// Wipes the line and draws no more.
  void finish();
  /// The same for the last words of a program that ends without destroying anything. From any thread.
  void silence();

  template <class Tr>
  void on_scanned(const Tr& tr) {
    vertices_.store(tr.number_of_vertices(), std::memory_order_relaxed);
    refining_.store(true, std::memory_order_relaxed);
    begin("refining");
  }
  template <class Tr>
  void on_progress(const Tr& tr, std::span<const std::size_t> queued) {
    vertices_.store(tr.number_of_vertices(), std::memory_order_relaxed);
    for (std::size_t level = 0; level < std::min(queued.size(), waiting_.size()); ++level)
      waiting_[level].store(queued[level], std::memory_order_relaxed);
    in_space_.store(Tr::dimension == 3, std::memory_order_relaxed);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void draw_until(const std::stop_token& finished);
  void draw() const;
  std::string waiting() const;

  std::atomic<const char*> stage_{"starting"};
  std::atomic<std::size_t> vertices_{0};
  std::array<std::atomic<std::size_t>, 3> waiting_{};  ///< per level
  std::array<std::atomic<const char*>, 3> level_names_{"edges", "facets", "tetrahedra"};
  std::atomic<bool> in_space_{false};
  std::atomic<bool> refining_{false};
  Clock::time_point start_ = Clock::now();
  std::stop_token stop_;
  const bool shown_;
  std::mutex mutex_;
  std::condition_variable_any tick_;
  std::jthread drawer_;
};

}  // namespace delref::program
