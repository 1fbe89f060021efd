// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verifies the finished mesh of a smooth domain: everything that a run promises is checked again, from the oracle and the mesh alone,
// with exact predicates where the question is exact, and without any of the mesher's code.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify/check_list.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/check_structure.hpp>
#include <delref/mesh/verify_3/topology.hpp>
#include <delref/mesh/verify_smooth/check_facets.hpp>
#include <delref/mesh/verify_smooth/check_surface.hpp>
#include <delref/mesh/verify_smooth/check_tetrahedra.hpp>
#include <delref/mesh/verify_smooth/check_triangles.hpp>
#include <delref/mesh/verify_smooth/check_vertices.hpp>
#include <delref/mesh/verify_smooth/check_volumes.hpp>
#include <delref/mesh/verify_smooth/excuses.hpp>
#include <delref/mesh/verify_smooth/expectations.hpp>
#include <delref/mesh/verify_smooth/subject.hpp>
#include <delref/mesh/verify_smooth/surface_balls.hpp>
#include <delref/mesh/verify_smooth/surface_graph.hpp>

namespace delref {

namespace verification_smooth {

/// Makes the checks in order and keeps what later ones need of earlier ones.
template <Oracle O>
class SmoothVerification {
 public:
  SmoothVerification(const O& oracle, const TetrahedralMesh& mesh, const SmoothOptions& options, const SmoothExpectations& expected,
                     const Control& control)
      : subject_(mesh, options, expected, control), questions_(oracle, subject_.scaling) {}

  VerifyReport run() && {
    if (structure() && triangles()) {
      surface();
      vertices();
      facets();
      if (has_tetrahedra()) tetrahedra();
    }
    list_.skip_rest(all_checks, "needs what failed above");
    std::ranges::sort(report_.findings, {},
                      [](const Finding& f) { return std::ranges::find(all_checks, f.name) - std::begin(all_checks); });
    return std::move(report_);
  }

 private:
  bool has_tetrahedra() const { return !subject_.mesh.tetrahedra.empty(); }

  bool structure() {
    const Subject& s = subject_;
    const bool is_usable = list_.check(all_checks[0], [&](Finding& f) {
      if (s.mesh.triangles.empty()) f.fail([] { return std::string("the mesh has no triangles"); });
      verification_3::check_arrays(s, f);
    });
    if (!is_usable || !list_.check(all_checks[1], [&](Finding& f) { check_places(s, f); })) return false;
    graph_.emplace(s);
    excuses_.emplace(s, report_);
    if (!has_tetrahedra()) {
      for (const std::size_t i : {2U, 3U, 9U, 15U, 20U, 21U}) list_.skip(all_checks[i], no_tetrahedra);
      return true;
    }
    if (!list_.check(all_checks[2], [&](Finding& f) { verification_3::check_orientation(s, f); })) return false;
    topology_.emplace(s.mesh, s.control);
    if (!list_.check(all_checks[3], [&](Finding& f) { verification_3::check_faces(s, *topology_, f); })) return false;
    list_.check(all_checks[9], [&](Finding& f) { verification_3::check_delaunay(s, *topology_, f); });
    regions_.resize(s.mesh.tetrahedra.size(), 0);
    for (std::size_t t = 0; t < s.mesh.regions.size(); ++t) regions_[t] = questions_.number(s.mesh.regions[t]);
    return true;
  }

  /// Finds the two regions of every triangle, of the tetrahedra or of the oracle.
  bool triangles() {
    const Subject& s = subject_;
    const bool is_right = list_.check(all_checks[4], [&](Finding& f) {
      if (has_tetrahedra()) check_interfaces(s, *topology_, questions_, regions_, sides_, f);
      else check_repetitions(s, f);
    });
    if (!is_right) return false;
    SurfaceBallFinder<O> ball_of(s, questions_);
    const bool are_balls = list_.check(all_checks[10], [&](Finding& f) { check_balls(s, ball_of, sides_, balls_, f); });
    excuses_->set_balls(balls_);
    list_.check_if(!s.mesh.triangle_markers.empty(), all_checks[5], "the mesh carries none",
                   [&](Finding& f) { check_markers(s, questions_, sides_, [&](std::size_t t) { return balls_[t].sides; }, f); });
    return are_balls || has_tetrahedra();
  }

  void surface() {
    const Subject& s = subject_;
    list_.check(all_checks[6], [&](Finding& f) { check_closed(s, *graph_, questions_, sides_, f); });
    list_.check_if(s.options.manifold, all_checks[7], "not asked for",
                   [&](Finding& f) { check_disks(s, *graph_, questions_, sides_, *excuses_, f); });
    report_.surfaces = surface_pieces(s, *graph_, questions_, sides_);
    list_.check(all_checks[8], [&](Finding& f) { check_expected_topology(s, *graph_, f); });
    list_.check_if(s.expected.complete || s.expected.strict, all_checks[16], "the run did not come to its end", [&](Finding& f) { check_volumes(s, questions_, sides_, balls_, report_.surfaces, f); });
    if constexpr (FindsComponents<O>)
      list_.check(all_checks[11], [&](Finding& f) {
        check_coverage<O>(s, *graph_, balls_, questions_.oracle().components(s.control), f);
      });
    else
      list_.skip(all_checks[11], "the domain does not find them");
  }

  void vertices() {
    const Subject& s = subject_;
    const std::vector<double> shortest = shortest_edges_at_vertices(s);
    list_.check(all_checks[12], [&](Finding& f) { check_vertices_on_surface(s, questions_, *graph_, shortest, *excuses_, f); });
    const char* absent = "the mesh carries none";
    list_.check_if(!s.mesh.carriers.empty(), all_checks[13], absent, [&](Finding& f) { check_carriers(s, *graph_, *excuses_, f); });
    list_.check_if(!s.mesh.provenance.empty(), all_checks[14], absent, [&](Finding& f) { check_provenance(s, f); });
  }

  void facets() {
    const Subject& s = subject_;
    list_.check(all_checks[17], [&](Finding& f) { check_facet_angles(s, *excuses_, report_, f); });
    list_.check_if(std::isfinite(s.options.facet_size) || s.options.facet_size_field, all_checks[18], "no bound",
                   [&](Finding& f) { check_facet_sizes(s, balls_, *excuses_, f); });
    list_.check_if(std::isfinite(s.options.facet_distance) || s.options.facet_distance_field, all_checks[19], "no bound",
                   [&](Finding& f) { check_facet_distances(s, balls_, *excuses_, f); });
  }

  void tetrahedra() {
    const Subject& s = subject_;
    list_.check(all_checks[15], [&](Finding& f) { check_labels(s, questions_, regions_, f); });
    list_.check(all_checks[20], [&](Finding& f) { check_radius_edge(s, *excuses_, report_, f); });
    const bool has_size = std::isfinite(s.options.cell_size) || s.options.cell_size_field || !s.options.region_cell_sizes.empty();
    list_.check_if(has_size, all_checks[21], "no bound", [&](Finding& f) { check_cell_sizes(s, regions_, *excuses_, f); });
  }

  static constexpr const char* no_tetrahedra = "the mesh has no tetrahedra";
  static constexpr const char* all_checks[] = {"the mesh has triangles, and indices and coordinates are valid",
                                               "no two vertices are at one place",
                                               "tetrahedra are positively oriented",
                                               "a triangle has at most one tetrahedron on each side",
                                               "the triangles are what lies between regions, once",
                                               "triangles have one marker for each pair of regions",
                                               "the surface is closed around every region",
                                               "the triangles at every vertex are a disk",
                                               "the surface has the topology that was expected",
                                               "tetrahedra are Delaunay",
                                               "triangles have empty balls with the centre on the surface",
                                               "every component of the surface is in the mesh",
                                               "the vertices of triangles are on the surface",
                                               "vertices say what they lie on",
                                               "vertices name who inserted them",
                                               "tetrahedra have the labels of the regions of their circumcentres",
                                               "regions have the volume that they have in the domain, roughly",
                                               "no facet angle is under the bound",
                                               "no surface ball is greater than the facet size",
                                               "no facet is further from the surface than its bound",
                                               "no radius-edge ratio is over the bound",
                                               "no circumradius is greater than the cell size"};

  Subject subject_;
  Questions<O> questions_;
  VerifyReport report_;
  verification::CheckList list_{report_};
  std::optional<SurfaceGraph> graph_;
  std::optional<Excuses> excuses_;
  std::optional<verification_3::MeshTopology> topology_;
  std::vector<int> regions_;    // per tetrahedron
  std::vector<Sides> sides_;    // per triangle, as are these
  std::vector<SurfaceBall> balls_;
};

}  // namespace verification_smooth

/// Checks the mesh of a smooth domain against the oracle and the promises of the run that made it.
///
/// `options` are those of the run with the defaults that it chose (`SmoothRefinement::options()`), `expected` what its outcome says. A
/// mesh without tetrahedra is one of the surface alone. The vectors of `mesh` that are empty are not checked. `surfaces` of the report has
/// the closed surfaces around each region, with their Euler characteristics.
///
/// Orientation and the Delaunay property of tetrahedra are exact. A surface ball is empty when no vertex is deeper in it than 1e-11 of
/// its squared radius; its centre is looked for on the whole dual edge, at a 16th of the circumradius, and the one nearest to the
/// triangle counts. Vertices are on the surface when the region changes within 16 times `surface_tolerance` of the shortest edge at
/// them. The label of a tetrahedron is no failure when the region changes as near to its circumcentre as that can be computed. Angles
/// 1e-6 degrees, sizes 1e-9 and `surface_tolerance` relative. The volume of the domain is counted on a lattice of 64 samples to its longest
/// side: it is there to find what has been left out.
///
/// Never throws for a bad mesh: that is what the report is for. Throws `Interrupted` when `control` says stop, and what the oracle and
/// the fields of the options throw. Asks the oracle some 200 times per triangle. O(n log n) for good meshes.
template <Oracle O>
VerifyReport verify_smooth(const O& oracle, const TetrahedralMesh& mesh, const SmoothOptions& options = {},
                           const SmoothExpectations& expected = {}, const Control& control = Control{}) {
  return verification_smooth::SmoothVerification<O>(oracle, mesh, options, expected, control).run();
}

}  // namespace delref
