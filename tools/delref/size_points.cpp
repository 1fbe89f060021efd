// SPDX-License-Identifier: GPL-3.0-or-later
#include "size_points.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
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

Point2 point_of(const std::array<double, 3>& numbers) { return {numbers[0], numbers[1]}; }
Point3 point_of(const std::array<double, 4>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

/// The coordinates of a point and its size.
template <class Point>
using Numbers = std::array<double, std::is_same_v<Point, Point2> ? 3 : 4>;
template <class Point>
constexpr const char* format_of_line = std::is_same_v<Point, Point2> ? "`x y size`" : "`x y z size`";
template <class Point>
constexpr const char* count_of_numbers = std::is_same_v<Point, Point2> ? "three" : "four";

/// The numbers of a line, or why they are not what they should be.
template <class Point>
struct SizeLine {
  Numbers<Point> numbers{};
  std::string complaint;
};

template <class Point>
SizeLine<Point> parse_line(std::string_view line) {
  SizeLine<Point> result;
  for (double& value : result.numbers) {
    const std::string_view word = next_word(line);
    const auto parsed = number(word);
    if (!parsed) {
      result.complaint = word.empty() ? fmt::format("has fewer than {} numbers; write {}", count_of_numbers<Point>, format_of_line<Point>)
                                      : fmt::format("\"{}\" is not a number; write {}", word.substr(0, 40), format_of_line<Point>);
      return result;
    }
    value = *parsed;
  }
  const Point point = point_of(result.numbers);
  const double size = result.numbers.back();
  const auto is_placed = [](double coordinate) { return std::abs(coordinate) <= largest_coordinate; };
  if (const std::string_view more = next_word(line); !more.empty())
    result.complaint = fmt::format("\"{}\" follows the {} numbers {}; give each point a line", more.substr(0, 40),
                                   count_of_numbers<Point>, format_of_line<Point>);
  else if (!std::all_of(result.numbers.begin(), result.numbers.end() - 1, is_placed))
    result.complaint = fmt::format("the point {} is not within 1e150 of the origin", describe(point));
  else if (!(size > 0 && std::isfinite(size)))
    result.complaint = fmt::format("the size at {} is {}; it must be greater than 0", describe(point), describe(size));
  return result;
}

}  // namespace

template <class Point>
std::function<double(Point)> read_size_points(const std::string& path, double gradation, const Control& control) {
  const std::string text = read_file(path, control);
  std::vector<Point> points;
  std::vector<double> sizes;
  DefectList defects;
  std::string_view rest = text;
  for (std::size_t line_number = 1; !rest.empty(); ++line_number) {
    if (line_number % 4096 == 0) throw_if_stopped(control);
    const std::string_view full_line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(full_line.size() + 1, rest.size()));
    const std::string_view line = full_line.substr(0, full_line.find('#'));
    if (line.find_first_not_of(blanks) == std::string_view::npos) continue;
    const SizeLine<Point> parsed = parse_line<Point>(line);
    if (!parsed.complaint.empty()) {
      defects.add(fmt::format("{}, line {}: {}", path, line_number, parsed.complaint));
      continue;
    }
    points.push_back(point_of(parsed.numbers));
    sizes.push_back(parsed.numbers.back());
  }
  if (!defects.empty()) throw InvalidInput(defects.take());
  if (points.empty()) throw InvalidInput(fmt::format("{}: has no size points; write lines {}", path, format_of_line<Point>));
  // Shared, for the mesher copies its criteria, and a sizing of a million points is large.
  const auto sizing = std::make_shared<const PointSizing<Point>>(points, sizes, gradation);
  return [sizing](Point p) { return (*sizing)(p); };
}

template std::function<double(Point2)> read_size_points(const std::string&, double, const Control&);
template std::function<double(Point3)> read_size_points(const std::string&, double, const Control&);

}  // namespace delref::program
