// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the oracles of the program come from: expressions, images and sets of points, each read by a file of its own. A file without_...
// stands in for what the program was built without, and says so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/io/report.hpp>

#include "any_oracle.hpp"

namespace delref::program {

/// What a smooth run meshes.
struct SmoothDomain {
  AnyOracle oracle;
  /// What it is, for people: "an image of 64 x 64 x 64 voxels ...".
  std::string words;
  /// The facet size and distance that suit it, where nothing else is asked for; none: those of the library.
  std::optional<double> usual_facet_size{}, usual_facet_distance{};
  /// Why this size, as a clause after it.
  std::string why_usual{};
};

// Each throws `InvalidInput` in words, and `Interrupted`; what its user has to know besides is added to `notes`.

/// Of the expressions and bounds that the options have.
SmoothDomain function_domain(const ReportedSmoothOptions& options, const Control& control, std::vector<std::string>& notes);
/// Of an image, with grey levels or with labels.
SmoothDomain image_domain(const std::string& path, const ReportedSmoothOptions& options, const Control& control,
                          std::vector<std::string>& notes);
/// Of points on a surface.
SmoothDomain point_set_domain(const std::string& path, const ReportedSmoothOptions& options, const Control& control,
                              std::vector<std::string>& notes);

}  // namespace delref::program
