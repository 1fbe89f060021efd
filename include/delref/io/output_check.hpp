// SPDX-License-Identifier: GPL-3.0-or-later
//
// The input of a run is never written over by its output.
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <delref/io/file.hpp>

namespace delref::detail {

/// Throws `OutputError` when one of the files to be written is the input.
inline void refuse_to_write_over(const std::filesystem::path& input_file, const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    std::error_code ignored;
    if (input_file.empty() || !std::filesystem::equivalent(file, input_file, ignored)) continue;
    throw OutputError(fmt::format("{}: would be written over the input {}; choose another name", file.string(), input_file.string()));
  }
}

}  // namespace delref::detail
