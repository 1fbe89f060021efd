// SPDX-License-Identifier: GPL-3.0-or-later
//
// File formats are told by the extension of a path.
#pragma once

#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace delref::detail {

/// The extension of a path, in lower case.
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

inline std::string unknown_extension(const std::filesystem::path& path, std::string_view what, std::string_view known) {
  const std::string extension = path.extension().string();
  return fmt::format("{}: {} {} known are {}", path.string(),
                     extension.empty() ? "the name has no extension that tells" : fmt::format("\"{}\" is not the extension of", extension), what, known);
}

}  // namespace delref::detail
