// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the words of the command line to arguments whose numbers make sense.
#pragma once

#include <variant>

#include "arguments.hpp"
#include "exit_codes.hpp"

namespace delref::program {

/// What to do; or, when help was printed and nothing is left to do, how to end.
using CommandLine = std::variant<ExitCode, MeshArguments, VerifyArguments, InfoArguments>;

/// Throws `UsageError` with a message that ends by saying which help to read.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace delref::program
