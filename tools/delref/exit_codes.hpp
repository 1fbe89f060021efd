// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the program's exit code tells a script. The same list is in the help of the program and in docs.
#pragma once

#include <stdexcept>

namespace delref::program {

enum class ExitCode : int {
  ok = 0,                   ///< all is as asked; with `mesh`, triangles that small input angles force are no failure
  internal = 1,             ///< an output cannot be written, memory ran out, or delref has a bug
  usage = 2,                ///< the command line cannot be understood
  invalid_input = 3,        ///< a file cannot be read, or what it holds cannot be meshed
  unmet = 4,                ///< the mesh is valid and written, but a criterion is unmet or a budget was reached
  interrupted = 5,          ///< a signal stopped the run; the valid mesh reached so far is written
  verification_failed = 6,  ///< the mesh is not what was promised
};

/// Thrown when the command line asks for something that cannot be; `what()` says so in words.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace delref::program
