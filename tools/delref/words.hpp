// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the program spells numbers for people.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace delref::program {

/// "1,234,567".
inline std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

/// "1 triangle", "1,234 triangles".
inline std::string counted(std::size_t number, const char* one, const char* many) {
  return grouped(number) + ' ' + (number == 1 ? one : many);
}

/// "3, 7, 9", and "and 5 more" after so many that they fill a line.
inline std::string list_of(const std::vector<int>& labels) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(labels.size(), most); ++i) text += (i > 0 ? ", " : "") + std::to_string(labels[i]);
  return labels.size() > most ? fmt::format("{} and {} more", text, labels.size() - most) : text;
}

/// "0.004 s", "12.3 s".
inline std::string seconds_text(double seconds) {
  return fmt::format("{:.{}f} s", seconds, seconds < 1 ? 3 : seconds < 10 ? 2 : 1);
}

}  // namespace delref::program
