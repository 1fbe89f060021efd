// SPDX-License-Identifier: GPL-3.0-or-later
#include "smooth_command_line.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "option_checks.hpp"

namespace delref::program {
namespace {

/// "7=0.5" as a label and a size, when it is one.
std::optional<std::pair<int, double>> label_and_size(const std::string& text) {
  const std::size_t sign = text.find('=');
  int label = 0;
  double size = 0;
  if (sign == std::string::npos || !CLI::detail::lexical_cast(text.substr(0, sign), label) ||
      !CLI::detail::lexical_cast(text.substr(sign + 1), size) || !(std::isfinite(size) && size > 0))
    return std::nullopt;
  return std::pair(label, size);
}
CLI::Validator region_size() {
  return CLI::Validator(
      [](std::string& text) {
        return label_and_size(text) ? std::string() : fmt::format("{} is not LABEL=SIZE, a whole number and a length greater than 0", text);
      },
      "");
}
CLI::Validator label_or_none() {
  return CLI::Validator(
      [](std::string& text) {
        int label = 0;
        return text == "none" || CLI::detail::lexical_cast(text, label) ? std::string() : fmt::format("{} is neither a label nor none", text);
      },
      "");
}

/// An option that takes a whole number.
CLI::Option* count_option(CLI::App& command, const char* name, std::size_t& to, int least, int most) {
  const auto is_right = [=](double x) { return x >= least && x <= most && std::floor(x) == x; };
  return command.add_option_function<double>(name, [&to](double n) { to = static_cast<std::size_t>(n); })
      ->check(number(fmt::format("a whole number from {} to {}", least, most), is_right));
}

}  // namespace

Criteria add_sources(CLI::App& command, ReportedSmoothOptions& s) {
  constexpr InputKinds function = only(InputKind::function), grey = only(InputKind::grey_image), labels = only(InputKind::label_image);
  constexpr InputKinds points = only(InputKind::point_set);
  const auto background = [&s](const std::string& text) { s.background_label = text == "none" ? std::nullopt : std::optional(std::stoi(text)); };
  return {{command.add_option("--implicit", s.expressions)->allow_extra_args(false), function},
          {command.add_option("--bounds", s.bounds)->type_size(6)->expected(1)->allow_extra_args(false), function},
          {command.add_option("--iso", s.iso)->check(finite()), grey},
          {command.add_option("--inside", s.inside)->check(one_of("above", "below")), grey},
          {command.add_flag("--closed", s.closed_at_border), grey},
          {command.add_flag("--labels", s.labels), labels},
          {command.add_option_function<std::string>("--background", background)->check(label_or_none()), labels},
          {command.add_option("--smooth-labels", s.label_smoothing)->check(between("a width in voxels", 0.3, 3)), labels},
          {command.add_flag("--point-set", s.point_set), points},
          {count_option(command, "--neighbours", s.neighbours, 6, 1000), points},
          {command.add_option("--outliers", s.outlier_distance)->check(positive("a multiple of the usual distance")), points},
          {count_option(command, "--smooth-points", s.point_smoothing, 0, 100), points},
          {command.add_option("--sampling", s.sampling)->check(positive("a length")), function}};
}

Criteria add_smooth_criteria(CLI::App& command, ReportedSmoothOptions& s) {
  const auto sizes = [&s](const std::vector<std::string>& texts) {
    s.region_cell_sizes.clear();
    for (const std::string& text : texts) s.region_cell_sizes.push_back(*label_and_size(text));
  };
  return {{command.add_option("--facet-angle", s.facet_angle_degrees)->check(angle()), smooth_kinds},
          {command.add_option("--facet-size", s.facet_size)->check(positive("a length")), smooth_kinds},
          {command.add_option("--facet-distance", s.facet_distance)->check(positive("a length")), smooth_kinds},
          {command.add_option_function<std::vector<std::string>>("--region-cell-size", sizes)->check(region_size())->allow_extra_args(false),
           smooth_kinds},
          {command.add_option("--smallest-facet", s.smallest_facet)->check(positive("a length")), smooth_kinds},
          {command.add_flag("--surface-only", s.surface_only), smooth_kinds}};
}

}  // namespace delref::program
