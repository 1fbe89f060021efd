// SPDX-License-Identifier: GPL-3.0-or-later
#include "input_kind.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include <delref/domain/describe.hpp>
#include <delref/images/image_formats.hpp>
#include <delref/io/extension.hpp>

#include "exit_codes.hpp"

namespace delref::program {
namespace {

void check_bounds(const std::vector<double>& bounds) {
  if (bounds.empty())
    throw UsageError("--implicit needs --bounds X0 Y0 Z0 X1 Y1 Z1: two corners of the box in which the function is looked at");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = bounds[axis], high = bounds[axis + 3];
    if (std::isfinite(low) && std::isfinite(high) && low < high) continue;
    throw UsageError(fmt::format("--bounds: along {} the box goes from {} to {}; give the lower corner first, X0 Y0 Z0 X1 Y1 Z1",
                                 "xyz"[axis], describe(low), describe(high)));
  }
}

InputKind image_kind(const std::string& path, const ReportedSmoothOptions& o) {
  if (o.iso && o.labels) throw UsageError(fmt::format("{}: give either --iso V, for grey levels, or --labels, for a segmentation, not both", path));
  if (o.iso) return InputKind::grey_image;
  if (o.labels) return InputKind::label_image;
  throw UsageError(fmt::format("{} is an image: add --iso V to mesh where its grey levels are at least V, or --labels when its values are the "
                               "labels of regions",
                               path));
}

/// What an input of a kind is, after its name.
const char* words(InputKind kind) {
  switch (kind) {
    case InputKind::plane: return "lies in the plane (2D)";
    case InputKind::solid: return "is a solid bounded by facets";
    case InputKind::function: return "is given by --implicit";
    case InputKind::grey_image: return "is an image with grey levels (--iso)";
    case InputKind::label_image: return "is an image with labels (--labels)";
    case InputKind::point_set: return "is a set of points";
  }
  return "is something else";
}

/// For what options of some kinds are.
std::string words_for(InputKinds kinds) {
  if (kinds == only(InputKind::plane)) return "domains of the plane (2D)";
  if ((kinds & only(InputKind::plane)) != 0) return "domains whose boundary is given (.poly, .geojson, .off ...)";
  if (kinds == only(InputKind::solid)) return "solids bounded by facets";
  if (kinds == smooth_kinds) return "smooth domains: functions, images and sets of points";
  static constexpr std::array<const char*, 4> names{"functions (--implicit)", "images with grey levels (--iso)", "images with labels (--labels)",
                                                    "sets of points"};
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    if ((kinds & (4U << i)) != 0) text += (text.empty() ? "" : " and ") + std::string(names[i]);
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

}  // namespace

std::string name_of_input(const std::string& path, const ReportedSmoothOptions& options) {
  if (!path.empty()) return path;
  return options.expressions.size() > 1 ? "the domain of --implicit" : "the function of --implicit";
}

InputKind kind_of_input(const std::string& path, const ReportedSmoothOptions& o, const Control& control) {
  if (!o.expressions.empty()) {
    if (!path.empty())
      throw UsageError(fmt::format("there are two inputs: the file {} and --implicit; give one of them", path));
    check_bounds(o.bounds);
    return InputKind::function;
  }
  if (path.empty()) throw UsageError("IN is missing: name a file, or give a function by --implicit");
  if (is_image_file(path)) return image_kind(path, o);
  if (o.point_set || delref::detail::lower_extension(path) == ".xyz") return InputKind::point_set;
  return domain_dimension(path, control) == Dimension::plane ? InputKind::plane : InputKind::solid;
}

void refuse_options_of_other_kinds(const std::vector<GivenOption>& given, InputKind kind, const std::string& input, const char* command) {
  std::vector<std::string> names;
  InputKinds kinds = 0;
  for (const GivenOption& option : given) {
    if ((option.kinds & only(kind)) != 0) continue;
    if (names.empty()) kinds = option.kinds;
    if (option.kinds == kinds) names.push_back(option.name);
  }
  if (names.empty()) return;
  const bool is_planar = kind == InputKind::plane;
  const bool of_space = is_planar && (kinds & only(InputKind::solid)) != 0;
  const bool of_plane = !is_planar && kinds == only(InputKind::plane);
  throw UsageError(fmt::format("{} {} for {}, but {} {}\nRun `delref {} --help` to see what can be given.", joined(names),
                               names.size() == 1 ? "is" : "are", of_space ? "domains of space (3D)" : words_for(kinds), input,
                               of_plane ? "lies in space (3D)" : words(kind), command));
}

}  // namespace delref::program
