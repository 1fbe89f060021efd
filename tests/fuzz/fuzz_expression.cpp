// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever the text is, it is refused in words or has values: those of many points are those of each, and ranges hold them.
#include <array>
#include <cmath>
#include <string>

#include <delref/expression/expression.hpp>

#include "survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  delref_fuzz::survive([&] {
    const delref::Expression expression{std::string(delref_fuzz::text_of(data, size))};
    const delref::BoundingBox3 box{{-1, 0.25, -0.5}, {1.5, 0.75, 2}};
    const std::array<delref::Point3, 5> points{{{-1, 0.25, -0.5}, {1.5, 0.75, 2}, {0, 0.5, 0}, {0.3, 0.7, 1.1}, {1, 0.5, 1}}};
    std::array<double, 5> values;
    expression(points, values);
    const delref::ValueRange range = expression.range(box);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double alone = expression(points[i]);
      delref_fuzz::require(values[i] == alone || (std::isnan(values[i]) && std::isnan(alone)));
      delref_fuzz::require(std::isnan(alone) ? range.may_be_undefined : range.low <= alone && alone <= range.high);
    }
    if (const auto less = expression.narrowed(box))
      for (std::size_t i = 0; i < points.size(); ++i)
        delref_fuzz::require((*less)(points[i]) == values[i] || (std::isnan(values[i]) && std::isnan((*less)(points[i]))));
  });
  return 0;
}
