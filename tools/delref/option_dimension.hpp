// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the options that were given fit the input: some have a meaning in the plane only, some in space only.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/io/polyhedral_formats.hpp>

#include "arguments.hpp"
#include "exit_codes.hpp"

namespace delref::program {

/// Throws `UsageError` that names the options of the other dimension.
inline void refuse_options_of_the_other_dimension(const GivenOptions& given, Dimension dimension, const std::string& input,
                                                  const char* command) {
  const bool is_planar = dimension == Dimension::plane;
  const std::vector<std::string>& wrong = is_planar ? given.of_space : given.of_plane;
  if (wrong.empty()) return;
  std::string names = wrong.front();
  for (std::size_t i = 1; i < wrong.size(); ++i) names += (i + 1 < wrong.size() ? ", " : " and ") + wrong[i];
  throw UsageError(fmt::format("{} {} for domains {}, but {} lies {}\nRun `delref {} --help` to see what can be given.", names,
                               wrong.size() == 1 ? "is" : "are", is_planar ? "of space (3D)" : "of the plane (2D)", input,
                               is_planar ? "in the plane (2D)" : "in space (3D)", command));
}

}  // namespace delref::program
