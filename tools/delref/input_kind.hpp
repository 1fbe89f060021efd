// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kinds of input, and which options have a meaning for which.
#pragma once

#include <string>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/io/domain_dimension.hpp>
#include <delref/io/report.hpp>

namespace delref::program {

/// Of which kind an input is. One bit each, so that the kinds for which an option has a meaning are a sum.
enum class InputKind : unsigned { plane = 1, solid = 2, function = 4, grey_image = 8, label_image = 16, point_set = 32 };
using InputKinds = unsigned;

constexpr InputKinds operator|(InputKind a, InputKind b) { return static_cast<InputKinds>(a) | static_cast<InputKinds>(b); }
constexpr InputKinds operator|(InputKinds a, InputKind b) { return a | static_cast<InputKinds>(b); }
constexpr InputKinds only(InputKind kind) { return static_cast<InputKinds>(kind); }

inline constexpr InputKinds images = InputKind::grey_image | InputKind::label_image;
inline constexpr InputKinds smooth_kinds = images | InputKind::function | InputKind::point_set;
inline constexpr InputKinds space_kinds = smooth_kinds | InputKind::solid;

inline bool is_smooth(InputKind kind) { return (smooth_kinds & only(kind)) != 0; }
inline Dimension dimension_of(InputKind kind) { return kind == InputKind::plane ? Dimension::plane : Dimension::space; }

/// An option that was given on the command line.
struct GivenOption {
  std::string name;
  InputKinds kinds = 0;
};

/// What messages call an input: its file, or what it is when it comes without one.
std::string name_of_input(const std::string& path, const ReportedSmoothOptions& options);

/// The kind of an input, of which a file gives its name and, when that leaves it open, its first lines. Throws `UsageError` in words when
/// the options do not say what is needed of the kind or say too much, `InvalidInput` when the file cannot be read, and `Interrupted`.
InputKind kind_of_input(const std::string& path, const ReportedSmoothOptions& options, const Control& control);

/// Throws `UsageError` that names the options which have no meaning for an input of this kind.
void refuse_options_of_other_kinds(const std::vector<GivenOption>& given, InputKind kind, const std::string& input, const char* command);

}  // namespace delref::program
