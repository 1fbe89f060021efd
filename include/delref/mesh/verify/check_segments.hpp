// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checks of input vertices and segments: present, in place, and with their markers, carriers and provenance.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/core/carrier.hpp>
#include <delref/mesh/verify/chains.hpp>
#include <delref/mesh/verify/check_who_inserted.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref::verification {

inline void check_input_vertices(const Subject& s, const InputDomain& domain, const Chains& chains, Finding& finding) {
  for (Index v = 0; v < s.input_points.size(); ++v) {
    if (domain.canonical(v) != v || !domain.vertex_in_domain(v)) continue;
    ++finding.examined;
    if (chains.vertex_of_input(v) == none)
      finding.fail([&] { return fmt::format("input vertex {} at ({}, {}) is not in the mesh", s.number(v), s.input.points[v].x, s.input.points[v].y); });
  }
  for (const Index v : chains.repeated_vertices()) finding.fail([&] { return s.vertex(v) + " is there twice"; });
}

/// Pieces with an end that is missing are left to `check_input_vertices`.
inline void check_chains(const Subject& s, const InputDomain& domain, const Chains& chains, Finding& finding) {
  for (Index p = 0; p < domain.pieces().size(); ++p) {
    const Piece& piece = domain.pieces()[p];
    if (!domain.bounds_domain(piece)) continue;
    ++finding.examined;
    if (chains.ends_present(piece) && chains.chain(p).empty())
      finding.fail([&] {
        return fmt::format("no chain of edges from vertex {} to vertex {}, along {}", s.number(chains.vertex_of_input(piece.from)),
                           s.number(chains.vertex_of_input(piece.to)), s.segment(piece.segments.front()));
      });
  }
}

/// Distance from the segment, and order along it.
inline void check_positions(const Subject& s, const InputDomain& domain, const Chains& chains, Finding& finding) {
  double farthest = 0;
  for (Index p = 0; p < domain.pieces().size(); ++p) {
    s.breathe(p);
    const auto chain = chains.chain(p);
    if (chain.empty()) continue;
    const Piece& piece = domain.pieces()[p];
    const SegmentLine line = chains.line(piece);
    const double last = line.along(s.points[chain.back()]);
    double before = line.along(s.points[chain.front()]);
    const double direction = last > before ? 1 : -1;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double distance = line.distance(s.points[chain[i]]), here = line.along(s.points[chain[i]]);
      const double ulps = distance == 0 ? 0 : segment_tolerance_ulps * distance / line.tolerance();
      ++finding.examined;
      farthest = std::max(farthest, ulps);
      if (distance > line.tolerance())
        finding.fail([&] {
          return fmt::format("{} is {} off {}: {:.4g} ulp", s.vertex(chain[i]), s.scaling.original_length(distance),
                             s.segment(piece.segments.front()), ulps);
        });
      else if (!(direction * (here - before) > 0))
        finding.fail([&] { return fmt::format("{} is out of order on {}", s.vertex(chain[i]), s.segment(piece.segments.front())); });
      before = here;
    }
  }
  finding.note = fmt::format("farthest {:.3g} ulp of the segment's largest coordinate, allowed {}", farthest, segment_tolerance_ulps);
}

/// The list of subsegments is the union of the chains, each edge once, each with a segment that it lies on.
inline void check_subsegment_list(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains,
                                  Finding& finding) {
  const PlanarMesh& mesh = s.mesh;
  finding.examined = mesh.edges.size();
  std::vector<bool> listed(topology.edges().size(), false);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    const auto& [v, w] = mesh.edges[i];
    const Index e = topology.find(v, w);
    if (e == none) {
      finding.fail([&] { return s.edge(v, w) + " is listed as a subsegment and is no edge of a triangle"; });
      continue;
    }
    if (listed[e]) finding.fail([&] { return s.edge(v, w) + " is listed twice"; });
    listed[e] = true;
    const Index piece = chains.piece_of_edge(e);
    if (piece == none)
      finding.fail([&] { return s.edge(v, w) + " is listed as a subsegment and lies on no input segment"; });
    else if (!mesh.edge_segments.empty() && !s.is_named(domain.pieces()[piece].segments, mesh.edge_segments[i]))
      finding.fail([&] {
        return fmt::format("{} lies on segment {}, not on segment {} as listed", s.edge(v, w),
                           s.number(s.segment_name(domain.pieces()[piece].segments.front())), s.number(mesh.edge_segments[i]));
      });
  }
  for (Index e = 0; e < listed.size(); ++e)
    if (!listed[e] && chains.piece_of_edge(e) != none)
      finding.fail([&] { return s.edge(topology.edges()[e].a, topology.edges()[e].b) + " lies on an input segment and is not listed"; });
}

/// Whether one of the input segments of a piece has that marker.
inline bool has_marker(const Subject& s, const Piece& piece, int marker) {
  return std::ranges::any_of(piece.segments, [&](Index i) { return s.input.segment_marker(i) == marker; });
}

inline void check_edge_markers(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains,
                               Finding& finding) {
  for (std::size_t i = 0; i < s.mesh.edges.size(); ++i) {
    const auto& [v, w] = s.mesh.edges[i];
    const Index e = topology.find(v, w);
    if (e == none || chains.piece_of_edge(e) == none) continue;
    ++finding.examined;
    const Piece& piece = domain.pieces()[chains.piece_of_edge(e)];
    if (!has_marker(s, piece, s.mesh.edge_markers[i]))
      finding.fail([&] {
        return fmt::format("{} has marker {}, and {} has {}", s.edge(v, w), s.mesh.edge_markers[i], s.segment(piece.segments.front()),
                           s.input.segment_marker(piece.segments.front()));
      });
  }
}

/// For each canonical input vertex, the others at the same place.
inline std::vector<std::vector<Index>> repeated_input_vertices(const Subject& s, const InputDomain& domain) {
  std::vector<std::vector<Index>> repeated(s.input_points.size());
  for (Index v = 0; v < s.input_points.size(); ++v)
    if (domain.canonical(v) != v) repeated[domain.canonical(v)].push_back(v);
  return repeated;
}

/// Dimension 0 at input vertices, 1 inside chains with a segment of the chain, 2 everywhere else.
inline void check_carriers(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains,
                           Finding& finding) {
  const auto repeated = repeated_input_vertices(s, domain);
  for (Index v = 0; v < s.points.size(); ++v) {
    if (topology.star(v).empty()) continue;
    ++finding.examined;
    const Carrier carrier = s.mesh.carriers[v];
    const Index input = chains.input_of_vertex(v), piece = chains.piece_of_vertex(v);
    const auto wrong = [&](const std::string& truth) {
      finding.fail([&] {
        return fmt::format("{} says it lies on {} {}, but it {}", s.vertex(v),
                           carrier.dimension == 0 ? "input vertex" : carrier.dimension == 1 ? "segment" : "the inside, element",
                           carrier.index == Carrier::none ? "(none)" : std::to_string(s.number(carrier.index)), truth);
      });
    };
    if (input != none) {
      const auto names_it = [&](Index i) { return s.point_name(i) == carrier.index; };
      if (carrier.dimension != 0 || (!names_it(input) && std::ranges::none_of(repeated[input], names_it))) wrong(fmt::format("is input vertex {}", s.number(input)));
    } else if (piece != none) {
      const auto& segments = domain.pieces()[piece].segments;
      if (carrier.dimension != 1 || !s.is_named(segments, carrier.index))
        wrong(fmt::format("is part of the chain of segment {}", s.number(segments.front())));
    } else if (carrier.dimension != 2) {
      wrong("is part of no chain");
    }
  }
}

/// Input vertices keep their marker (of one of those at the same place), Steiner vertices have their segment's, or 0 inside.
inline void check_point_markers(const Subject& s, const InputDomain& domain, const MeshTopology& topology, const Chains& chains,
                                Finding& finding) {
  const auto repeated = repeated_input_vertices(s, domain);
  for (Index v = 0; v < s.points.size(); ++v) {
    if (topology.star(v).empty()) continue;
    ++finding.examined;
    const int marker = s.mesh.point_markers[v];
    const Index input = chains.input_of_vertex(v), piece = chains.piece_of_vertex(v);
    const auto has_it = [&](Index i) { return s.input.point_marker(i) == marker; };
    const bool right = input != none   ? has_it(input) || std::ranges::any_of(repeated[input], has_it)
                       : piece != none ? has_marker(s, domain.pieces()[piece], marker)
                                       : marker == 0;
    if (!right)
      finding.fail([&] {
        const int expected = input != none ? s.input.point_marker(input)
                             : piece != none ? s.input.segment_marker(domain.pieces()[piece].segments.front()) : 0;
        return fmt::format("{} has marker {} instead of {}", s.vertex(v), marker, expected);
      });
  }
}

inline void check_provenance(const Subject& s, const MeshTopology& topology, const Chains& chains, Finding& finding) {
  check_who_inserted(s, [&](Index v) { return !topology.star(v).empty(); }, [&](Index v) { return chains.input_of_vertex(v) != none; }, finding);
}

}  // namespace delref::verification
