// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.hpp"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <delref/criteria/angle_bound.hpp>

#include "help_text.hpp"

namespace delref::program {
namespace {

/// A check of CLI11 on a number that `is_right`; `words` say what it must be.
template <class Predicate>
CLI::Validator number(std::string words, Predicate is_right) {
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && is_right(value)) return std::string();
        return fmt::format("{} is not {}", text.empty() ? "nothing" : text, words);
      },
      "");
}

CLI::Validator positive(const std::string& what) {
  return number(what + " greater than 0", [](double x) { return std::isfinite(x) && x > 0; });
}
CLI::Validator not_negative(const std::string& what) {
  return number(what + ", 0 or greater", [](double x) { return std::isfinite(x) && x >= 0; });
}
CLI::Validator whole(const std::string& what) {
  return number(what + " greater than 0", [](double x) { return x >= 1 && x <= 4e9 && std::floor(x) == x; });
}

/// Refuses what no mesh can meet, in the words of the library.
CLI::Validator angle() {
  return CLI::Validator(
      [](std::string& text) {
        double degrees = 0;
        if (!CLI::detail::lexical_cast(text, degrees)) return fmt::format("{} is not a number of degrees", text);
        try {
          static_cast<void>(AngleBound::degrees(degrees));
          return std::string();
        } catch (const InvalidInput& error) {
          return std::string(error.what());
        }
      },
      "");
}

CLI::Validator between(const std::string& what, double least, double most) {
  return number(fmt::format("{} from {:g} to {:g}", what, least, most), [=](double x) { return x >= least && x <= most; });
}
/// The smallest bound that the library takes.
CLI::Validator radius_edge() {
  return number("a ratio of at least 1, under which refinement would never end", [](double x) { return std::isfinite(x) && x >= 1; });
}

CLI::Validator one_of(std::string first, std::string second) {
  return CLI::Validator(
      [=](std::string& text) {
        return text == first || text == second ? std::string() : fmt::format("\"{}\" is neither {} nor {}", text, first, second);
      },
      "");
}

CLI::App* add_command(CLI::App& program, const char* name, const char* help) {
  CLI::App* command = program.add_subcommand(name);
  command->formatter_fn([help](const CLI::App*, const std::string&, CLI::AppFormatMode) { return std::string(help); });
  return command;
}

using Options = std::vector<CLI::Option*>;

/// Options of a command, by the dimension in which they have a meaning.
struct Criteria {
  Options of_both, of_plane, of_space;
};

/// What `mesh` and `verify` both take.
Criteria add_criteria(CLI::App& command, ReportedOptions& o) {
  Criteria criteria;
  CLI::Option* points = command.add_option("--size-points", o.size_points_file);
  criteria.of_both = {points, command.add_option("--gradation", o.gradation)->check(not_negative("a number"))->needs(points),
                      command.add_option("--merge-tolerance", o.merge_tolerance)->check(not_negative("a length"))};
  criteria.of_plane = {command.add_option("--min-angle", o.min_angle_degrees)->check(angle()),
                       command.add_option("--max-area", o.max_area)->check(positive("an area")),
                       command.add_option("--max-edge", o.max_edge)->check(positive("a length")),
                       command.add_option("--encroachment", o.encroachment)->check(one_of("circle", "lens")),
                       command.add_flag("--keep-boundary", o.keep_boundary),
                       command.add_flag("--split-crossings", o.split_crossings)};
  criteria.of_space = {command.add_option("--radius-edge", o.radius_edge)->check(radius_edge()),
                       command.add_option("--max-volume", o.max_volume)->check(positive("a volume")),
                       command.add_option("--cell-size", o.cell_size)->check(positive("a length")),
                       command.add_option("--join-coplanar", o.join_coplanar_degrees)->check(between("an angle in degrees", 0, 45)),
                       command.add_option("--planarity-tolerance", o.planarity_tolerance)->check(between("a number", 0, 0.1))};
  return criteria;
}

/// The names of the options that were given, before anything is checked that depends on the input.
GivenOptions given_of(const Criteria& criteria) {
  const auto names = [](const Options& options) {
    std::vector<std::string> given;
    for (const CLI::Option* option : options)
      if (option->count() > 0) given.push_back(option->get_name());
    return given;
  };
  return {names(criteria.of_plane), names(criteria.of_space)};
}

CLI::App* add_mesh(CLI::App& program, MeshArguments& a) {
  CLI::App* command = add_command(program, "mesh", mesh_help);
  command->add_option("IN", a.input)->required();
  command->add_option("-o,--output", a.outputs)->required()->allow_extra_args(false);
  Criteria criteria = add_criteria(*command, a.options);
  criteria.of_plane.push_back(
      command->add_option("--points", a.options.points)->check(one_of("circumcentre", "off-centre")));
  criteria.of_plane.push_back(
      command->add_option_function<std::string>("--svg-colour", [&a](const std::string& by) { a.svg_by_region = by == "region"; })
          ->check(one_of("angle", "region")));
  command->add_option_function<double>("--max-vertices", [&a](double n) { a.options.max_vertices = static_cast<std::size_t>(n); })
      ->check(whole("a whole number"));
  command->add_option("--time-limit", a.options.time_limit_seconds)->check(not_negative("a number of seconds"));
  command->add_option("--smallest-edge", a.options.smallest_edge)->check(not_negative("a length"));
  command->add_option("--report", a.report);
  command->add_flag("--regions", a.regions);
  command->add_flag("--strict", a.strict);
  command->add_flag("--quiet", a.quiet);
  command->parse_complete_callback([&a, criteria] { a.given = given_of(criteria); });
  return command;
}

CLI::App* add_verify(CLI::App& program, VerifyArguments& a) {
  CLI::App* command = add_command(program, "verify", verify_help);
  command->add_option("IN", a.input)->required();
  command->add_option("MESH", a.mesh)->required();
  CLI::Option* report = command->add_option("--report", a.report);
  const Criteria criteria = add_criteria(*command, a.options);
  for (const Options& options : {criteria.of_both, criteria.of_plane, criteria.of_space})
    for (CLI::Option* criterion : options) report->excludes(criterion);
  command->parse_complete_callback([&a, criteria] { a.given = given_of(criteria); });
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
