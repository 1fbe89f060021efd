// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "words.hpp"

namespace delref::program {
namespace {

bool can_move_cursor() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::size_t terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void put(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(bool shown, std::stop_token stop) : stop_(std::move(stop)), shown_(shown && can_move_cursor()) {
  if (shown_) drawer_ = std::jthread([this](const std::stop_token& finished) { draw_until(finished); });
}

void Progress::finish() {
  if (!drawer_.joinable()) return;
  drawer_.request_stop();
  drawer_.join();
  put("\r\x1b[K");
}

void Progress::silence() {
  if (!shown_) return;
  mutex_.lock();  // and never unlocks it: nothing is drawn any more
  put("\r\x1b[K");
}

void Progress::draw_until(const std::stop_token& finished) {
  std::unique_lock lock(mutex_);
  // The wait ends early only when the work is done: then there is nothing to draw.
  while (!tick_.wait_for(lock, finished, std::chrono::milliseconds(200), [&] { return finished.stop_requested(); })) draw();
}

/// "1,234 waiting"; in space by level, those of which none wait left out: "12 facets, 3,456 tetrahedra waiting".
std::string Progress::waiting() const {
  if (!in_space_.load(std::memory_order_relaxed)) {
    std::size_t total = 0;
    for (const auto& level : waiting_) total += level.load(std::memory_order_relaxed);
    return grouped(total) + " waiting";
  }
  std::string text;
  for (std::size_t level = 0; level < waiting_.size(); ++level)
    if (const std::size_t count = waiting_[level].load(std::memory_order_relaxed); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(count), level_names_[level].load(std::memory_order_relaxed));
  return (text.empty() ? "none" : text) + " waiting";
}

void Progress::draw() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string line = fmt::format("delref: {}", stop_.stop_requested() ? "stopping" : stage());
  if (refining_.load(std::memory_order_relaxed))
    line += fmt::format(", {} vertices, {}", grouped(vertices_.load(std::memory_order_relaxed)), waiting());
  line += fmt::format(", {:.1f} s", seconds);
  if (const std::size_t width = terminal_width(); line.size() >= width) line.resize(width - 1);
  put("\r" + line + "\x1b[K");
}

}  // namespace delref::program
