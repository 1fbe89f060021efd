// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing.hpp"

#include <map>
#include <utility>

#include <delref/algorithms/polyhedral_refinement.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>
#include <delref/mesh/verify_polyhedral.hpp>

namespace delref::property_3 {

std::string Meshed::not_excused() const {
  std::map<std::string, std::size_t> times;
  for (const auto& u : outcome.unmet)
    if (u.reason != Reason::small_input_angle) ++times[u.criterion + ": " + std::string(to_string(u.reason))];
  std::string text;
  for (const auto& [what, count] : times) text += what + ", " + std::to_string(count) + " times\n";
  return text;
}

Meshed meshed(const Plc& input, const PolyhedralOptions& options, std::size_t max_vertices) {
  Budget budget;
  budget.max_vertices = max_vertices;
  PolyhedralRefinement<> refinement(input, options);
  Meshed result;
  result.outcome = refinement.refine(Control(budget));
  result.conforms = refinement.conforms();
  result.mesh = refinement.mesh();
  return result;
}

std::string broken_promises(const Plc& input, const PolyhedralOptions& options, const Meshed& result) {
  PolyhedralCriteria criteria;
  criteria.radius_edge = options.radius_edge;
  criteria.max_volume = options.max_volume;
  criteria.cell_size = options.cell_size;
  criteria.size = options.size;
  criteria.input = options.input;
  criteria.complete = result.outcome.complete();
  criteria.listed = result.outcome.unmet;
  std::string text;
  for (const Finding& f : verify_polyhedral(input, result.mesh, criteria).findings)
    if (f.status == CheckStatus::failed)
      text += f.name + ": " + std::to_string(f.failures) + " of " + std::to_string(f.examined) + " are not: " +
              (f.places.empty() ? "" : f.places.front()) + "\n";
  return text;
}

double volume(const TetrahedralMesh& mesh) { return tetrahedral_quality(mesh).total_volume; }

bool same_bytes(const TetrahedralMesh& a, const TetrahedralMesh& b) {
  return a.points == b.points && a.point_markers == b.point_markers && a.carriers == b.carriers && a.provenance == b.provenance &&
         a.tetrahedra == b.tetrahedra && a.regions == b.regions && a.triangles == b.triangles && a.triangle_markers == b.triangle_markers &&
         a.triangle_facets == b.triangle_facets && a.edges == b.edges && a.edge_markers == b.edge_markers &&
         a.edge_segments == b.edge_segments;
}

}  // namespace delref::property_3
