// SPDX-License-Identifier: GPL-3.0-or-later
//
// How messages spell numbers, points and lists of places: shortest digits that read back as the same double, and never more
// examples than a person reads.
#pragma once

#include <charconv>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref {

/// The shortest decimal digits that read back as `number`.
inline std::string describe(double number) {
  char digits[40];
  const auto result = std::to_chars(digits, digits + sizeof digits, number);
  return {digits, result.ptr};
}

/// "(x, y)".
inline std::string describe(Point2 p) { return '(' + describe(p.x) + ", " + describe(p.y) + ')'; }
/// "(x, y, z)".
inline std::string describe(Point3 p) { return '(' + describe(p.x) + ", " + describe(p.y) + ", " + describe(p.z) + ')'; }

/// "1 vertex", "2 vertices".
inline std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// Defects as they are found: the first ones are kept, the others counted, so that a file with a million defects gives a
/// message that can be read.
class DefectList {
 public:
  static constexpr std::size_t spelled_out = 20;

  /// True when the next defect would only be counted: its message need not be made.
  bool full() const { return defects_.size() >= spelled_out; }
  bool empty() const { return defects_.empty(); }

  void add(std::string message, std::vector<Point2> places = {}) {
    if (full())
      ++more_;
    else
      defects_.push_back({std::move(message), std::move(places)});
  }

  /// The defects; the last one says how many more there are. `qualifier` is put before that number ("at least ").
  std::vector<Defect> take(const std::string& qualifier = "") {
    if (more_ > 0) {
      defects_.push_back({"and " + qualifier + std::to_string(more_) + " more of this kind", {}});
      more_ = 0;
    }
    return std::exchange(defects_, {});
  }

 private:
  std::vector<Defect> defects_;
  std::size_t more_ = 0;
};

/// The first few examples of something told in a note, and how many there are.
class ExampleList {
 public:
  static constexpr std::size_t spelled_out = 5;

  std::size_t count() const { return count_; }
  bool full() const { return count_ >= spelled_out; }
  void add(const std::string& example) {
    if (!full()) text_ += (text_.empty() ? "" : "; ") + example;
    ++count_;
  }
  /// Counts one more of which no example is wanted.
  void add() { ++count_; }
  /// "a; b; c; and 7 more".
  std::string text() const {
    return count_ > spelled_out ? text_ + "; and " + std::to_string(count_ - spelled_out) + " more" : text_;
  }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

}  // namespace delref
