// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref mesh`: reads, meshes, writes, tells.
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/algorithms/planar_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/file.hpp>
#include <delref/io/report.hpp>
#include <delref/mesh/quality.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "planar_run.hpp"
#include "progress.hpp"
#include "size_points.hpp"
#include "summary.hpp"

namespace delref::program {
namespace {

Budget budget(const MeshArguments& a) {
  Budget budget;
  if (a.options.max_vertices) budget.max_vertices = *a.options.max_vertices;
  if (a.options.time_limit_seconds) budget.time_limit = std::chrono::duration<double>(*a.options.time_limit_seconds);
  budget.smallest_edge = a.smallest_edge;
  return budget;
}

/// All but the sizing field.
PlanarOptions planar_options(const ReportedOptions& o) {
  PlanarOptions options;
  options.min_angle = AngleBound::degrees(o.min_angle_degrees);
  options.max_area = o.max_area.value_or(std::numeric_limits<double>::infinity());
  options.max_edge = o.max_edge.value_or(std::numeric_limits<double>::infinity());
  options.encroachment = o.encroachment == "lens" ? Encroachment::lens : Encroachment::circle;
  options.points = o.points == "circumcentre" ? PointChoice::circumcentre : PointChoice::off_centre;
  options.keep_boundary = o.keep_boundary;
  options.split_crossings = o.split_crossings;
  options.merge_tolerance = o.merge_tolerance;
  return options;
}

/// Runs stages one after the other, keeping the seconds of each in a report.
class Stages {
 public:
  Stages(Progress& progress, RunReport& report) : progress_(progress), report_(report) {}

  /// `name` is for the report; `words`, to go before the name of the input, for people.
  template <class Work>
  auto operator()(const char* name, const char* words, Work&& work) {
    progress_.begin(words);
    const auto begin = std::chrono::steady_clock::now();
    auto result = std::forward<Work>(work)();
    report_.seconds.emplace_back(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    return result;
  }

 private:
  Progress& progress_;
  RunReport& report_;
};

/// What is wrong with an input that was read, under its name.
InvalidInput with_file_name(const InvalidInput& error, const std::string& file) {
  std::vector<Defect> defects{{fmt::format("{} cannot be meshed:", file), {}}};
  for (const Defect& defect : error.defects()) defects.push_back({"  " + defect.message, defect.places});
  return InvalidInput(std::move(defects));
}

class MeshCommand {
 public:
  explicit MeshCommand(const MeshArguments& arguments)
      : arguments_(arguments), control_(budget(arguments), signals_.token()), progress_(!arguments.quiet, signals_.token()) {
    report_.version = DELREF_VERSION;
    report_.input_file = arguments.input;
    report_.output_files = arguments.outputs;
    report_.options = arguments.options;
    report_.options.smallest_edge = arguments.smallest_edge;
  }

  ExitCode run() {
    check_outputs({arguments_.outputs, arguments_.report, inputs()});
    try {
      read();
      mesh();
    } catch (const Interrupted& interrupted) {
      return nothing_to_show(interrupted.cause);
    }
    write();
    progress_.finish();
    tell();
    return failed_ ? ExitCode::internal : exit_code(report_.outcome, arguments_.strict);
  }

 private:
  std::vector<std::string> inputs() const {
    std::vector<std::string> files{arguments_.input};
    if (!arguments_.options.size_points_file.empty()) files.push_back(arguments_.options.size_points_file);
    return files;
  }

  void read() {
    options_ = planar_options(arguments_.options);
    input_ = stages_("reading", "reading", [&] {
      if (const ReportedOptions& o = arguments_.options; !o.size_points_file.empty())
        options_.size = read_size_points(o.size_points_file, o.gradation, control_);
      return read_domain(arguments_.input, control_, report_.notes);
    });
    report_.input = {input_.points.size(), input_.segments.size(), 0, input_.holes.size(), input_.regions.size()};
  }

  void mesh() {
    PlanarRun run = stages_("meshing", "checking", [&] {
      try {
        return run_mesher(input_, options_, control_, progress_);
      } catch (const InvalidInput& error) {
        throw with_file_name(error, arguments_.input);
      }
    });
    mesh_ = std::move(run.mesh);
    report_.outcome = std::move(run.outcome);
    for (std::string& note : run.notes) report_.notes.push_back(std::move(note));
    report_.mesh = {mesh_.points.size(), mesh_.edges.size(), mesh_.triangles.size(), 0, 0};
    report_.quality = planar_quality(mesh_);
  }

  /// Writes every output, also when one of them fails.
  void write() {
    stages_("writing", "writing", [&] {
      for (const std::string& output : arguments_.outputs)
        attempt([&] {
          for (std::string& file : write_mesh(output, mesh_, input_, report_, arguments_.by_region))
            written_.push_back(std::move(file));
        });
      return 0;
    });
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
      fmt::print("{}", summary(report_, mesh_, written_));
    } else if (!report_.outcome.unmet.empty() || report_.outcome.stopped) {
      fmt::print(stderr, "delref: {}: {}\n{}", arguments_.input, verdict(report_), unmet_table(report_.outcome));
    }
  }

  ExitCode nothing_to_show(Stop cause) {
    progress_.finish();
    fmt::print(stderr, "delref: {} while {} {}; there is no mesh yet, and nothing was written\n",
               cause == Stop::time ? "the time limit was reached" : "interrupted", progress_.stage(), arguments_.input);
    return cause == Stop::time ? ExitCode::unmet : ExitCode::interrupted;
  }

  const MeshArguments& arguments_;
  StopOnSignal signals_;
  Control control_;
  Progress progress_;
  RunReport report_;
  Stages stages_{progress_, report_};
  PlanarOptions options_;
  Pslg input_;
  PlanarMesh mesh_;
  std::vector<std::string> written_;
  bool failed_ = false;
};

}  // namespace

ExitCode run(const MeshArguments& arguments) { return MeshCommand(arguments).run(); }

}  // namespace delref::program
