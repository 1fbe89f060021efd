// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include <delref/algorithms/smooth_refinement.hpp>

#include "smooth_run.hpp"
#include "surface_facts.hpp"

namespace delref::program {
namespace {

using Refinement = SmoothRefinement<AnyOracle>;

ReportedSurface surface_of(const Refinement& refinement, const SmoothDomain& domain, const SmoothRun& run) {
  ReportedSurface surface;
  surface.domain = domain.words;
  const BoundingBox3 bounds = domain.oracle.bounds();
  surface.bounds = {bounds.low, bounds.high};
  const SmoothOptions& options = refinement.options();
  surface.sizes = {options.facet_size, options.facet_distance, options.smallest_facet};
  const ComponentCounts& components = refinement.components();
  surface.components_found = components.found;
  surface.components_seeded_again = components.seeded_again;
  surface.components_missed = components.missed;
  surface.loose_vertices = components.loose_vertices;
  surface.found_by = components.method;
  surface.found_exactly = components.is_exact;
  surface.stopped_by_floor = static_cast<std::size_t>(std::ranges::count_if(
      run.outcome.unmet, [](const auto& unmet) { return unmet.level == 0 && unmet.reason == Reason::size_floor; }));
  const std::vector<SurfacePatch> patches = refinement.patches();
  int greatest = -1;
  for (const SurfacePatch& p : patches) greatest = std::max(greatest, p.regions[0]);
  const std::vector<int> labels = region_labels(domain.oracle, static_cast<std::size_t>(greatest + 1));
  for (const SurfacePatch& p : patches) {
    ReportedPatch& patch = surface.patches.emplace_back();
    patch.marker = static_cast<int>(surface.patches.size());
    for (std::size_t side = 0; side < 2; ++side)
      if (p.regions[side] != outside) patch.regions[side] = labels[static_cast<std::size_t>(p.regions[side])];
  }
  add_surface_facts(surface, run.mesh);
  return surface;
}

}  // namespace

SmoothRun run_mesher(const SmoothDomain& domain, const SmoothRunOptions& options, const Control& control, Progress& progress) {
  progress.name_levels({"facets", "tetrahedra", ""});
  const SmoothOptions asked = options_for(domain, options);
  Refinement refinement(domain.oracle, asked, control);
  SmoothRun run;
  run.outcome = refinement.refine(control, progress);
  run.mesh = refinement.mesh();
  run.notes = refinement.notes();
  if (asked.facet_size != options.mesher.facet_size)
    run.notes.push_back(fmt::format("no size of facets was asked for: it is {:.4g}, {}", asked.facet_size, domain.why_usual));
  run.surface = surface_of(refinement, domain, run);
  return run;
}

}  // namespace delref::program
