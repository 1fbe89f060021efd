// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <delref/domain/pslg_check.hpp>
#include <delref/mesh/verify_planar.hpp>

#include "kept_boundary.hpp"
#include "planar_run.hpp"

namespace delref::program {
namespace {

VerifyReport verify(const Pslg& input, const PlanarMesh& mesh, const PlanarCriteria& criteria, bool keep_boundary,
                    const Control& control) {
  VerifyReport report = verify_planar(input, mesh, criteria, control);
  if (keep_boundary && report.ok()) report.findings.push_back(check_kept_boundary(input, mesh));
  return report;
}

}  // namespace

VerifyReport run_verification(Pslg input, const PlanarMesh& mesh, PlanarCriteria criteria, const ReportedOptions& options,
                              const Control& control) {
  if (!options.split_crossings && options.merge_tolerance == 0) {
    if (DefectList defects = find_plain_defects(input, control); !defects.empty()) throw InvalidInput(defects.take());
    return verify(input, mesh, criteria, options.keep_boundary, control);
  }
  CheckedPslg checked = check_pslg(std::move(input), {options.merge_tolerance, options.split_crossings}, control);
  criteria.point_names = std::move(checked.original_point);
  criteria.segment_names = std::move(checked.original_segment);
  return verify(checked.pslg, mesh, criteria, options.keep_boundary, control);
}

}  // namespace delref::program
