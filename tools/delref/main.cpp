// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program delref: runs the command that was asked for, and turns every failure into words and an exit code.
#include <cstdio>
#include <exception>
#include <new>
#include <variant>

#include <fmt/format.h>

#include <delref/domain/invalid_input.hpp>
#include <delref/io/file.hpp>

#include "command_line.hpp"
#include "commands.hpp"

namespace delref::program {
namespace {

ExitCode finish(ExitCode code) { return code; }

template <class Arguments>
ExitCode finish(const Arguments& arguments) {
  return run(arguments);
}

ExitCode complain(ExitCode code, const char* words) {
  fmt::print(stderr, "delref: {}\n", words);
  return code;
}

ExitCode run_program(int argc, const char* const* argv) {
  try {
    return std::visit([](const auto& command) { return finish(command); }, parse_command_line(argc, argv));
  } catch (const UsageError& error) {
    return complain(ExitCode::usage, error.what());
  } catch (const InvalidInput& error) {
    return complain(ExitCode::invalid_input, error.what());
  } catch (const OutputError& error) {
    return complain(ExitCode::internal, error.what());
  } catch (const std::bad_alloc&) {
    return complain(ExitCode::internal, "memory ran out; a larger --smallest-edge or a smaller --max-vertices needs less");
  } catch (const std::exception& error) {
    fmt::print(stderr, "delref: internal error, please report it with the input: {}\n", error.what());
    return ExitCode::internal;
  }
}

}  // namespace
}  // namespace delref::program

int main(int argc, char** argv) {
  using delref::program::ExitCode;
  ExitCode code = delref::program::run_program(argc, argv);
  if (std::fflush(stdout) != 0 && code == ExitCode::ok) {
    std::fputs("delref: standard output cannot be written\n", stderr);
    code = ExitCode::internal;
  }
  return static_cast<int>(code);
}
