// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reader of polyhedral domains gives.
#pragma once

#include <string>
#include <vector>

#include <delref/domain/plc.hpp>

namespace delref {

/// What a file of a polyhedral domain holds.
struct PlcFile {
  Plc plc;
  /// For people: what was passed over.
  std::vector<std::string> notes;
};

}  // namespace delref
