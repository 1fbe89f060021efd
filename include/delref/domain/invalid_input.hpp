// SPDX-License-Identifier: GPL-3.0-or-later
//
// How input is refused: every defect with the elements it concerns, their coordinates, and what to do about it.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include <delref/core/point.hpp>

namespace delref {

/// One thing that is wrong with an input.
struct Defect {
  /// A sentence for a person: which elements (numbered as in the file), where, what to do.
  std::string message;
  /// Where it is, when that can be said.
  std::vector<Point2> places;
};

/// Thrown before meshing when the input cannot be meshed. `what()` is all messages, a line each.
class InvalidInput : public std::exception {
 public:
  explicit InvalidInput(std::vector<Defect> defects) : defects_(std::move(defects)) {
    for (const Defect& d : defects_) text_ += (text_.empty() ? "" : "\n") + d.message;
  }
  explicit InvalidInput(std::string message) : InvalidInput(std::vector<Defect>{{std::move(message), {}}}) {}

  const char* what() const noexcept override { return text_.c_str(); }
  const std::vector<Defect>& defects() const { return defects_; }

 private:
  std::vector<Defect> defects_;
  std::string text_;
};

}  // namespace delref
