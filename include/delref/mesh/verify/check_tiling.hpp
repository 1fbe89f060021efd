// SPDX-License-Identifier: GPL-3.0-or-later
//
// The check that the triangles cover the domain, all of it and once. Where all triangles are counterclockwise and meet edge to
// edge, they do exactly when the edges with a triangle on one side only are the boundary of the domain, each with its triangle
// on the domain's side: a sum of triangles in the plane is determined by its boundary. The areas are compared besides.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <fmt/format.h>

#include <delref/mesh/twofold.hpp>
#include <delref/mesh/verify/chains.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::verification {

/// The component of the domain that each triangle is in, by flooding the mesh from the chains.
class TriangleComponents {
 public:
  TriangleComponents(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains)
      : component_(s.mesh.triangles.size(), none) {
    for (Index p = 0; p < domain.pieces().size(); ++p) {
      const Piece& piece = domain.pieces()[p];
      const auto chain = chains.chain(p);
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const MeshTopology::Edge& e = topology.edges()[topology.find(chain[i - 1], chain[i])];
        reach(e.leaving(chain[i - 1]), piece.left);
        reach(e.leaving(chain[i]), piece.right);
      }
    }
    for (std::size_t step = 0; !stack_.empty(); ++step) {
      s.breathe(step);
      const Index t = stack_.back();
      stack_.pop_back();
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (chains.piece_of_edge(topology.edge_of(h)) == none) reach(topology.twin(h), component_[t]);
    }
  }

  /// `none` for a triangle that no chain leads to.
  Index operator[](std::size_t triangle) const { return component_[triangle]; }
  /// Triangles that are reached from two components.
  const std::vector<Index>& torn() const { return torn_; }

 private:
  void reach(Index half_edge, Index component) {
    if (half_edge == none) return;
    const Index t = half_edge / 3;
    if (component_[t] == none) {
      component_[t] = component;
      stack_.push_back(t);
    } else if (component_[t] != component) {
      torn_.push_back(t);
    }
  }

  std::vector<Index> component_, stack_, torn_;
};

/// The area between a chain and the straight piece that it stands for: positive when the chain bulges to the right.
inline double bulge(const Subject& s, std::span<const Index> chain) {
  PreciseSum sum;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i)
    sum += 0.5 * precise_cross(s.points[chain[0]], s.points[chain[i]], s.points[chain[i + 1]]);
  return sum.value();
}

/// Requires the chains of all pieces.
inline void check_tiling(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains,
                         const TriangleComponents& components, Finding& finding) {
  finding.examined = s.mesh.triangles.size();
  PreciseSum expected, covered;
  expected += domain.area();
  for (Index p = 0; p < domain.pieces().size(); ++p) {
    const Piece& piece = domain.pieces()[p];
    const auto chain = chains.chain(p);
    const bool left = domain.inside(piece.left), right = domain.inside(piece.right);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const MeshTopology::Edge& e = topology.edges()[topology.find(chain[i - 1], chain[i])];
      if ((e.leaving(chain[i - 1]) != none) != left || (e.leaving(chain[i]) != none) != right)
        finding.fail([&] {
          return s.edge(chain[i - 1], chain[i]) + (left && right ? " has a triangle on one side only, inside the domain"
                                                                 : " has its triangles on the wrong side of the boundary");
        });
    }
    if (left != right) expected += left ? bulge(s, chain) : -bulge(s, chain);
  }
  for (Index i = 0; i < topology.edges().size(); ++i) {
    const MeshTopology::Edge& e = topology.edges()[i];
    if (e.boundary() && chains.piece_of_edge(i) == none)
      finding.fail([&] { return s.edge(e.a, e.b) + " has a triangle on one side only and lies on no segment"; });
  }
  for (const Index t : components.torn()) finding.fail([&] { return s.triangle(t) + " is in two components of the domain at once"; });
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) covered += s.shape(t).area();
  const double difference = covered.value() - expected.value();
  finding.note = fmt::format("area differs by {:.2g} of the domain's", std::abs(difference) / domain.area());
  if (!(std::abs(difference) <= 1e-9 * domain.area()) && finding.failures == 0)
    finding.fail([&] {
      return fmt::format("the triangles cover an area of {}, the domain has {}", s.scaling.original_area(covered.value()),
                         s.scaling.original_area(expected.value()));
    });
}

/// A triangle has the label of a region whose seed lies in its component, or 0 where there is none.
inline void check_regions(const Subject& s, const InputDomain& domain, const TriangleComponents& components, Finding& finding) {
  finding.examined = s.mesh.regions.size();
  for (std::size_t t = 0; t < s.mesh.regions.size(); ++t) {
    const auto& regions = domain.components()[components[t]].regions;
    const auto label = [&](Index r) { return s.input.regions[r].label; };
    const bool right = regions.empty() ? s.mesh.regions[t] == 0 : std::ranges::count(regions, s.mesh.regions[t], label) != 0;
    if (!right)
      finding.fail([&] {
        return fmt::format("{} has label {} instead of {}", s.triangle(t), s.mesh.regions[t], regions.empty() ? 0 : label(regions[0]));
      });
  }
}

}  // namespace delref::verification
