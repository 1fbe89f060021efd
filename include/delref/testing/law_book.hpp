// SPDX-License-Identifier: MIT
//
// Keeps the breaches of laws that a run commits, one sentence for each law and level, however often it is broken.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delref::testing {

/// The laws that were broken.
class LawBook {
 public:
  /// Notes that `who` broke `law`, which reads as the rest of a sentence that begins with `who`; `where` is the occasion.
  void breach(std::string_view who, std::string_view law, std::string_view where) {
    for (Breach& b : breaches_)
      if (b.who == who && b.law == law) {
        ++b.times;
        return;
      }
    breaches_.push_back({std::string(who), std::string(law), std::string(where), 1});
  }
  /// Asks for the end of the run: after this breach what the levels hold is no longer safe to look at.
  void end_run() { ended_ = true; }
  bool ended() const { return ended_; }

  /// One sentence for each law and level, in the order in which they were first broken.
  std::vector<std::string> sentences() const {
    std::vector<std::string> result;
    for (const Breach& b : breaches_)
      result.push_back(b.who + " " + b.law + " (" + (b.times == 1 ? "once" : std::to_string(b.times) + " times, first") + ": " +
                       b.where + ")");
    return result;
  }

 private:
  struct Breach {
    std::string who, law, where;
    std::size_t times;
  };
  std::vector<Breach> breaches_;
  bool ended_ = false;
};

}  // namespace delref::testing
