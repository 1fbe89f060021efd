// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of the list of triangles: they are what lies between regions, and their markers tell which.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/topology.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>

namespace delref::verification_smooth {

using verification_3::MeshTopology;

/// No two vertices have the same coordinates.
inline void check_places(const Subject& s, Finding& finding) {
  finding.examined = s.points.size();
  std::vector<Index> order(s.points.size());
  for (Index v = 0; v < order.size(); ++v) order[v] = v;
  const auto key = [&](Index v) { return std::array{s.points[v].x, s.points[v].y, s.points[v].z}; };
  std::ranges::sort(order, {}, key);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (key(order[i - 1]) == key(order[i]))
      finding.fail([&] { return fmt::format("{} is where vertex {} is", s.vertex(order[i]), s.number(order[i - 1])); });
}

/// No two triangles have the same corners.
inline void check_repetitions(const Subject& s, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  std::vector<std::pair<std::array<Index, 3>, Index>> all;
  for (Index t = 0; t < s.mesh.triangles.size(); ++t) {
    all.push_back({s.mesh.triangles[t], t});
    std::ranges::sort(all.back().first);
  }
  std::ranges::sort(all);
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].first == all[i - 1].first) finding.fail([&] { return s.triangle(std::size_t{all[i].second}) + " is listed twice"; });
}

/// Whether the vertices of a triangle come in the order of their numbers, up to a rotation.
inline bool is_ascending(const std::array<Index, 3>& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

/// The triangles are the faces with different regions on their two sides, with the greater one behind them. Writes down the sides.
template <class Questions>
void check_interfaces(const Subject& s, const MeshTopology& topology, const Questions& questions, const std::vector<int>& regions,
                      std::vector<Sides>& sides, Finding& finding) {
  const auto region = [&](Index half_face) { return half_face == none ? outside : regions[half_face / 4]; };
  std::vector<bool> is_listed(topology.faces().size(), false);
  sides.assign(s.mesh.triangles.size(), {});
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    s.breathe(t);
    const Index f = topology.find(s.mesh.triangles[t]);
    if (f == none) {
      finding.fail([&] { return s.triangle(t) + " is no face of a tetrahedron"; });
      continue;
    }
    if (is_listed[f]) finding.fail([&] { return s.triangle(t) + " is listed twice"; });
    is_listed[f] = true;
    const MeshTopology::Face& face = topology.faces()[f];
    sides[t] = {region(face.negative), region(face.positive)};
    if (!is_ascending(s.mesh.triangles[t])) std::swap(sides[t].behind, sides[t].front);
    if (sides[t].behind == sides[t].front)
      finding.fail([&] { return s.triangle(t) + " has " + questions.words(sides[t].front) + " on both sides"; });
    else if (sides[t].behind < sides[t].front)
      finding.fail([&] { return s.triangle(t) + " is turned towards " + questions.words(sides[t].front); });
  }
  for (std::size_t f = 0; f < topology.faces().size(); ++f) {
    const MeshTopology::Face& face = topology.faces()[f];
    const int positive = region(face.positive), negative = region(face.negative);
    if (positive == negative) continue;
    ++finding.examined;
    if (!is_listed[f])
      finding.fail([&] {
        return fmt::format("{} is between {} and {} and is not listed", s.triangle(face.corners()), questions.words(positive),
                           questions.words(negative));
      });
  }
}

/// One marker, and one number of a patch, for each pair of regions. In a surface without tetrahedra, where rounding can tell the sides of
/// a triangle wrong, they may be `or_else(t)` instead; then it gets the sides of most triangles of its marker.
template <class Questions, class OrElse>
void check_markers(const Subject& s, const Questions& questions, std::vector<Sides>& sides, OrElse&& or_else, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  const auto name = [&](std::size_t t) {
    return std::pair(s.mesh.triangle_markers[t], s.mesh.triangle_facets.empty() ? Index{0} : s.mesh.triangle_facets[t]);
  };
  using Name = decltype(name(0));
  std::map<Name, std::map<Sides, std::size_t>> counts;
  for (std::size_t t = 0; t < sides.size(); ++t) counts[name(t)][sides[t]] += sides[t].behind != unknown_region;
  std::map<Name, Sides> sides_of;
  std::map<Sides, Name> name_of;
  for (const auto& [its_name, its_sides] : counts) {
    const Sides most = std::ranges::max_element(its_sides, {}, [](const auto& c) { return c.second; })->first;
    sides_of[its_name] = most;
    const auto [first, is_new] = name_of.try_emplace(most, its_name);
    if (!is_new)
      finding.fail([&] {
        return fmt::format("the triangles between {} and {} have the marker {} of patch {}, and the marker {} of patch {}",
                           questions.words(most.behind), questions.words(most.front), first->second.first, first->second.second,
                           its_name.first, its_name.second);
      });
  }
  for (std::size_t t = 0; t < sides.size(); ++t) {
    const Sides most = sides_of[name(t)];
    if (sides[t] == most) continue;
    const bool is_doubtful = s.mesh.tetrahedra.empty() && (sides[t].behind == unknown_region || or_else(t) == most);
    if (is_doubtful) {
      sides[t] = most;
      continue;
    }
    finding.fail([&] {
      return fmt::format("{} is between {} and {} and has the marker {} of those between {} and {}", s.triangle(t),
                         questions.words(sides[t].behind), questions.words(sides[t].front), name(t).first, questions.words(most.behind),
                         questions.words(most.front));
    });
    if (s.mesh.tetrahedra.empty()) sides[t] = most;
  }
}

}  // namespace delref::verification_smooth
