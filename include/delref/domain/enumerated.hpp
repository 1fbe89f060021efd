// SPDX-License-Identifier: GPL-3.0-or-later
//
// How messages spell lists (see `describe.hpp` for numbers and points).
#pragma once

#include <cstddef>
#include <ranges>
#include <string>

namespace delref {

/// "3, 4 and 7"; of more than `most` words the first ones, "3, 4, 7 and 12 more".
template <std::ranges::random_access_range Words>
std::string enumerated(const Words& words, std::size_t most = 8) {
  const auto count = static_cast<std::size_t>(std::ranges::size(words));
  const std::size_t shown = count <= most ? count : most - 1;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == count ? " and " : ", ";
    text += words[i];
  }
  return shown < count ? text + " and " + std::to_string(count - shown) + " more" : text;
}

}  // namespace delref
