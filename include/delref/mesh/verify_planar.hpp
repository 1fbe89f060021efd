// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies a finished planar mesh: everything that a run promises is checked again, from the input and the mesh alone, with exact
// predicates and without any of the mesher's code. The domain is worked out anew by CGAL's constrained Delaunay triangulation
// of the input.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <delref/core/budget.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/verify/chains.hpp>
#include <delref/mesh/verify/check_criteria.hpp>
#include <delref/mesh/verify/check_delaunay.hpp>
#include <delref/mesh/verify/check_list.hpp>
#include <delref/mesh/verify/check_segments.hpp>
#include <delref/mesh/verify/check_structure.hpp>
#include <delref/mesh/verify/check_tiling.hpp>
#include <delref/mesh/verify/criteria.hpp>
#include <delref/mesh/verify/report.hpp>

namespace delref {

namespace verification {

/// Makes the checks in order and keeps what later ones need of earlier ones.
class PlanarVerification {
 public:
  PlanarVerification(const Pslg& input, const PlanarMesh& mesh, const PlanarCriteria& criteria, const Control& control)
      : subject_{input, mesh, criteria, control}, criteria_(criteria), shortfalls_(criteria, subject_.scaling, report_) {}

  VerifyReport run() && {
    const bool sound = structure() && place_in_input();
    if (!sound) list_.skip_rest(all_checks, "needs what failed above");
    return std::move(report_);
  }

 private:
  bool structure() {
    const Subject& s = subject_;
    if (!list_.check(all_checks[0], [&](Finding& f) { check_input(s, f); })) return false;
    if (!list_.check(all_checks[1], [&](Finding& f) { check_indices(s, f); })) return false;
    if (!list_.check(all_checks[2], [&](Finding& f) { check_orientation(s, f); })) return false;
    topology_.emplace(s.mesh);
    if (!list_.check(all_checks[3], [&](Finding& f) { check_edges(s, *topology_, f); })) return false;
    return list_.check(all_checks[4], [&](Finding& f) { check_stars(s, *topology_, f); });
  }

  bool place_in_input() {
    const Subject& s = subject_;
    domain_.emplace(s.input, s.input_points, s.scaling, s.control);
    const bool usable = list_.check(all_checks[5], [&](Finding& f) {
      f.examined = 1;
      for (const std::string& problem : domain_->problems()) f.fail([&] { return problem; });
    });
    if (!usable) return false;
    chains_.emplace(s, *domain_, *topology_);
    const bool vertices = list_.check(all_checks[6], [&](Finding& f) { check_input_vertices(s, *domain_, *chains_, f); });
    const bool segments = list_.check(all_checks[7], [&](Finding& f) { check_chains(s, *domain_, *chains_, f); });
    if (!vertices || !segments) return false;
    list_.check(all_checks[8], [&](Finding& f) { check_positions(s, *domain_, *chains_, f); });
    components_.emplace(s, *domain_, *topology_, *chains_);
    if (!list_.check(all_checks[9], [&](Finding& f) { check_tiling(s, *domain_, *topology_, *chains_, *components_, f); })) {
      labels();
      delaunay();
      return false;
    }
    list_.check_if(!s.mesh.regions.empty(), all_checks[10], "the mesh carries none",
                   [&](Finding& f) { check_regions(s, *domain_, *components_, f); });
    labels();
    delaunay();
    criteria();
    return true;
  }

  void labels() {
    const Subject& s = subject_;
    const char* absent = "the mesh carries none";
    list_.check_if(!s.mesh.edges.empty(), all_checks[11], absent,
                   [&](Finding& f) { check_subsegment_list(s, *domain_, *topology_, *chains_, f); });
    list_.check_if(!s.mesh.edge_markers.empty(), all_checks[12], absent,
                   [&](Finding& f) { check_edge_markers(s, *domain_, *topology_, *chains_, f); });
    list_.check_if(!s.mesh.carriers.empty(), all_checks[13], absent,
                   [&](Finding& f) { check_carriers(s, *domain_, *topology_, *chains_, f); });
    list_.check_if(!s.mesh.point_markers.empty(), all_checks[14], absent,
                   [&](Finding& f) { check_point_markers(s, *domain_, *topology_, *chains_, f); });
    list_.check_if(!s.mesh.provenance.empty(), all_checks[15], absent,
                   [&](Finding& f) { check_provenance(s, *topology_, *chains_, f); });
  }

  void delaunay() {
    const Subject& s = subject_;
    const char* not_asked = "promised only with encroachment by circles";
    list_.check(all_checks[16], [&](Finding& f) { check_constrained_delaunay(s, *topology_, *chains_, f); });
    const SmallAngles small_angles(s, *domain_, *chains_);
    list_.check_if(criteria_.circle, all_checks[17], not_asked,
                   [&](Finding& f) { check_conforming_delaunay(s, *topology_, *chains_, small_angles, shortfalls_, f); });
    list_.check_if(criteria_.circle, all_checks[18], not_asked,
                   [&](Finding& f) { check_encroachment(s, *topology_, *chains_, small_angles, shortfalls_, f); });
  }

  void criteria() {
    const Subject& s = subject_;
    const SmallAngles small_angles(s, *domain_, *chains_);
    list_.check(all_checks[19], [&](Finding& f) { check_angles(s, criteria_, small_angles, shortfalls_, report_, f); });
    list_.check(all_checks[20], [&](Finding& f) { check_areas(s, criteria_, *domain_, *components_, shortfalls_, f); });
    list_.check_if(std::isfinite(criteria_.max_edge), all_checks[21], "no bound", [&](Finding& f) { check_edge_lengths(s, criteria_, shortfalls_, f); });
    list_.check_if(static_cast<bool>(criteria_.size), all_checks[22], "no bound", [&](Finding& f) { check_sizes(s, criteria_, shortfalls_, f); });
  }

  static constexpr const char* all_checks[] = {
      "the input is usable", "the mesh has triangles, and indices and coordinates are valid", "triangles are counterclockwise",
      "an edge has at most one triangle on each side", "the triangles at a vertex are one ring, or fans", "the input describes a domain",
      "input vertices are in the mesh, once", "input segments are chains of edges", "the vertices of chains lie on their segments",
      "the triangles cover the domain, once", "triangles have the labels of their regions", "subsegments are listed, and nothing else",
      "subsegments have the markers of their segments", "vertices name the input element that they lie on",
      "vertices have their markers", "vertices name who inserted them", "edges are Delaunay, subsegments excepted",
      "subsegments are Delaunay too", "no subsegment is encroached", "no angle is below the bound", "no area is over its bound",
      "no edge is longer than the bound", "no triangle is larger than the sizing field says"};

  Subject subject_;
  const PlanarCriteria& criteria_;
  VerifyReport report_;
  CheckList list_{report_};
  Shortfalls<Point2> shortfalls_;
  std::optional<MeshTopology> topology_;
  std::optional<InputDomain> domain_;
  std::optional<Chains> chains_;
  std::optional<TriangleComponents> components_;
};

}  // namespace verification

/// Checks a mesh against its input and the promises of the run that made it.
///
/// `input` is what was meshed: after splitting at crossings and merging of near vertices, when that was done. It may have
/// duplicate vertices, segments of length zero and vertices inside segments. What lies wholly outside the domain need not be in the
/// mesh. The vectors of `mesh` that are empty are not checked. Tolerances: chain vertices 4 ulp of the largest coordinate of
/// their segment; total area 1e-9; angles 1e-6 degrees; sizes 1e-9 relative; encroachment 1e-12 in the cosine; all else is exact.
/// An angle below the bound is excused when one of the triangle's corners is within twice its longest edge of an input vertex
/// where two segments meet under 60 degrees with the domain between them, or when its shortest edge bridges two such segments.
///
/// Never throws for a bad mesh or a bad input: that is what the report is for. Throws `Interrupted` when `control` says stop. O(n log n).
inline VerifyReport verify_planar(const Pslg& input, const PlanarMesh& mesh, const PlanarCriteria& criteria = {},
                                  const Control& control = Control{}) {
  return verification::PlanarVerification(input, mesh, criteria, control).run();
}

}  // namespace delref
