// SPDX-License-Identifier: GPL-3.0-or-later
#include "size_points.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include <delref/criteria/point_sizing.hpp>
#include <delref/domain/describe.hpp>
#include <delref/io/file.hpp>

namespace delref::program {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr double largest_coordinate = 1e150;

/// The next word of a line, taken off its front; empty at the end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

std::optional<double> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// The three numbers of a line, or why they are not what they should be.
struct SizeLine {
  std::array<double, 3> numbers{};
  std::string complaint;
};

SizeLine parse_line(std::string_view line) {
  SizeLine result;
  for (double& value : result.numbers) {
    const std::string_view word = next_word(line);
    const auto parsed = number(word);
    if (!parsed) {
      result.complaint = word.empty() ? "has fewer than three numbers; write `x y size`"
                                      : fmt::format("\"{}\" is not a number; write `x y size`", word.substr(0, 40));
      return result;
    }
    value = *parsed;
  }
  const auto [x, y, size] = result.numbers;
  if (const std::string_view more = next_word(line); !more.empty())
    result.complaint = fmt::format("\"{}\" follows the three numbers `x y size`; give each point a line", more.substr(0, 40));
  else if (!(std::abs(x) <= largest_coordinate && std::abs(y) <= largest_coordinate))
    result.complaint = fmt::format("the point {} is not within 1e150 of the origin", describe(Point2{x, y}));
  else if (!(size > 0 && std::isfinite(size)))
    result.complaint = fmt::format("the size at {} is {}; it must be greater than 0", describe(Point2{x, y}), describe(size));
  return result;
}

}  // namespace

std::function<double(Point2)> read_size_points(const std::string& path, double gradation, const Control& control) {
  const std::string text = read_file(path, control);
  std::vector<Point2> points;
  std::vector<double> sizes;
  DefectList defects;
  std::string_view rest = text;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    if (line_number % 4096 == 0) throw_if_stopped(control);
    const std::string_view full_line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(full_line.size() + 1, rest.size()));
    const std::string_view line = full_line.substr(0, full_line.find('#'));
    if (line.find_first_not_of(blanks) == std::string_view::npos) continue;
    const SizeLine parsed = parse_line(line);
    if (!parsed.complaint.empty()) {
      defects.add(fmt::format("{}, line {}: {}", path, line_number, parsed.complaint));
      continue;
    }
    points.push_back({parsed.numbers[0], parsed.numbers[1]});
    sizes.push_back(parsed.numbers[2]);
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
  if (points.empty()) throw InvalidInput(fmt::format("{}: has no size points; write lines `x y size`", path));
  // Shared, for the mesher copies its criteria, and a sizing of a million points is large.
  const auto sizing = std::make_shared<const PointSizing2>(points, sizes, gradation);
  return [sizing](Point2 p) { return (*sizing)(p); };
}

}  // namespace delref::program
