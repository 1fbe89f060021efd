// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check that the tetrahedra fill the domain, all of it and once. Where all are positively oriented and meet face to face,
// they do exactly when the faces with a tetrahedron on one side only are the boundary of the domain, each with its tetrahedron on
// the domain's side: a sum of tetrahedra is determined by its boundary. The volumes are compared besides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/check_facets.hpp>
#include <delref/mesh/verify_3/rooms.hpp>
#include <delref/mesh/verify_3/topology.hpp>

namespace delref::verification_3 {

/// The room that each tetrahedron is in, by flooding the mesh from the facets.
class TetrahedronRooms {
 public:
  TetrahedronRooms(const Subject& s, const MeshTopology& topology, const Rooms& rooms)
      : room_(s.mesh.tetrahedra.size(), none), on_facet_(topology.faces().size(), false) {
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t)
      if (const Index f = topology.find(rooms.triangles()[t]); f != none) on_facet_[f] = true;
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t)
      for (const bool front : {true, false}) reach(half_face(topology, rooms.triangles()[t], front), rooms.room(t, front));
    for (std::size_t step = 0; !stack_.empty(); ++step) {
      s.breathe(step);
      const Index t = stack_.back();
      stack_.pop_back();
      for (Index h = 4 * t; h < 4 * t + 4; ++h)
        if (!on_facet_[topology.face_of(h)]) reach(topology.twin(h), room_[t]);
    }
  }

  /// The half-face on the side of a triangle that sees it counterclockwise, or on the other; none when there is no tetrahedron.
  static Index half_face(const MeshTopology& topology, const std::array<Index, 3>& t, bool front) {
    const Index f = topology.find(t);
    if (f == none) return none;
    const bool turned = (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 1;  // an odd permutation of the sorted corners
    return front != turned ? topology.faces()[f].positive : topology.faces()[f].negative;
  }

  /// `none` for a tetrahedron that no facet leads to.
  Index operator[](std::size_t tetrahedron) const { return room_[tetrahedron]; }
  bool on_facet(Index face) const { return on_facet_[face]; }
  /// Tetrahedra that are reached from two rooms.
  const std::vector<Index>& torn() const { return torn_; }

 private:
  void reach(Index half_face, Index room) {
    if (half_face == none) return;
    const Index t = half_face / 4;
    if (room_[t] == none) {
      room_[t] = room;
      stack_.push_back(t);
    } else if (room_[t] != room) {
      torn_.push_back(t);
    }
  }

  std::vector<Index> room_, stack_, torn_;
  std::vector<bool> on_facet_;
};

inline void check_tiling(const Subject& s, const InputComplex& complex, const MeshTopology& topology, const Rooms& rooms,
                         const TetrahedronRooms& room_of, Finding& finding) {
  finding.examined = s.mesh.tetrahedra.size();
  const auto facet = [&](std::size_t t) { return s.facet(complex.groups()[rooms.group_of(t)].facets.front()); };
  std::set<Index> missing;
  for (std::size_t t = 0; t < rooms.triangles().size(); ++t)
    for (const bool front : {true, false}) {
      const bool inside = rooms.rooms()[rooms.room(t, front)].inside;
      if (t >= s.mesh.triangles.size()) {
        if (inside && missing.insert(rooms.group_of(t)).second)
          finding.fail([&] { return facet(t) + " lies in the domain or bounds it, and no triangle on it is listed"; });
      } else if (inside != (TetrahedronRooms::half_face(topology, rooms.triangles()[t], front) != none)) {
        finding.fail([&] {
          return s.triangle(rooms.triangles()[t]) + " on " + facet(t) +
                 (inside ? " has no tetrahedron on its inner side" : " has a tetrahedron outside the domain");
        });
      }
    }
  for (Index f = 0; f < topology.faces().size(); ++f) {
    const MeshTopology::Face& face = topology.faces()[f];
    if (face.boundary() && !room_of.on_facet(f))
      finding.fail(
          [&] { return s.triangle(face.corners()) + " has a tetrahedron on one side only and is on no facet: the mesh leaks"; });
  }
  for (const Index t : room_of.torn()) finding.fail([&] { return s.tetrahedron(t) + " is in two rooms of the domain at once"; });
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t)
    if (room_of[t] == none) finding.fail([&] { return s.tetrahedron(t) + " is cut off from every facet"; });
}

/// The volume that each room has by the input's facets: those with one simple polygon count by their input vertices alone, others
/// by the triangles on them. `allowed` is what facets whose vertices are not coplanar leave open.
struct RoomVolumes {
  std::vector<double> expected, allowed;
  RoomVolumes(const Subject& s, const InputComplex& complex, const Rooms& rooms, Point3 centre) {
    struct Uniform {
      Index front = none, back = none;
      bool mixed = false;
    };
    const auto six_volumes = [&](Point3 a, Point3 b, Point3 c) { return dot(a - centre, cross(b - centre, c - centre)); };
    const auto front_is_normal = [&](std::size_t t) {
      return dot(twice_area(s, rooms.triangles()[t]), complex.groups()[rooms.group_of(t)].normal) > 0;
    };
    std::vector<Uniform> uniform(complex.groups().size());
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
      Uniform& u = uniform[rooms.group_of(t)];
      const bool ahead = front_is_normal(t);
      const Index front = rooms.room(t, ahead), back = rooms.room(t, !ahead);
      if (u.front == none) u = {front, back};
      u.mixed |= u.front != front || u.back != back;
    }
    std::vector<PreciseSum> sums(rooms.rooms().size());
    allowed.assign(sums.size(), 0);
    const auto give = [&](Index front, Index back, double volume, double slack) {
      sums[front] += -volume / 6, sums[back] += volume / 6;
      allowed[front] += slack, allowed[back] += slack;
    };
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
      const Index g = rooms.group_of(t);
      if (complex.groups()[g].simple && !uniform[g].mixed) continue;
      const auto& [a, b, c] = rooms.triangles()[t];
      const double area = 0.5 * std::sqrt(squared_length(twice_area(s, rooms.triangles()[t])));
      give(rooms.room(t, true), rooms.room(t, false), six_volumes(s.points[a], s.points[b], s.points[c]),
           area * complex.groups()[g].tolerance);
    }
    for (Index g = 0; g < uniform.size(); ++g) {
      const Group& group = complex.groups()[g];
      if (!group.simple || uniform[g].mixed || uniform[g].front == none) continue;
      for (const Index f : group.facets) {
        const auto& polygon = s.input.facets[f].polygons.front();
        double volume = 0;
        for (std::size_t i = 2; i < polygon.size(); ++i)
          volume += six_volumes(s.input_points[polygon[0]], s.input_points[polygon[i - 1]], s.input_points[polygon[i]]);
        const double area = 0.5 * std::sqrt(squared_length(complex.facets()[f].twice_area));
        give(uniform[g].front, uniform[g].back, group.agrees(complex.facets()[f]) ? volume : -volume, area * group.tolerance);
      }
    }
    for (const PreciseSum& sum : sums) expected.push_back(sum.value());
  }
};

/// The volume of each room, to 1e-9 of it and what facets that are not plane leave open.
inline void check_volumes(const Subject& s, const InputComplex& complex, const Rooms& rooms, const TetrahedronRooms& room_of,
                          Finding& finding) {
  std::vector<PreciseSum> filled(rooms.rooms().size());
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size(); ++t) filled[room_of[t]] += s.shape(t).volume();
  const RoomVolumes volumes(s, complex, rooms, s.shape(0).barycentre());
  double worst = 0;
  for (std::size_t r = 0; r < filled.size(); ++r) {
    if (!rooms.rooms()[r].inside) continue;
    ++finding.examined;
    const double expected = volumes.expected[r], difference = std::abs(filled[r].value() - expected);
    worst = std::max(worst, difference / expected);
    if (!(difference <= 1e-9 * expected + volumes.allowed[r]))
      finding.fail([&] {
        return fmt::format("the tetrahedra of a room fill a volume of {}, its facets enclose {}",
                           s.scaling.original_volume(filled[r].value()), s.scaling.original_volume(expected));
      });
  }
  finding.note = fmt::format("off by {:.2g} of the volume at most", worst);
}

/// The tetrahedra of a room have one label, that of a region whose seed lies there.
inline void check_regions(const Subject& s, const Rooms& rooms, const TetrahedronRooms& room_of, Finding& finding) {
  finding.examined = s.mesh.regions.size();
  std::map<Index, int> first;
  for (std::size_t t = 0; t < s.mesh.regions.size(); ++t) {
    const auto& regions = rooms.rooms()[room_of[t]].regions;
    const int label = s.mesh.regions[t], common = first.try_emplace(room_of[t], label).first->second;
    const auto its = [&](Index r) { return s.input.regions[r].label; };
    if (!regions.empty() && std::ranges::count(regions, label, its) == 0)
      finding.fail([&] { return fmt::format("{} has label {} instead of {}", s.tetrahedron(t), label, its(regions[0])); });
    else if (label != common)
      finding.fail(
          [&] { return fmt::format("{} has label {}, others in the same room have {}", s.tetrahedron(t), label, common); });
  }
}

/// Isolated vertices and segments on no facet, where they are in the domain.
inline void check_isolated(const Subject& s, const InputComplex& complex, const MeshTopology& topology, const Chains& chains,
                           const Rooms& rooms, Finding& finding) {
  const auto in_domain = [&](Point3 p) {
    const Index room = rooms.room_at(p);
    return room != none && rooms.rooms()[room].inside;
  };
  std::vector<EdgeEntry> free_edges;
  std::vector<bool> at_free_edge(s.points.size(), false);
  for (Index i = 0; i < complex.sides().size(); ++i) {
    const Side& side = complex.sides()[i];
    if (!side.facets.empty() || !in_domain(midpoint(s.input_points[side.a], s.input_points[side.b]))) continue;
    ++finding.examined;
    const auto chain = chains.chain(i);
    if (chain.empty()) finding.fail([&] { return "no chain of listed edges along " + s.segment(side.a, side.b); });
    for (std::size_t k = 1; k < chain.size(); ++k) {
      free_edges.push_back({std::min(chain[k - 1], chain[k]), std::max(chain[k - 1], chain[k]), 0});
      at_free_edge[chain[k - 1]] = at_free_edge[chain[k]] = true;
    }
  }
  std::vector<bool> in_facet(s.input_points.size(), false);
  for (const auto& [vertex, group] : complex.points_in_facets()) in_facet[vertex] = true;
  for (Index v = 0; v < s.input_points.size(); ++v) {
    if (complex.canonical(v) != v || in_facet[v] || complex.on_side(v) || !in_domain(s.input_points[v])) continue;
    ++finding.examined;
    const Index vertex = chains.vertex_of_input(v);
    if (vertex == none || !topology.used(vertex))
      finding.fail([&] { return s.input_vertex(v) + " is no vertex of a tetrahedron"; });
  }
  std::ranges::sort(free_edges);
  std::vector<bool> found(free_edges.size(), false);
  for (std::size_t t = 0; t < s.mesh.tetrahedra.size() && !free_edges.empty(); ++t)
    for (const auto& [i, j] : TetrahedronMeasures::edge_corners) {
      const Index v = s.mesh.tetrahedra[t][i], w = s.mesh.tetrahedra[t][j];
      if (!at_free_edge[v] || !at_free_edge[w]) continue;
      for (const EdgeEntry& e : entries_of(free_edges, v, w)) found[static_cast<std::size_t>(&e - free_edges.data())] = true;
    }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!found[i])
      finding.fail(
          [&] { return s.edge(free_edges[i].a, free_edges[i].b) + " lies on a segment and is no edge of a tetrahedron"; });
}

}  // namespace delref::verification_3
