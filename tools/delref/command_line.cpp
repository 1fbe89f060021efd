// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "help_text.hpp"
#include "option_checks.hpp"
#include "smooth_command_line.hpp"

namespace delref::program {
namespace {

CLI::App* add_command(CLI::App& program, const char* name, const char* help) {
  CLI::App* command = program.add_subcommand(name);
  command->formatter_fn([help](const CLI::App*, const std::string&, CLI::AppFormatMode) { return std::string(help); });
  return command;
}

/// What `mesh` and `verify` both take.
Criteria add_criteria(CLI::App& command, ReportedOptions& o) {
  constexpr InputKinds plane = only(InputKind::plane), solid = only(InputKind::solid);
  CLI::Option* points = command.add_option("--size-points", o.size_points_file);
  return {{points, every_kind},
          {command.add_option("--gradation", o.gradation)->check(not_negative("a number"))->needs(points), every_kind},
          {command.add_option("--merge-tolerance", o.merge_tolerance)->check(not_negative("a length")), plane | InputKind::solid},
          {command.add_option("--min-angle", o.min_angle_degrees)->check(angle()), plane},
          {command.add_option("--max-area", o.max_area)->check(positive("an area")), plane},
          {command.add_option("--max-edge", o.max_edge)->check(positive("a length")), plane},
          {command.add_option("--encroachment", o.encroachment)->check(one_of("circle", "lens")), plane},
          {command.add_flag("--keep-boundary", o.keep_boundary), plane},
          {command.add_flag("--split-crossings", o.split_crossings), plane},
          {command.add_option("--radius-edge", o.radius_edge)->check(radius_edge()), space_kinds},
          {command.add_option("--max-volume", o.max_volume)->check(positive("a volume")), solid},
          {command.add_option("--cell-size", o.cell_size)->check(positive("a length")), space_kinds},
          {command.add_option("--join-coplanar", o.join_coplanar_degrees)->check(between("an angle in degrees", 0, 45)), solid},
          {command.add_option("--planarity-tolerance", o.planarity_tolerance)->check(between("a number", 0, 0.1)), solid}};
}

void append(Criteria& to, const Criteria& more) { to.insert(to.end(), more.begin(), more.end()); }

/// The options that were given, before anything is checked that depends on the input.
std::vector<GivenOption> given_of(const Criteria& criteria) {
  std::vector<GivenOption> given;
  for (const auto& [option, kinds] : criteria)
    if (kinds != every_kind && option->count() > 0) given.push_back({option->get_name(), kinds});
  return given;
}

CLI::App* add_mesh(CLI::App& program, MeshArguments& a) {
  CLI::App* command = add_command(program, "mesh", mesh_help);
  command->add_option("IN", a.input);
  command->add_option("-o,--output", a.outputs)->allow_extra_args(false);
  Criteria criteria = add_criteria(*command, a.options);
  append(criteria, add_sources(*command, a.smooth));
  append(criteria, add_smooth_criteria(*command, a.smooth));
  criteria.push_back({command->add_option("--points", a.options.points)->check(one_of("circumcentre", "off-centre")), only(InputKind::plane)});
  criteria.push_back(
      {command->add_option_function<std::string>("--svg-colour", [&a](const std::string& by) { a.svg_by_region = by == "region"; })
           ->check(one_of("angle", "region")),
       only(InputKind::plane)});
  command->add_option_function<double>("--max-vertices", [&a](double n) { a.options.max_vertices = static_cast<std::size_t>(n); })
      ->check(whole("a whole number"));
  command->add_option("--time-limit", a.options.time_limit_seconds)->check(not_negative("a number of seconds"));
  command->add_option("--smallest-edge", a.options.smallest_edge)->check(not_negative("a length"));
  command->add_option("--report", a.report);
  command->add_flag("--regions", a.regions);
  command->add_flag("--strict", a.strict);
  command->add_flag("--quiet", a.quiet);
  command->parse_complete_callback([&a, criteria] {
    a.given = given_of(criteria);
    if (a.input.empty() && a.smooth.expressions.empty()) throw CLI::RequiredError("IN");
    if (a.outputs.empty()) throw CLI::RequiredError("--output");
  });
  return command;
}

CLI::App* add_verify(CLI::App& program, VerifyArguments& a) {
  CLI::App* command = add_command(program, "verify", verify_help);
  command->add_option("IN", a.input);
  command->add_option("MESH", a.mesh);
  CLI::Option* report = command->add_option("--report", a.report);
  Criteria criteria = add_criteria(*command, a.options);
  append(criteria, add_sources(*command, a.smooth));
  append(criteria, add_smooth_criteria(*command, a.smooth));
  for (const auto& [option, kinds] : criteria) report->excludes(option);
  command->parse_complete_callback([&a, criteria] {
    a.given = given_of(criteria);
    // A function comes without a file: the one name that is left is that of the mesh.
    const bool has_function = !a.smooth.expressions.empty() || !a.report.empty();
    if (a.mesh.empty() && !a.input.empty() && has_function) std::swap(a.input, a.mesh);
    if (a.mesh.empty()) throw CLI::RequiredError(a.input.empty() && !has_function ? "IN" : "MESH");
  });
  return command;
}

CLI::App* add_info(CLI::App& program, InfoArguments& a) {
  CLI::App* command = add_command(program, "info", info_help);
  command->add_option("MESH", a.mesh)->required();
  return command;
}

/// What CLI11 complains about, in the words of this program.
std::string complaint(const CLI::App& program, const CLI::ParseError& error, const std::string& first_word) {
  const std::string what = error.what();
  if (program.get_subcommands().empty() && !first_word.starts_with('-'))
    return fmt::format("there is no command \"{}\"; the commands are mesh, verify and info", first_word);
  if (program.get_subcommands().empty())
    return fmt::format("\"{}\" is not an option of delref itself; begin with a command: mesh, verify or info", first_word);
  if (what.starts_with("Could not convert: --bounds") || (what.starts_with("--bounds: ") && what.find("required") != std::string::npos))
    return "--bounds needs six numbers, X0 Y0 Z0 X1 Y1 Z1: the lower corner of the box and the upper one";
  if (what == "--output is required") return "-o is missing: name at least one file for the mesh, such as -o mesh.vtu";
  if (what.ends_with(" is required")) return what.substr(0, what.find(' ')) + " is missing";
  if (what.ends_with(" missing")) return what.substr(0, what.find(':')) + " needs a value";
  if (what.find(" but received ") != std::string::npos) return what.substr(0, what.find(':')) + " is given more than once";
  return what;
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error, const std::string& first_word) {
  const auto commands = program.get_subcommands();
  const std::string command = commands.empty() ? "delref" : "delref " + commands.front()->get_name();
  return fmt::format("{}\nRun `{} --help` to see what can be given.", complaint(program, error, first_word), command);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  MeshArguments mesh;
  VerifyArguments verify;
  InfoArguments info;
  mesh.options.gradation = verify.options.gradation = default_gradation;

  CLI::App program;
  program.formatter_fn([](const CLI::App*, const std::string&, CLI::AppFormatMode) { return std::string(program_help); });
  program.set_version_flag("--version", "delref " DELREF_VERSION);
  const CLI::App* mesh_command = add_mesh(program, mesh);
  const CLI::App* verify_command = add_verify(program, verify);
  add_info(program, info);
  program.require_subcommand(1);

  if (argc < 2) {
    std::fputs(program_help, stderr);
    return ExitCode::usage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {
    program.exit(asked_for);
    return ExitCode::ok;
  } catch (const CLI::ParseError& error) {
    throw UsageError(usage_message(program, error, argv[1]));
  }
  for (ReportedOptions* options : {&mesh.options, &verify.options})
    if (options->size_points_file.empty()) options->gradation = 0;
  if (mesh_command->parsed()) return mesh;
  if (verify_command->parsed()) return verify;
  return info;
}

}  // namespace delref::program
