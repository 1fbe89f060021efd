// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/algorithms/check_smooth_options.hpp>
#include <delref/mesh/verify_smooth.hpp>

#include "smooth_run.hpp"

namespace delref::program {
namespace {

/// "facets of at most 0.1, at most 0.01 from the surface": what `settled` has and `asked` has not.
std::string chosen_text(const SmoothOptions& asked, const SmoothOptions& settled) {
  std::string text;
  if (std::isfinite(settled.facet_size) && !std::isfinite(asked.facet_size)) text += fmt::format("facets of at most {:.4g}", settled.facet_size);
  if (std::isfinite(settled.facet_distance) && !std::isfinite(asked.facet_distance))
    text += fmt::format("{}at most {:.4g} from the surface", text.empty() ? "facets " : ", ", settled.facet_distance);
  return text;
}

}  // namespace

std::string settle_sizes(SmoothPromise& promise, const std::optional<ReportedFacetSizes>& of_report, const SmoothDomain& domain,
                         const Control& control) {
  SmoothOptions& options = promise.options.mesher;
  const SmoothOptions asked = options;
  options = options_for(domain, promise.options);
  if (of_report) {
    options.facet_size = of_report->facet_size;
    options.facet_distance = of_report->facet_distance;
    options.smallest_facet = of_report->smallest_facet;
    check_smooth_options(options);
  } else {
    check_smooth_options(options);
    std::vector<std::string> ignored;
    options = with_default_sizes(std::move(options), domain.oracle.surface_box(control), ignored);
  }
  const std::string text = chosen_text(asked, options);
  if (text.empty()) return text;
  return text + (of_report ? ", as the run chose them" : ", as `delref mesh` chooses when no size is given");
}

VerifyReport run_verification(const SmoothDomain& domain, const TetrahedralMesh& mesh, const SmoothPromise& promise, const ReportedOptions&,
                              const Control& control) {
  const SmoothOptions& options = promise.options.mesher;
  SmoothExpectations expected;
  expected.complete = promise.complete;
  expected.listed = promise.listed;
  expected.missed_components = promise.missed_components;
  VerifyReport report = verify_smooth(domain.oracle, mesh, options, expected, control);
  if (!options.surface_only && mesh.tetrahedra.empty()) {
    Finding& finding = report.findings.emplace_back();
    finding.name = "the mesh has tetrahedra, for not only the surface was asked for";
    finding.fail([] { return std::string("there are none; --surface-only verifies a surface alone"); });
  }
  return report;
}

}  // namespace delref::program
