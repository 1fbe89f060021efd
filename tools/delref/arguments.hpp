// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user asked for, as plain data: made by command_line.cpp, which has checked every number, and taken by the commands.
#pragma once

#include <string>
#include <vector>

#include <delref/io/report.hpp>

#include "input_kind.hpp"

namespace delref::program {

/// The gradation when `--size-points` is given without `--gradation`.
inline constexpr double default_gradation = 0.3;

/// The options as they are before the command line changes them.
inline ReportedOptions default_options() {
  ReportedOptions options;
  options.min_angle_degrees = 20.7;
  options.encroachment = "circle";
  options.points = "off-centre";
  return options;
}

struct MeshArguments {
  std::string input;  ///< empty: --implicit
  std::vector<std::string> outputs;
  ReportedOptions options = default_options();
  ReportedSmoothOptions smooth;    ///< of smooth domains; `options` has none of them yet
  std::vector<GivenOption> given;  ///< those that have a meaning for some kinds of input only
  std::string report;              ///< empty: none
  bool svg_by_region = false;      ///< what the colours of an .svg tell
  bool regions = false;            ///< print them
  bool strict = false;
  bool quiet = false;
};

struct VerifyArguments {
  std::string input;  ///< empty: --implicit, or as the report says
  std::string mesh;
  std::string report;  ///< empty: the promises are in `options`
  ReportedOptions options = default_options();
  ReportedSmoothOptions smooth;
  std::vector<GivenOption> given;
};

struct InfoArguments {
  std::string mesh;
};

}  // namespace delref::program
