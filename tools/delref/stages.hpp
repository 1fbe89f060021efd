// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of a run, one after the other: each is shown while it lasts, and its seconds are kept.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "progress.hpp"

namespace delref::program {

class Stages {
 public:
  /// `seconds` takes the time of each stage by its name.
  Stages(Progress& progress, std::vector<std::pair<std::string, double>>& seconds) : progress_(progress), seconds_(seconds) {}

  /// `name` is for the report; `words`, to go before the name of the input, for people.
  template <class Work>
  auto operator()(const char* name, const char* words, Work&& work) {
    progress_.begin(words);
    const auto begin = std::chrono::steady_clock::now();
    auto result = std::forward<Work>(work)();
    seconds_.emplace_back(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return result;
  }

 private:
  Progress& progress_;
  std::vector<std::pair<std::string, double>>& seconds_;
};

}  // namespace delref::program
