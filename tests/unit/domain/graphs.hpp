// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small planar straight line graphs for tests, and how a test reads a refusal.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <delref/domain/invalid_input.hpp>
#include <delref/domain/pslg.hpp>

namespace graphs {

using delref::Point2;
using delref::Pslg;

inline Pslg graph(std::vector<Point2> points, std::vector<std::array<Pslg::Index, 2>> segments) {
  Pslg pslg;
  pslg.points = std::move(points);
  pslg.segments = std::move(segments);
  return pslg;
}

/// The square from (0, 0) with sides of `size`, as vertices and segments 0 to 3.
inline Pslg square(double size = 1) {
  return graph({{0, 0}, {size, 0}, {size, size}, {0, size}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

inline Pslg with_points(Pslg pslg, std::vector<Point2> more) {
  pslg.points.insert(pslg.points.end(), more.begin(), more.end());
  return pslg;
}

inline Pslg with_segments(Pslg pslg, std::vector<std::array<Pslg::Index, 2>> more) {
  pslg.segments.insert(pslg.segments.end(), more.begin(), more.end());
  return pslg;
}

/// What `action` says when it refuses its input; empty when it does not.
template <class Action>
std::string refusal(Action&& action) {
  try {
    action();
  } catch (const delref::InvalidInput& refused) {
    return refused.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// All notes in one string.
inline std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + '\n';
  return text;
}

}  // namespace graphs
