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

#include "commands.hpp"
#include "files.hpp"
#include "input_kind.hpp"
#include "interrupt.hpp"
#include "kept_back.hpp"
#include "mesh_run.hpp"
#include "progress.hpp"

namespace delref::program {
namespace {

class MeshCommand {
 public:
  explicit MeshCommand(const MeshArguments& arguments) : arguments_(arguments), progress_(!arguments.quiet, signals_.token()) {}

  ExitCode run() {
    try {
      const InputKind kind = kind_of_input(arguments_.input, arguments_.smooth, Control(budget(), signals_.token()));
      refuse_options_of_other_kinds(arguments_.given, kind, name_, "mesh");
      if (is_smooth(kind)) arguments_.options.smooth = arguments_.smooth;
      files_ = check_outputs({arguments_.outputs, arguments_.report, inputs()}, kind);
      files_are_known_.store(true, std::memory_order_release);
      Budget budget = this->budget();
      budget.kept_back_per_vertex = kept_back_per_vertex(arguments_.outputs, kind);
      const Control control(budget, signals_.token());
      if (is_smooth(kind)) return MeshRun<Smooth>(arguments_, control, progress_).run();
      if (kind == InputKind::plane) return MeshRun<Plane>(arguments_, control, progress_).run();
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
    std::vector<std::string> files;
    if (!arguments_.input.empty()) files.push_back(arguments_.input);
    if (!arguments_.options.size_points_file.empty()) files.push_back(arguments_.options.size_points_file);
    return files;
  }

  ExitCode nothing_to_show(Stop cause) {
    progress_.finish();
    fmt::print(stderr, "delref: {} while {} {}; there is no mesh yet, and nothing was written\n",
               cause == Stop::time ? "the time limit was reached" : "interrupted", progress_.stage(), name_);
    return cause == Stop::time ? ExitCode::unmet : ExitCode::interrupted;
  }

  /// The second interrupt, in a thread of its own: nothing is finished any more. What is complete stays, what is not is removed.
  [[noreturn]] void abandon() {
    progress_.silence();
    fmt::print(stderr, "delref: interrupted again while {} {}; what was not complete is removed\n", progress_.stage(), name_);
    if (files_are_known_.load(std::memory_order_acquire)) remove_partial_files(files_);
    std::_Exit(static_cast<int>(ExitCode::interrupted));
  }

  MeshArguments arguments_;
  const std::string name_ = name_of_input(arguments_.input, arguments_.smooth);
  const Clock::time_point start_ = Clock::now();
  std::vector<std::filesystem::path> files_;
  std::atomic<bool> files_are_known_{false};
  StopOnSignal signals_{[this] { abandon(); }};
  Progress progress_;
};

}  // namespace

ExitCode run(const MeshArguments& arguments) { return MeshCommand(arguments).run(); }

}  // namespace delref::program
