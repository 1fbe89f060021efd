// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether an image and an iso value bound a domain, and in which words they are refused otherwise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// How a grey-level image is read.
struct GreyLevelOptions {
  /// What is at most the iso value is inside, in place of what is at least it.
  bool inside_is_below = false;
  /// Where what is inside comes to the border of the image (the box through the centres of its outermost voxels), the border closes it.
  /// Off, such an image is refused.
  bool close_at_border = false;
};

namespace detail {

/// What a pass over all voxels of a grey-level image finds out.
struct GreyLevelSurvey {
  double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();
  std::size_t inside = 0, not_finite = 0;
  std::array<int, 3> first_not_finite{};
  /// Voxels inside at the borders x = first, x = last, y = first, ...
  std::array<std::size_t, 6> at_border{};
};

template <class Value>
GreyLevelSurvey survey_grey_levels(const Image<Value>& image, double iso, bool below, const Control& control) {
  GreyLevelSurvey out;
  const auto [nx, ny, nz] = image.grid.size;
  const Value* v = image.values.data();
  for (int z = 0; z != nz; ++z) {
    throw_if_stopped(control);
    for (int y = 0; y != ny; ++y) {
      for (int x = 0; x != nx; ++x) {
        const auto value = static_cast<double>(*v++);
        if (!std::isfinite(value)) {
          if (out.not_finite++ == 0) out.first_not_finite = {x, y, z};
          continue;
        }
        out.least = std::min(out.least, value), out.greatest = std::max(out.greatest, value);
        if (!(below ? value <= iso : value >= iso)) continue;
        ++out.inside;
        out.at_border[0] += x == 0, out.at_border[1] += x == nx - 1;
        out.at_border[2] += y == 0, out.at_border[3] += y == ny - 1;
        out.at_border[4] += z == 0, out.at_border[5] += z == nz - 1;
      }
    }
  }
  return out;
}

inline std::string border_words(const GreyLevelSurvey& survey) {
  static constexpr std::array<const char*, 6> names{"x = first", "x = last", "y = first", "y = last", "z = first", "z = last"};
  std::string text;
  for (std::size_t i = 0; i != 6; ++i) {
    if (survey.at_border[i] == 0) continue;
    text += (text.empty() ? "" : "; ") + count_of(survey.at_border[i], "voxel", "voxels") + " at the border " + names[i];
  }
  return text;
}

/// Requires a checked image. Throws `InvalidInput` when the level set is not a closed surface, or there is none.
template <class Value>
void check_grey_levels(const Image<Value>& image, double iso, const GreyLevelOptions& options, const Control& control) {
  for (std::size_t i = 0; i != 3; ++i) {
    if (image.grid.size[i] < 2) {
      throw InvalidInput(std::string("the image is one voxel thick along ") + "xyz"[i] +
                         "; a level set needs at least two voxels along each axis to interpolate between");
    }
  }
  if (!std::isfinite(iso)) throw InvalidInput("the iso value is " + describe(iso) + "; it must be a number");
  const GreyLevelSurvey survey = survey_grey_levels(image, iso, options.inside_is_below, control);
  if (survey.not_finite > 0) {
    const auto [x, y, z] = survey.first_not_finite;
    throw InvalidInput(count_of(survey.not_finite, "voxel has a value that is", "voxels have values that are") +
                       " not a finite number, the first at index (" + std::to_string(x) + ", " + std::to_string(y) + ", " +
                       std::to_string(z) + "); replace them, by a value that is outside for example");
  }
  const std::string range = survey.least == survey.greatest
                                ? "all voxels have the value " + describe(survey.least)
                                : "the values go from " + describe(survey.least) + " to " + describe(survey.greatest);
  if (survey.inside == 0 || survey.inside == image.values.size()) {
    throw InvalidInput(std::string("there is no surface at the iso value ") + describe(iso) + ": " +
                       (survey.inside == 0 ? "no voxel is inside" : "every voxel is inside") + "; " + range);
  }
  if (options.close_at_border) return;
  if (const std::string borders = border_words(survey); !borders.empty()) {
    throw InvalidInput("the level set " + describe(iso) + " leaves the image: " + borders +
                       (options.inside_is_below ? " are not above" : " are not below") +
                       " the iso value; close it there (close_at_border), choose another iso value, or turn inside and outside round");
  }
}

}  // namespace detail
}  // namespace delref
