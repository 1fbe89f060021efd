// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of `delref mesh` on any kind of input: reads, meshes, writes, tells.
#pragma once

#include <cstdio>
#include <future>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/file.hpp>
#include <delref/mesh/quality.hpp>
#include <delref/mesh/tetrahedral_quality.hpp>

#include "arguments.hpp"
#include "exit_codes.hpp"
#include "files.hpp"
#include "input_kind.hpp"
#include "label_tables.hpp"
#include "planar_run.hpp"
#include "polyhedral_run.hpp"
#include "progress.hpp"
#include "size_points.hpp"
#include "smooth_run.hpp"
#include "stages.hpp"
#include "summary.hpp"

namespace delref::program {

inline ReportedCounts counts_of(const Pslg& input) {
  return {.vertices = input.points.size(), .segments = input.segments.size(), .holes = input.holes.size(), .regions = input.regions.size()};
}
inline ReportedCounts counts_of(const Plc& input) {
  return {.vertices = input.points.size(),
          .segments = input.segments.size(),
          .holes = input.holes.size(),
          .regions = input.regions.size(),
          .facets = input.facets.size()};
}
inline ReportedCounts counts_of(const SmoothDomain&) { return {}; }
inline ReportedCounts counts_of(const PlanarMesh& mesh) {
  return {.vertices = mesh.points.size(), .segments = mesh.edges.size(), .triangles = mesh.triangles.size()};
}
inline ReportedCounts counts_of(const TetrahedralMesh& mesh) {
  return {.vertices = mesh.points.size(), .segments = mesh.edges.size(), .triangles = mesh.triangles.size(), .tetrahedra = mesh.tetrahedra.size()};
}

inline PlanarQuality quality_of(const PlanarMesh& mesh) { return planar_quality(mesh); }
inline TetrahedralQuality quality_of(const TetrahedralMesh& mesh) { return tetrahedral_quality(mesh); }

inline bool is_empty(const PlanarMesh& mesh) { return mesh.triangles.empty(); }
inline bool is_empty(const TetrahedralMesh& mesh) { return mesh.tetrahedra.empty() && mesh.triangles.empty(); }

/// What a run tells beyond one of the plane.
inline void add_to_report(RunReport&, PlanarRun&) {}
inline void add_to_report(PolyhedralRunReport& report, PolyhedralRun& run) {
  report.conforms = run.conforms;
  report.input_angles = std::move(run.input_angles);
  report.input_angle_count = run.input_angle_count;
}

inline void add_to_report(PolyhedralRunReport& report, SmoothRun& run) { report.surface = std::move(run.surface); }

/// What is wrong with an input that was read, under its name.
inline InvalidInput with_file_name(const InvalidInput& error, const std::string& file) {
  std::vector<Defect> defects{{fmt::format("{} cannot be meshed:", file), {}}};
  for (const Defect& defect : error.defects()) defects.push_back({"  " + defect.message, defect.places});
  return InvalidInput(std::move(defects));
}

/// `Kind` is `Plane`, `Space` or `Smooth`.
template <class Kind>
class MeshRun {
 public:
  MeshRun(const MeshArguments& arguments, const Control& control, Progress& progress)
      : arguments_(arguments), control_(control), progress_(progress) {
    report_.version = DELREF_VERSION;
    report_.input_file = arguments.input;
    report_.output_files = arguments.outputs;
    report_.options = arguments.options;
  }

  /// Throws `InvalidInput`, and `Interrupted` when the control says stop before there is a mesh.
  ExitCode run() {
    read();
    mesh();
    if (is_empty(run_.mesh)) return nothing_to_write();
    write();
    progress_.finish();
    tell();
    return failed_ ? ExitCode::internal : exit_code(report_, arguments_.strict);
  }

 private:
  void read() {
    options_ = Kind::options(arguments_.options);
    input_ = stages_("reading", "reading", [&] {
      if (const ReportedOptions& o = arguments_.options; !o.size_points_file.empty())
        Kind::set_sizes(options_, read_size_points<typename Kind::Point>(o.size_points_file, o.gradation, control_));
      return read_domain<typename Kind::Domain>(arguments_.input, arguments_.options, control_, report_.notes);
    });
    report_.input = counts_of(input_);
  }

  void mesh() {
    run_ = stages_("meshing", Kind::before_refining, [&] {
      try {
        return run_mesher(input_, options_, control_, progress_);
      } catch (const InvalidInput& error) {
        throw with_file_name(error, name_);
      }
    });
    report_.outcome = std::move(run_.outcome);
    for (std::string& note : run_.notes) report_.notes.push_back(std::move(note));
    add_to_report(report_, run_);
    report_.mesh = counts_of(run_.mesh);
  }

  /// Writes every output, also when one of them fails.
  void write() {
    auto quality = std::async(std::launch::async, [this] { return quality_of(run_.mesh); });  // while files are written
    stages_("writing", "writing", [&] {
      for (const std::string& output : arguments_.outputs)
        attempt([&] {
          for (std::string& file : write_mesh(output, run_, input_, report_, arguments_)) written_.push_back(std::move(file));
        });
      return 0;
    });
    report_.quality = quality.get();
    report_what_was_asked();
  }

  void report_what_was_asked() {
    if (arguments_.report.empty()) return;
    attempt([&] {
      write_run_report(arguments_.report, report_);
      written_.push_back(arguments_.report);
    });
  }

  template <class Write>
  void attempt(Write&& write) {
    try {
      write();
    } catch (const OutputError& error) {
      failed_ = true;
      progress_.finish();
      fmt::print(stderr, "delref: {}\n", error.what());
    }
  }

  void tell() const {
    if (!arguments_.quiet) {
      fmt::print("{}", summary(report_, run_.mesh, written_));
      if (arguments_.regions) fmt::print("{}", regions_table(run_.mesh));
    } else if (exit_code(report_, true) != ExitCode::ok) {
      fmt::print(stderr, "delref: {}: {}\n{}", name_, verdict(report_), unmet_table(report_));
    }
  }

  /// The run was stopped before any part of the domain could be told from its outside.
  ExitCode nothing_to_write() {
    report_.output_files.clear();
    report_what_was_asked();
    progress_.finish();
    fmt::print(stderr, "delref: {}: {}\n{}There is no mesh yet, and none was written.\n", name_, verdict(report_), unmet_table(report_));
    return failed_ ? ExitCode::internal : report_.outcome.stopped == Stop::token ? ExitCode::interrupted : ExitCode::unmet;
  }

  const MeshArguments& arguments_;
  const std::string name_ = name_of_input(arguments_.input, arguments_.smooth);
  const Control& control_;
  Progress& progress_;
  typename Kind::Report report_;
  Stages stages_{progress_, report_.seconds};
  decltype(Kind::options(ReportedOptions{})) options_;
  typename Kind::Domain input_;
  typename Kind::Run run_;
  std::vector<std::string> written_;
  bool failed_ = false;
};

}  // namespace delref::program
