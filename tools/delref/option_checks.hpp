// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command line asks of the values of its options, and the words in which it refuses others.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <delref/criteria/angle_bound.hpp>

namespace delref::program {

/// A check of CLI11 on a number that `is_right`; `words` say what it must be.
template <class Predicate>
CLI::Validator number(std::string words, Predicate is_right) {
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && is_right(value)) return std::string();
        return fmt::format("{} is not {}", text.empty() ? "nothing" : text, words);
      },
      "");
}

inline CLI::Validator positive(const std::string& what) {
  return number(what + " greater than 0", [](double x) { return std::isfinite(x) && x > 0; });
}
inline CLI::Validator not_negative(const std::string& what) {
  return number(what + ", 0 or greater", [](double x) { return std::isfinite(x) && x >= 0; });
}
inline CLI::Validator whole(const std::string& what) {
  return number(what + " greater than 0", [](double x) { return x >= 1 && x <= 4e9 && std::floor(x) == x; });
}

/// Refuses what no mesh can meet, in the words of the library.
inline CLI::Validator angle() {
  return CLI::Validator(
      [](std::string& text) {
        double degrees = 0;
        if (!CLI::detail::lexical_cast(text, degrees)) return fmt::format("{} is not a number of degrees", text);
        try {
          static_cast<void>(AngleBound::degrees(degrees));
          return std::string();
        } catch (const InvalidInput& error) {
          return std::string(error.what());
        }
      },
      "");
}

inline CLI::Validator between(const std::string& what, double least, double most) {
  return number(fmt::format("{} from {:g} to {:g}", what, least, most), [=](double x) { return x >= least && x <= most; });
}
/// The smallest bound that the library takes.
inline CLI::Validator radius_edge() {
  return number("a ratio of at least 1, under which refinement would never end", [](double x) { return std::isfinite(x) && x >= 1; });
}

inline CLI::Validator finite() {
  return number("a number", [](double x) { return std::isfinite(x); });
}

inline CLI::Validator one_of(std::string first, std::string second) {
  return CLI::Validator(
      [=](std::string& text) {
        return text == first || text == second ? std::string() : fmt::format("\"{}\" is neither {} nor {}", text, first, second);
      },
      "");
}

}  // namespace delref::program
