// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ctrl-C as a request to stop. The signals are blocked in every thread and taken by one thread that waits for them, so that no
// code ever runs inside a signal handler.
#pragma once

#include <csignal>
#include <functional>
#include <pthread.h>
#include <stop_token>
#include <thread>
#include <utility>

namespace delref::program {

/// While it lives, the first SIGINT or SIGTERM requests a stop of `token()`. The second one calls `at_second`, in a thread of its
/// own, which is to end the program; without it, and from the third on, they do what they do to any program. Make it before any
/// other thread. A signal that was ignored when the program started stays ignored.
class StopOnSignal {
 public:
  explicit StopOnSignal(std::function<void()> at_second = {}) : at_second_(std::move(at_second)) {
    sigemptyset(&stops_);
    for (const int signal : {SIGINT, SIGTERM})
      if (!is_ignored(signal)) sigaddset(&stops_, signal);
    sigemptyset(&wakes_);
    sigaddset(&wakes_, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &stops_, nullptr);
    pthread_sigmask(SIG_BLOCK, &wakes_, nullptr);
    watcher_ = std::thread([this] { watch(); });
  }
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  ~StopOnSignal() {
    pthread_kill(watcher_.native_handle(), SIGUSR2);
    watcher_.join();
  }

  std::stop_token token() const { return source_.get_token(); }

 private:
  static bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
  }
  /// Waits for the next signal; false when this object is at its end.
  bool is_signalled() const {
    sigset_t both = stops_;
    sigaddset(&both, SIGUSR2);
    int signal = 0;
    sigwait(&both, &signal);
    return signal != SIGUSR2;
  }

  void watch() {
    if (!is_signalled()) return;
    source_.request_stop();
    if (at_second_) {
      if (!is_signalled()) return;
      pthread_sigmask(SIG_UNBLOCK, &stops_, nullptr);  // this thread takes the third one, by the default action
      at_second_();
    } else {
      pthread_sigmask(SIG_UNBLOCK, &stops_, nullptr);
    }
    int signal = 0;
    sigwait(&wakes_, &signal);
  }

  std::function<void()> at_second_;
  sigset_t stops_{}, wakes_{};
  std::stop_source source_;
  std::thread watcher_;
};

}  // namespace delref::program
