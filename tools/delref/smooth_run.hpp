// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the commands need of smooth domains, after the model of planar_run.hpp.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify/report.hpp>

#include "options.hpp"
#include "progress.hpp"
#include "smooth_domain.hpp"

namespace delref::program {

/// What a refinement of a smooth domain gives.
struct SmoothRun {
  TetrahedralMesh mesh;
  Outcome<Point3> outcome;
  std::vector<std::string> notes;
  ReportedSurface surface;
};

/// What the mesher takes. The sizes by label become sizes by region number when the domain is known.
struct SmoothRunOptions {
  SmoothOptions mesher;
  std::vector<std::pair<int, double>> region_cell_sizes;
};

/// The options as the mesher takes them for a domain: with its usual sizes, when no size or distance of facets was asked for, and the
/// sizes of its regions. Throws `InvalidInput` for a size of a region that is not there.
SmoothOptions options_for(const SmoothDomain& domain, const SmoothRunOptions& options);

/// What a mesh of a smooth domain is verified against.
struct SmoothPromise {
  SmoothRunOptions options;
  bool complete = true;
  std::vector<Unmet<Point3>> listed;
  std::size_t missed_components = 0;
};

/// Sets the sizes that were left open: as the report of the run has them, or else as the mesher would choose them. Gives in words what
/// was set so, and by whom; empty when nothing that has to be told was. Throws `InvalidInput` and `Interrupted`.
std::string settle_sizes(SmoothPromise& promise, const std::optional<ReportedFacetSizes>& of_report, const SmoothDomain& domain,
                         const Control& control);

/// `verify_smooth`. Requires settled sizes. Throws `InvalidInput` and `Interrupted`.
VerifyReport run_verification(const SmoothDomain& domain, const TetrahedralMesh& mesh, const SmoothPromise& promise,
                              const ReportedOptions& options, const Control& control);

/// Refines, watched by `progress`. Throws `InvalidInput` and `Interrupted`.
SmoothRun run_mesher(const SmoothDomain& domain, const SmoothRunOptions& options, const Control& control, Progress& progress);

/// What a run of the program on a smooth domain is made of.
struct Smooth {
  using Point = Point3;
  using Domain = SmoothDomain;
  using Mesh = TetrahedralMesh;
  using Run = SmoothRun;
  using Report = PolyhedralRunReport;
  static constexpr const char* before_refining = "examining";

  static SmoothRunOptions options(const ReportedOptions& o) { return {smooth_options(o), o.smooth->region_cell_sizes}; }
  /// Sizes bound the facets as well as the tetrahedra at their place.
  static void set_sizes(SmoothRunOptions& options, std::function<double(Point3)> size) {
    options.mesher.facet_size_field = size;
    options.mesher.cell_size_field = std::move(size);
  }
  static SmoothPromise criteria(const ReportedOptions& o) { return {options(o), true, {}, 0}; }
  static void promise_sizes(SmoothPromise& promise, std::function<double(Point3)> size) { set_sizes(promise.options, std::move(size)); }
};

}  // namespace delref::program
