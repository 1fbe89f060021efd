// SPDX-License-Identifier: GPL-3.0-or-later
//
// Headers of images that are lines of a key, a separator and a value (INR, NRRD, MetaImage): numbers out of the values, each refused in
// words that name the key.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/domain/invalid_input.hpp>
#include <delref/images/voxel_values.hpp>

namespace delref::detail {

inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\f\v";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view{} : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Takes the first line off, without its end.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// One line of a header.
struct ImageField {
  std::string_view key, value;
  const std::string* file;

  [[noreturn]] void fail(std::string_view why) const {
    throw InvalidInput(fmt::format(R"({}: the header's "{}" is "{}"; {})", *file, shown(key), shown(value), why));
  }
  double number() const { return numbers(1)[0]; }
  /// A size along an axis.
  int size() const { return sizes(1)[0]; }

  /// So many numbers with blanks, commas or parentheses between them.
  std::vector<double> numbers(std::size_t count) const {
    std::vector<double> out;
    constexpr std::string_view between = " \t,()";
    for (std::string_view left = value; !(left = without(left, between)).empty();) {
      double number = 0;
      const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
      if (error != std::errc{} || out.size() == count)
        fail(fmt::format("{} expected", count == 1 ? "one number is" : fmt::format("{} numbers are", count)));
      left.remove_prefix(static_cast<std::size_t>(end - left.data()));
      if (!left.empty() && between.find(left.front()) == std::string_view::npos) fail("that is no number");
      out.push_back(number);
    }
    if (out.size() != count) fail(fmt::format("{} expected", count == 1 ? "one number is" : fmt::format("{} numbers are", count)));
    return out;
  }
  std::vector<int> sizes(std::size_t count) const {
    std::vector<int> out;
    for (const double n : numbers(count)) {
      if (!(n >= 1 && n <= std::numeric_limits<int>::max() && std::floor(n) == n)) fail("it must be a positive whole number");
      out.push_back(static_cast<int>(n));
    }
    return out;
  }

 private:
  static std::string_view without(std::string_view text, std::string_view leading) {
    const std::size_t first = text.find_first_not_of(leading);
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
  }
};

/// No header of an image is longer.
inline constexpr std::size_t longest_image_header = std::size_t{1} << 16;

}  // namespace delref::detail
