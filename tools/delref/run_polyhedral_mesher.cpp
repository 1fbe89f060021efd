// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <delref/algorithms/polyhedral.hpp>

#include "polyhedral_run.hpp"

namespace delref::program {
namespace {

/// Elements of the domain by the numbers of the input file.
class ElementNames {
 public:
  explicit ElementNames(const PolyhedralDomain& domain) : domain_(domain) {}

  ReportedAngle operator()(const PolyhedralDomain::SmallAngle& angle) const {
    using Kind = PolyhedralDomain::SmallAngle::Kind;
    const auto [first, second] = angle.elements;
    const auto unscaled = [&](double x) { return std::ldexp(x, -domain_.scale); };
    return {angle.degrees,
            {angle.kind == Kind::facets ? facet(first) : segment(first), angle.kind == Kind::segments ? segment(second) : facet(second)},
            {unscaled(angle.place.x), unscaled(angle.place.y), unscaled(angle.place.z)}};
  }

 private:
  std::string facet(Plc::Index f) const { return fmt::format("facet {}", domain_.facets[f].original + domain_.first_index); }
  std::string segment(Plc::Index s) const {
    const auto [a, b] = domain_.segments[s].ends;
    return fmt::format("segment {}-{}", domain_.original_point[a] + domain_.first_index, domain_.original_point[b] + domain_.first_index);
  }

  const PolyhedralDomain& domain_;
};

/// A run that is stopped while tetrahedra are refined may have split a facet and not yet brought all pieces into the mesh.
bool has_missing_elements(const Outcome<Point3>& outcome) {
  return std::ranges::any_of(outcome.unmet, [](const auto& u) { return u.criterion.starts_with("missing "); });
}

}  // namespace

PolyhedralRun run_mesher(Plc input, const PolyhedralOptions& options, const Control& control, Progress& progress) {
  check_polyhedral_options(options);
  PolyhedralRefinement<> refinement(std::move(input), options, control);
  PolyhedralRun run;
  run.outcome = refinement.refine(control, progress);
  run.mesh = refinement.mesh();
  run.notes = refinement.notes();
  run.conforms = refinement.conforms() && !has_missing_elements(run.outcome);
  const PolyhedralDomain& domain = refinement.domain();
  run.original_point = domain.original_point;
  run.input_angle_count = domain.small_angles.size();
  const ElementNames named(domain);
  for (std::size_t i = 0; i < std::min(run.input_angle_count, PolyhedralRun::most_angles); ++i)
    run.input_angles.push_back(named(domain.small_angles[i]));
  return run;
}

}  // namespace delref::program
