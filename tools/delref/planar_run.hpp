// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the commands need of the plane. The two pieces of the library that take a compiler long are each compiled in a file of their
// own: the mesher with the program's observer, and the verification.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/planar_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/domain/pslg.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/planar_mesh.hpp>
#include <delref/mesh/verify/criteria.hpp>
#include <delref/mesh/verify/report.hpp>

#include "options.hpp"
#include "progress.hpp"

namespace delref::program {

/// What `mesh_planar` gives.
struct PlanarRun {
  PlanarMesh mesh;
  Outcome<Point2> outcome;
  std::vector<std::string> notes;
};

/// `mesh_planar`, watched by `progress`. Throws `InvalidInput` and `Interrupted`.
PlanarRun run_mesher(Pslg input, const PlanarOptions& options, const Control& control, Progress& progress);

/// Verifies against the input as the run saw it: with its vertices merged and its crossings split, when the options say so.
/// Of the options only these and the kept boundary are asked; all else is in `criteria`. Throws `InvalidInput` when the input has
/// bad indices or numbers, and `Interrupted`.
VerifyReport run_verification(Pslg input, const PlanarMesh& mesh, PlanarCriteria criteria, const ReportedOptions& options,
                              const Control& control);

/// What a run of the program in the plane is made of (`mesh_run.hpp`, verify_command.cpp).
struct Plane {
  using Point = Point2;
  using Domain = Pslg;
  using Mesh = PlanarMesh;
  using Run = PlanarRun;
  using Report = RunReport;
  static constexpr const char* before_refining = "checking";

  static PlanarOptions options(const ReportedOptions& o) { return planar_options(o); }
  static void set_sizes(PlanarOptions& options, std::function<double(Point2)> size) { options.size = std::move(size); }
  static PlanarCriteria criteria(const ReportedOptions& o) { return planar_criteria(o); }
  static void promise_sizes(PlanarCriteria& criteria, std::function<double(Point2)> size) { criteria.size = std::move(size); }
};

}  // namespace delref::program
