// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of a name and a value, as the summary of a run has them.
#pragma once

#include <string>

#include <fmt/format.h>

namespace delref::program {

class Rows {
 public:
  void add(const char* name, const std::string& value) { text_ += fmt::format("{:<16}{}\n", name, value); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace delref::program
