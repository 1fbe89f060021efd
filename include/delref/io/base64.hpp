// SPDX-License-Identifier: GPL-3.0-or-later
//
// Base64 (RFC 4648, section 4) as VTK's XML files use it: written piece by piece, and read back with padding wherever it stands,
// since some writers encode the length of an array apart from the array.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <delref/io/text_sink.hpp>

namespace delref {

/// Encodes the bytes of numbers. Call `finish` at the end.
class Base64Writer {
 public:
  explicit Base64Writer(TextSink& out) : out_(out) {}

  template <class Number>
    requires std::is_arithmetic_v<Number>
  void put(Number value) {
    for (const unsigned char byte : std::bit_cast<std::array<unsigned char, sizeof(Number)>>(value)) {
      group_ = group_ << 8 | byte;
      if (++size_ == 3) put_group();
    }
  }
  void finish() {
    if (size_ == 0) return;
    const unsigned missing = 3 - size_;
    for (unsigned i = 0; i != missing; ++i) group_ <<= 8;
    put_group(missing);
  }

 private:
  void put_group(unsigned missing = 0) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::array<char, 4> text{};
    for (std::size_t i = 0; i != 4; ++i) text[i] = digits[group_ >> (18 - 6 * i) & 63];
    for (std::size_t i = 0; i != missing; ++i) text[3 - i] = '=';
    out_ << std::string_view(text.data(), text.size());
    group_ = size_ = 0;
  }

  TextSink& out_;
  std::uint32_t group_ = 0;
  unsigned size_ = 0;
};

/// The bytes that the text encodes, at most `limit` of them; blanks and ends of lines are skipped. Nothing when there is another
/// character that is no digit, or the last group is not whole.
inline std::optional<std::string> decode_base64(std::string_view text, std::size_t limit = std::numeric_limits<std::size_t>::max()) {
  static constexpr std::array<signed char, 256> values = [] {
    std::array<signed char, 256> table{};
    table.fill(-1);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i != digits.size(); ++i) table[static_cast<unsigned char>(digits[i])] = static_cast<signed char>(i);
    return table;
  }();
  std::string bytes;
  bytes.reserve(limit < text.size() ? limit : text.size() / 4 * 3);
  std::uint32_t group = 0;
  unsigned size = 0, missing = 0;
  for (const char c : text) {
    if (bytes.size() >= limit) break;
    if (c == ' ' || c == '\n' || c == '\t' || c == '\r') continue;
    const int value = c == '=' ? 0 : values[static_cast<unsigned char>(c)];
    if (value < 0 || (c == '=' && size < 2) || (c != '=' && missing != 0)) return std::nullopt;
    missing += c == '=';
    group = group << 6 | static_cast<std::uint32_t>(value);
    if (++size != 4) continue;
    for (unsigned i = 0; i != 3 - missing; ++i) bytes += static_cast<char>(group >> (16 - 8 * i) & 255);
    group = size = missing = 0;
  }
  if (size != 0 && bytes.size() < limit) return std::nullopt;
  if (bytes.size() > limit) bytes.resize(limit);
  return bytes;
}

}  // namespace delref
