// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses JSON from strangers: nesting is bounded before anything is built, and a syntax error says where it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <delref/domain/invalid_input.hpp>

namespace delref {

/// JSON nested more deeply than this is refused.
inline constexpr int deepest_json = 64;

/// The line of a byte of a text, counted from 1.
inline std::size_t line_of(std::string_view text, std::size_t byte) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, byte), '\n'));
}

/// The value of a text in JSON; `name` is what complaints call the file. Throws `InvalidInput` with the line of the first error.
inline nlohmann::json parse_json(std::string_view text, const std::string& name) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i != text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') {
      if (++i == text.size()) break;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '[' || c == '{')) {
      if (++depth > deepest_json) {
        throw InvalidInput(fmt::format("{}, line {}: is nested more than {} deep", name, line_of(text, i), deepest_json));
      }
    } else if (!in_string && (c == ']' || c == '}')) {
      --depth;
    }
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string_view what = error.what();
    const auto colon = what.find("; last read");
    throw InvalidInput(fmt::format("{}, line {}: is not JSON: {}", name, line_of(text, error.byte), what.substr(0, colon)));
  } catch (const nlohmann::json::exception& error) {
    throw InvalidInput(fmt::format("{}: {}", name, error.what()));
  }
}

}  // namespace delref
