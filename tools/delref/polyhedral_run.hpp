// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the commands need of space, after the model of planar_run.hpp.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/polyhedral_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify/report.hpp>
#include <delref/mesh/verify_3/criteria.hpp>

#include "options.hpp"
#include "progress.hpp"

namespace delref::program {

/// What a refinement of space gives.
struct PolyhedralRun {
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  std::vector<std::string> notes;
  /// Every segment and facet is in the mesh.
  bool conforms = false;
  /// Per vertex of the domain its index in the input.
  std::vector<Plc::Index> original_point;
  /// The smallest `most_angles` of those under 90 degrees, and how many there are.
  static constexpr std::size_t most_angles = 1000;
  std::vector<ReportedAngle> input_angles;
  std::size_t input_angle_count = 0;
};

/// Refines, watched by `progress`. Throws `InvalidInput` and `Interrupted`.
PolyhedralRun run_mesher(Plc input, const PolyhedralOptions& options, const Control& control, Progress& progress);

/// `verify_polyhedral`. The options are all in `criteria`. Throws `Interrupted`.
VerifyReport run_verification(const Plc& input, const TetrahedralMesh& mesh, const PolyhedralCriteria& criteria,
                              const ReportedOptions& options, const Control& control);

/// What a run of the program in space is made of.
struct Space {
  using Point = Point3;
  using Domain = Plc;
  using Mesh = TetrahedralMesh;
  using Run = PolyhedralRun;
  using Report = PolyhedralRunReport;
  static constexpr const char* before_refining = "checking";

  static PolyhedralOptions options(const ReportedOptions& o) { return polyhedral_options(o); }
  static void set_sizes(PolyhedralOptions& options, std::function<double(Point3)> size) { options.size = std::move(size); }
  static PolyhedralCriteria criteria(const ReportedOptions& o) { return polyhedral_criteria(o); }
  static void promise_sizes(PolyhedralCriteria& criteria, std::function<double(Point3)> size) { criteria.size = std::move(size); }
};

}  // namespace delref::program
