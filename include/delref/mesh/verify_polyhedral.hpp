// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a finished tetrahedral mesh: everything that a run promises is checked again, from the input and the mesh alone, with
// exact predicates and without any of the mesher's code.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify/check_list.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/chains.hpp>
#include <delref/mesh/verify_3/check_criteria.hpp>
#include <delref/mesh/verify_3/check_facets.hpp>
#include <delref/mesh/verify_3/check_labels.hpp>
#include <delref/mesh/verify_3/check_segments.hpp>
#include <delref/mesh/verify_3/check_structure.hpp>
#include <delref/mesh/verify_3/check_tiling.hpp>
#include <delref/mesh/verify_3/criteria.hpp>

namespace delref {

namespace verification_3 {

/// Makes the checks in order and keeps what later ones need of earlier ones.
class PolyhedralVerification {
 public:
  PolyhedralVerification(const Plc& input, const TetrahedralMesh& mesh, const PolyhedralCriteria& criteria,
                         const Control& control)
      : subject_{input, mesh, criteria, control}, shortfalls_(criteria, subject_.scaling, report_) {}

  VerifyReport run() && {
    if (structure()) {
      list_.check(all_checks[18], [&](Finding& f) { check_delaunay(subject_, *topology_, f); });
      if (segments_and_facets() && domain()) {
        labels();
        criteria();
      }
    }
    list_.skip_rest(all_checks, "needs what failed above");
    std::ranges::sort(report_.findings, {},
                      [](const Finding& f) { return std::ranges::find(all_checks, f.name) - std::begin(all_checks); });
    return std::move(report_);
  }

 private:
  bool structure() {
    const Subject& s = subject_;
    if (!list_.check(all_checks[0], [&](Finding& f) { check_input(s, f); })) return false;
    if (!list_.check(all_checks[1], [&](Finding& f) { check_indices(s, f); })) return false;
    if (!list_.check(all_checks[2], [&](Finding& f) { check_orientation(s, f); })) return false;
    topology_.emplace(s.mesh, s.control);
    return list_.check(all_checks[3], [&](Finding& f) { check_faces(s, *topology_, f); });
  }

  bool segments_and_facets() {
    const Subject& s = subject_;
    complex_.emplace(s);
    chains_.emplace(s, *complex_, *topology_);
    group_of_ = groups_of_triangles(s, *complex_, *chains_);
    present_.assign(complex_->groups().size(), false);
    for (const Index g : group_of_)
      if (g != none) present_[g] = true;
    const bool vertices = list_.check(all_checks[4], [&](Finding& f) { check_input_vertices(s, *complex_, *chains_, present_, f); });
    const bool segments = list_.check(all_checks[5], [&](Finding& f) { check_chains(s, *complex_, *chains_, present_, f); });
    list_.check(all_checks[6], [&](Finding& f) { check_positions(s, *complex_, *chains_, f); });
    const char* absent = "the mesh carries none";
    list_.check_if(!s.mesh.edges.empty(), all_checks[7], absent, [&](Finding& f) { check_edge_list(s, *chains_, f); });
    list_.check_if(!s.mesh.edge_markers.empty(), all_checks[8], absent,
                   [&](Finding& f) { check_edge_markers(s, *complex_, *chains_, f); });
    if (!list_.check(all_checks[9], [&](Finding& f) { check_planes(s, *complex_, group_of_, f); })) return false;
    list_.check_if(!s.mesh.triangle_markers.empty(), all_checks[11], absent,
                   [&](Finding& f) { check_triangle_markers(s, *complex_, group_of_, f); });
    const bool covered = vertices && segments &&
                         list_.check(all_checks[10], [&](Finding& f) { check_cover(s, *complex_, *chains_, group_of_, present_, f); });
    return covered;
  }

  bool domain() {
    const Subject& s = subject_;
    rooms_.emplace(s, *complex_, *chains_, group_of_, present_);
    const bool filled = list_.check(all_checks[12], [&](Finding& f) {
      for (const std::string& problem : rooms_->problems()) f.fail([&] { return problem; });
      room_of_.emplace(s, *topology_, *rooms_);
      check_tiling(s, *complex_, *topology_, *rooms_, *room_of_, f);
    });
    if (!filled) return false;
    list_.check(all_checks[13], [&](Finding& f) { check_volumes(s, *complex_, *rooms_, *room_of_, f); });
    list_.check_if(!s.mesh.regions.empty(), all_checks[14], "the mesh carries none",
                   [&](Finding& f) { check_regions(s, *rooms_, *room_of_, f); });
    list_.check(all_checks[23], [&](Finding& f) { check_isolated(s, *complex_, *topology_, *chains_, *rooms_, f); });
    return true;
  }

  void labels() {
    const Subject& s = subject_;
    elements_.emplace(s, *complex_, *chains_, group_of_);
    const char* absent = "the mesh carries none";
    list_.check_if(!s.mesh.carriers.empty(), all_checks[15], absent, [&](Finding& f) { check_carriers(s, *chains_, *elements_, f); });
    list_.check_if(!s.mesh.point_markers.empty(), all_checks[16], absent,
                   [&](Finding& f) { check_point_markers(s, *complex_, *chains_, *elements_, f); });
    list_.check_if(!s.mesh.provenance.empty(), all_checks[17], absent, [&](Finding& f) { check_provenance(s, *chains_, f); });
  }

  void criteria() {
    const Subject& s = subject_;
    SmallAngles small_angles(s, *complex_, *chains_, group_of_, *elements_);
    list_.check(all_checks[19], [&](Finding& f) { check_radius_edge(s, small_angles, shortfalls_, report_, f); });
    list_.check(all_checks[20], [&](Finding& f) { check_volume_bounds(s, *rooms_, *room_of_, shortfalls_, f); });
    list_.check_if(std::isfinite(s.criteria.cell_size), all_checks[21], "no bound",
                   [&](Finding& f) { check_cell_sizes(s, shortfalls_, f); });
    list_.check_if(static_cast<bool>(s.criteria.size), all_checks[22], "no bound", [&](Finding& f) { check_sizes(s, shortfalls_, f); });
  }

  static constexpr const char* all_checks[] = {"the input is usable",
                                               "the mesh has tetrahedra, and indices and coordinates are valid",
                                               "tetrahedra are positively oriented",
                                               "a triangle has at most one tetrahedron on each side",
                                               "input vertices are in the mesh, once",
                                               "input segments are chains of edges",
                                               "the vertices of chains lie on their segments",
                                               "edges on input segments are listed, and nothing else",
                                               "edges have the markers of their segments",
                                               "listed triangles lie on their facets",
                                               "the triangles cover the facets, once",
                                               "triangles have the markers of their facets",
                                               "the tetrahedra fill the domain, once",
                                               "rooms have the volume that their facets enclose",
                                               "tetrahedra have the labels of their regions",
                                               "vertices name the kind of input element that they lie on",
                                               "vertices have their markers",
                                               "vertices name who inserted them",
                                               "tetrahedra are Delaunay",
                                               "no radius-edge ratio is over the bound",
                                               "no volume is over its bound",
                                               "no circumradius is over the bound",
                                               "no circumradius is greater than the sizing field says",
                                               "isolated vertices and segments are in the mesh"};

  Subject subject_;
  VerifyReport report_;
  verification::CheckList list_{report_};
  Shortfalls shortfalls_;
  std::optional<MeshTopology> topology_;
  std::optional<InputComplex> complex_;
  std::optional<Chains> chains_;
  std::vector<Index> group_of_;
  std::vector<bool> present_;
  std::optional<Rooms> rooms_;
  std::optional<TetrahedronRooms> room_of_;
  std::optional<ElementsOfVertices> elements_;
};

}  // namespace verification_3

/// Checks a mesh against its input and the promises of the run that made it.
///
/// `input` is what was meshed, as read; `criteria.input` says how it was understood. It may have vertices at one place, segments
/// of length zero, facets that are repeated or without area, and vertices inside segments that other facets end at. Facets wholly
/// outside the domain need not be in the mesh. The vectors of `mesh` that are empty are not checked; where it lists no edges,
/// chains are looked for among the edges of its triangles and tetrahedra, and where it names no facets, triangles are told by
/// what borders them.
///
/// Tolerances: chain vertices 4 ulp of the largest coordinate of their segment; vertices on facets 16 ulp of the largest
/// coordinate of the facet, and three times what the facet's own vertices are off its plane; volumes 1e-9, and that distance
/// times the facets' area; sizes and ratios 1e-9 relative; angles 1e-6 degrees. Orientation, the Delaunay property and the order
/// of facets around segments are exact. A radius-edge ratio over the bound is excused when a corner of the tetrahedron is within
/// twice its longest edge of a segment or vertex where input elements meet under 90 degrees, or lies on one of two such elements
/// and is within that distance of a vertex on the other.
///
/// Never throws for a bad mesh or a bad input: that is what the report is for. Throws `Interrupted` when `control` says stop. O(n
/// log n), and one pass over the facets' triangles for each seed and each body that touches no other.
inline VerifyReport verify_polyhedral(const Plc& input, const TetrahedralMesh& mesh, const PolyhedralCriteria& criteria = {},
                                      const Control& control = Control{}) {
  return verification_3::PolyhedralVerification(input, mesh, criteria, control).run();
}

}  // namespace delref
