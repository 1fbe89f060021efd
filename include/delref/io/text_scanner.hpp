// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers and words out of text in memory and knows the line it is on, so that every complaint names file and line and
// says what was expected and what was found. The readers of Triangle's files, .msh and .vtu stand on it.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <delref/domain/invalid_input.hpp>

namespace delref {

/// A cursor over text. All failures are thrown as `InvalidInput`.
class TextScanner {
 public:
  /// `lines`: a record is a line, `#` starts a comment, a comma is a blank (Triangle). `free`: lines mean nothing.
  enum class Layout { lines, free };

  /// The text must outlive the scanner; `name` is what complaints call the file.
  TextScanner(std::string_view text, std::string name, Layout layout) : text_(text), name_(std::move(name)), layout_(layout) {}

  /// Layout `lines`: goes to the next line that holds a field. False when there is none.
  bool next_line() {
    if (started_) skip_rest_of_line();
    started_ = true;
    while (position_ < text_.size()) {
      skip_blanks();
      if (position_ < text_.size() && !at_line_end()) return true;
      skip_rest_of_line();
    }
    return false;
  }
  /// The same; complains that the file ends before `what` when there is no such line.
  void need_line(std::string_view what, std::size_t id = no_id) {
    if (!next_line()) fail(fmt::format("the file ends where {} was expected", named(what, id)));
  }
  /// There is another field (on this line, in layout `lines`).
  bool has_field() {
    skip_blanks();
    return position_ < text_.size() && !(layout_ == Layout::lines && at_line_end());
  }

  /// There is another field, and it starts like a number.
  bool at_number() {
    return has_field() && std::string_view("0123456789+-.").find(text_[position_]) != std::string_view::npos;
  }

  /// The next field, if there is one, is this word.
  bool at_word(std::string_view word) { return has_field() && peek(word, no_id) == word; }

  /// The next field as a number; `nan` and `inf` are numbers here. `what` and `id` name it in complaints.
  double number(std::string_view what, std::size_t id = no_id) {
    const std::string_view field = peek(what, id);
    double value = 0;
    const auto [end, error] = std::from_chars(digits(field), field.data() + field.size(), value);
    if (error == std::errc::result_out_of_range) fail(fmt::format("{} is {}, which no double can hold", named(what, id), field));
    if (error != std::errc{} || end != field.data() + field.size()) expected("a number", what, id, field);
    position_ += field.size();
    return value;
  }
  /// The next field as an integer of the type asked for.
  template <class Integer>
  Integer integer(std::string_view what, std::size_t id = no_id) {
    const std::string_view field = peek(what, id);
    Integer value = 0;
    const auto [end, error] = std::from_chars(digits(field), field.data() + field.size(), value);
    const bool whole = end == field.data() + field.size();
    if (error == std::errc::result_out_of_range && whole) {
      fail(fmt::format("{} is {}, which is beyond {}", named(what, id), field, std::numeric_limits<Integer>::max()));
    }
    if (error != std::errc{} || !whole) {
      expected(std::numeric_limits<Integer>::is_signed ? "an integer" : "an integer that is not negative", what, id, field);
    }
    position_ += field.size();
    return value;
  }
  /// The number of records to come, each of at least `bytes_each` bytes: refused when what is left of the file cannot hold them.
  std::size_t count(std::string_view what, std::size_t bytes_each) {
    const auto value = integer<std::uint64_t>(what);
    check_room(value, bytes_each, what);
    return static_cast<std::size_t>(value);
  }
  void check_room(std::uint64_t records, std::size_t bytes_each, std::string_view what) const {
    if (records > (text_.size() - position_ + 2) / bytes_each) {
      fail(fmt::format("{} is {}, but only {} bytes follow", what, records, text_.size() - position_));
    }
    if (records >= std::numeric_limits<std::uint32_t>::max()) fail(fmt::format("{} is {}, which 32 bits cannot count", what, records));
  }
  /// The next field as it stands.
  std::string_view word(std::string_view what) {
    const std::string_view field = peek(what, no_id);
    position_ += field.size();
    return field;
  }
  /// The rest of this line, without the blanks around it; the cursor goes to the next line.
  std::string_view rest_of_line() {
    skip_inner_blanks();
    const std::size_t begin = position_;
    skip_rest_of_line();
    std::string_view rest = text_.substr(begin, position_ - begin);
    while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
    return rest;
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw InvalidInput(fmt::format("{}, line {}: {}", name_, line_, message));
  }
  const std::string& name() const { return name_; }
  std::size_t bytes_left() const { return text_.size() - position_; }

  static constexpr std::size_t no_id = std::numeric_limits<std::size_t>::max();

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }
  bool is_blank(char c) const { return (is_space(c) && c != '\n') || (c == ',' && layout_ == Layout::lines); }
  bool at_line_end() const { return text_[position_] == '\n' || text_[position_] == '#'; }
  static std::string named(std::string_view what, std::size_t id) {
    return id == no_id ? std::string(what) : fmt::format("{} {}", what, id);
  }
  /// from_chars takes no plus sign.
  static const char* digits(std::string_view field) {
    return field.data() + (field.size() > 1 && field[0] == '+' && field[1] != '-' ? 1 : 0);
  }
  void skip_inner_blanks() {
    while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  }
  void skip_blanks() {
    skip_inner_blanks();
    if (layout_ == Layout::lines) return;
    for (; position_ < text_.size() && is_space(text_[position_]); ++position_) line_ += text_[position_] == '\n';
  }
  void skip_rest_of_line() {
    const std::size_t end = text_.find('\n', position_);
    position_ = end == std::string_view::npos ? text_.size() : end + 1;
    line_ += end != std::string_view::npos;
  }
  /// The next field, which must be there.
  std::string_view peek(std::string_view what, std::size_t id) {
    if (!has_field()) {
      fail(fmt::format("the {} ends where {} was expected", layout_ == Layout::lines ? "line" : "file", named(what, id)));
    }
    std::size_t end = position_;
    while (end < text_.size() && !is_space(text_[end]) && !(layout_ == Layout::lines && (text_[end] == ',' || text_[end] == '#'))) {
      ++end;
    }
    return text_.substr(position_, end - position_);
  }
  [[noreturn]] void expected(std::string_view kind, std::string_view what, std::size_t id, std::string_view field) const {
    std::string shown;
    for (char c : field.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
    fail(fmt::format("expected {} for {}, found \"{}{}\"", kind, named(what, id), shown, field.size() > 40 ? "..." : ""));
  }

  std::string_view text_;
  std::string name_;
  Layout layout_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  bool started_ = false;
};

}  // namespace delref
