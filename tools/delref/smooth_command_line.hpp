// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options of the command line that are for smooth domains only, and how an option remembers the kinds of input it is for.
#pragma once

#include <vector>

#include <CLI/CLI.hpp>

#include <delref/io/report.hpp>

#include "input_kind.hpp"

namespace delref::program {

/// An option with the kinds of input for which it has a meaning.
struct KindOption {
  CLI::Option* option;
  InputKinds kinds;
};
using Criteria = std::vector<KindOption>;

inline constexpr InputKinds every_kind = space_kinds | InputKind::plane;

/// What says which smooth domain is meant, for `mesh` and `verify`.
Criteria add_sources(CLI::App& command, ReportedSmoothOptions& options);

/// What is asked of smooth surfaces and of the regions between them, for both.
Criteria add_smooth_criteria(CLI::App& command, ReportedSmoothOptions& options);

}  // namespace delref::program
