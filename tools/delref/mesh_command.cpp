// SPDX-License-Identifier: GPL-3.0-or-later
//
// `delref mesh`: what comes before and around a run, whatever it meshes.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/polyhedral_formats.hpp>

#include "commands.hpp"
#include "files.hpp"
#include "interrupt.hpp"
#include "kept_back.hpp"
#include "mesh_run.hpp"
#include "option_dimension.hpp"
#include "progress.hpp"

namespace delref::program {
namespace {

class MeshCommand {
 public:
  explicit MeshCommand(const MeshArguments& arguments) : arguments_(arguments), progress_(!arguments.quiet, signals_.token()) {}

  ExitCode run() {
    try {
      const Dimension dimension = dimension_of(arguments_.input, Control(budget(), signals_.token()));
      refuse_options_of_the_other_dimension(arguments_.given, dimension, arguments_.input, "mesh");
      files_ = check_outputs({arguments_.outputs, arguments_.report, inputs()}, dimension);
      files_are_known_.store(true, std::memory_order_release);
      Budget budget = this->budget();
      budget.kept_back_per_vertex = kept_back_per_vertex(arguments_.outputs, dimension);
      const Control control(budget, signals_.token());
      if (dimension == Dimension::plane) return MeshRun<Plane>(arguments_, control, progress_).run();
      return MeshRun<Space>(arguments_, control, progress_).run();
    } catch (const Interrupted& interrupted) {
      return nothing_to_show(interrupted.cause);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// What is left of it now.
  Budget budget() const {
    Budget budget;
    const ReportedOptions& o = arguments_.options;
    if (o.max_vertices) budget.max_vertices = *o.max_vertices;
    if (o.time_limit_seconds) budget.time_limit = std::chrono::duration<double>(*o.time_limit_seconds);
    budget.time_limit -= Clock::now() - start_;
    budget.smallest_edge = o.smallest_edge;
    return budget;
  }

  std::vector<std::string> inputs() const {
    std::vector<std::string> files{arguments_.input};
    if (!arguments_.options.size_points_file.empty()) files.push_back(arguments_.options.size_points_file);
    return files;
  }

  ExitCode nothing_to_show(Stop cause) {
    progress_.finish();
    fmt::print(stderr, "delref: {} while {} {}; there is no mesh yet, and nothing was written\n",
               cause == Stop::time ? "the time limit was reached" : "interrupted", progress_.stage(), arguments_.input);
    return cause == Stop::time ? ExitCode::unmet : ExitCode::interrupted;
  }

  /// The second interrupt, in a thread of its own: nothing is finished any more. What is complete stays, what is not is removed.
  [[noreturn]] void abandon() {
    progress_.silence();
    fmt::print(stderr, "delref: interrupted again while {} {}; what was not complete is removed\n", progress_.stage(), arguments_.input);
    if (files_are_known_.load(std::memory_order_acquire)) remove_partial_files(files_);
    std::_Exit(static_cast<int>(ExitCode::interrupted));
  }

  const MeshArguments& arguments_;
  const Clock::time_point start_ = Clock::now();
  std::vector<std::filesystem::path> files_;
  std::atomic<bool> files_are_known_{false};
  StopOnSignal signals_{[this] { abandon(); }};
  Progress progress_;
};

}  // namespace

ExitCode run(const MeshArguments& arguments) { return MeshCommand(arguments).run(); }

}  // namespace delref::program
