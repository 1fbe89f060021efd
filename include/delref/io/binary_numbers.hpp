// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers out of bytes, in the byte order of the file.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

namespace delref::detail {

/// The number whose bytes begin at `bytes`, in that order. Requires that there are enough of them.
template <class Number>
  requires std::is_arithmetic_v<Number>
Number number_from_bytes(const char* bytes, std::endian order) {
  std::array<char, sizeof(Number)> copy{};
  for (std::size_t i = 0; i != copy.size(); ++i) copy[i] = bytes[order == std::endian::native ? i : copy.size() - 1 - i];
  return std::bit_cast<Number>(copy);
}

}  // namespace delref::detail
