// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands. Each prints what it has to say and gives the exit code. `InvalidInput`, `OutputError` and `UsageError` are left
// to the caller.
#pragma once

#include "arguments.hpp"
#include "exit_codes.hpp"

namespace delref::program {

ExitCode run(const MeshArguments& arguments);
ExitCode run(const VerifyArguments& arguments);
ExitCode run(const InfoArguments& arguments);

}  // namespace delref::program
