// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colours of pictures of meshes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include <fmt/format.h>

namespace delref {

/// A colour, each part from 0 to 1.
struct Colour {
  double red = 0, green = 0, blue = 0;

  /// As in `#1f77b4`.
  std::string hex() const {
    const auto byte = [](double part) { return static_cast<int>(std::lround(255 * std::clamp(part, 0.0, 1.0))); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(red), byte(green), byte(blue));
  }
  friend Colour mix(Colour a, Colour b, double t) {
    return {std::lerp(a.red, b.red, t), std::lerp(a.green, b.green, t), std::lerp(a.blue, b.blue, t)};
  }
};

/// The colour of a smallest angle in degrees, from 0 (rust) over 30 (sand) to 60 (deep blue). Red-green blind readers can tell the
/// ends apart, and the brightness tells them apart in print.
inline Colour angle_colour(double degrees) {
  constexpr std::array<Colour, 7> stops{Colour{0.62, 0.16, 0.09}, Colour{0.86, 0.40, 0.17}, Colour{0.96, 0.68, 0.34}, Colour{0.98, 0.90, 0.66},
                                        Colour{0.64, 0.84, 0.80}, Colour{0.27, 0.62, 0.72}, Colour{0.11, 0.37, 0.58}};
  const double place = std::clamp(degrees / 10, 0.0, static_cast<double>(stops.size() - 1));
  const auto below = std::min(stops.size() - 2, static_cast<std::size_t>(place));
  return mix(stops[below], stops[below + 1], place - static_cast<double>(below));
}

/// The colour of the i-th region: hues a golden section apart, so that neighbours in number are far apart in hue.
inline Colour region_colour(std::size_t i) {
  const double turn = 2 * std::numbers::pi * std::fmod(0.58 + 0.6180339887498949 * static_cast<double>(i), 1.0);
  const auto part = [&](double third) { return 0.5 + 0.5 * std::cos(turn - 2 * std::numbers::pi * third); };
  return mix(Colour{part(0), part(1.0 / 3), part(2.0 / 3)}, Colour{0.88, 0.87, 0.84}, i % 2 == 0 ? 0.58 : 0.42);
}

}  // namespace delref
