// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's readers behind a guard. They answer a broken file with "no", take the memory that a header announces, and know no stop;
// so each format's header here checks before the call what would harm, and this one says where a reader gave up, turns what it
// throws into words, and lets the control stop it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <istream>
#include <locale>
#include <new>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/exceptions.h>
#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref::detail {

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalVector = CGAL::Simple_cartesian<double>::Vector_3;

inline Point3 to_point(const CgalPoint& p) { return {p.x(), p.y(), p.z()}; }

/// A sequence that CGAL's readers fill. Whatever is put into it asks the control now and then: there is no other way to stop them.
template <class Value>
class WatchedSequence {
 public:
  using value_type = Value;
  using reference = Value&;
  using const_reference = const Value&;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using iterator = typename std::vector<Value>::iterator;
  using const_iterator = typename std::vector<Value>::const_iterator;

  explicit WatchedSequence(const Control& control) : stop_check_(control) {}

  iterator begin() { return values_.begin(); }
  iterator end() { return values_.end(); }
  const_iterator begin() const { return values_.begin(); }
  const_iterator end() const { return values_.end(); }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  void resize(std::size_t size) { values_.resize(size); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void push_back(const Value& value) {
    stop_check_();
    values_.push_back(value);
  }
  template <class... Arguments>
  Value& emplace_back(Arguments&&... arguments) {
    stop_check_();
    return values_.emplace_back(std::forward<Arguments>(arguments)...);
  }
  Value& back() { return values_.back(); }
  Value& operator[](std::size_t i) {
    stop_check_();
    return values_[i];
  }
  const Value& operator[](std::size_t i) const { return values_[i]; }

 private:
  std::vector<Value> values_;
  StopCheck stop_check_;
};

/// The text of a file as a stream's buffer that remembers where reading was when it was last sent back to the beginning: CGAL's reader
/// of .stl begins anew after a failure.
class FileBuffer final : public std::stringbuf {
 public:
  explicit FileBuffer(std::string text) : std::stringbuf(std::move(text), std::ios::in) {}

  std::size_t position() { return static_cast<std::size_t>(std::stringbuf::seekoff(0, std::ios::cur, std::ios::in)); }
  std::size_t position_before_return() const { return position_before_return_; }

 protected:
  pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode which) override {
    if (from == std::ios::beg) position_before_return_ = position();
    return std::stringbuf::seekoff(offset, from, which);
  }

 private:
  std::size_t position_before_return_ = 0;
};

/// The first line of a text, without the blanks around it and no longer than a message should be.
inline std::string printable(std::string_view text) {
  text = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
  text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
  std::string shown(text.substr(0, 60));
  for (char& c : shown) if (c < ' ' || c > '~') c = '?';
  return text.size() > shown.size() ? shown + "..." : shown;
}

/// How a reader ended.
struct ReaderEnd {
  bool good = false;
  /// The line in which it stopped, from 1; that of the failure when the reader began anew.
  std::size_t line = 1;
  /// What that line is, or begins with.
  std::string found;
  /// Something other than blanks comes after what it has read.
  bool more_follows = false;
};

/// CGAL reads numbers as the program's locale writes them.
inline void check_locale(const std::string& name) {
  if (std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == '.') return;
  throw InvalidInput(fmt::format("{}: cannot be read while the program's locale has another decimal sign than the point; set "
                                 "std::locale::global(std::locale::classic())", name));
}

/// Calls `read(std::istream&)`, a reader of CGAL, on the text of a file. It may throw what stopping throws.
/// Throws `InvalidInput` where the reader throws, and when the program has set a locale in which CGAL would misread numbers.
template <class Read>
ReaderEnd call_cgal_reader(std::string text, const std::string& name, bool begins_anew, Read&& read) {
  check_locale(name);
  FileBuffer buffer(std::move(text));
  std::istream in(&buffer);
  ReaderEnd end;
  try {
    end.good = read(in);
  } catch (const CGAL::Failure_exception& error) {
    throw InvalidInput(fmt::format("{}: is broken in a way that CGAL's reader did not expect: {}", name, error.expression()));
  } catch (const std::bad_alloc&) {
    throw InvalidInput(fmt::format("{}: reading it takes more memory than there is", name));
  } catch (const std::length_error&) {
    throw InvalidInput(fmt::format("{}: has a list of a negative length", name));
  }
  const std::size_t stop = begins_anew ? buffer.position_before_return() : buffer.position();
  const std::string_view all = buffer.view(), before = all.substr(0, stop == 0 ? 0 : stop - 1);
  end.line += static_cast<std::size_t>(std::ranges::count(before, '\n'));
  end.found = printable(all.substr(before.rfind('\n') + 1));
  end.more_follows = all.find_first_not_of(std::string_view(" \t\r\n\f\v\0", 7), stop) != std::string_view::npos;
  return end;
}

/// Puts spaces in the place of a part of the text; scanners of it stay valid.
inline void blank_out(std::string& text, std::size_t begin, std::size_t end) { std::ranges::fill(std::span(text).subspan(begin, end - begin), ' '); }

/// Comments (from `#` to the end of the line) and every kind of blank but the line's end become spaces, the one blank that all of
/// CGAL's readers know.
inline void blank_comments(std::string& text) {
  bool comment = false;
  for (char& c : text) {
    comment = c != '\n' && (comment || c == '#');
    if (comment || c == '\t' || c == '\r' || c == '\f' || c == '\v') c = ' ';
  }
}

/// The text of the scanner's line from its cursor on.
inline std::string_view line_ahead(const TextScanner& in, std::string_view text) {
  text.remove_prefix(text.size() - in.bytes_left());
  return text.substr(0, text.find('\n'));
}

/// To the scanner a comma is a blank, to CGAL the end of a line's numbers; and it may be meant for a decimal point.
inline void refuse_commas(std::string_view text, const std::string& name, std::size_t begin = 0, std::size_t end = std::string_view::npos) {
  const std::size_t at = text.substr(0, end).find(',', begin);
  if (at == std::string_view::npos) return;
  throw InvalidInput(fmt::format("{}, line {}: there is a comma; numbers are separated by blanks and have a decimal point", name,
                                 1 + std::ranges::count(text.substr(0, at), '\n')));
}

inline void check_finite(Point3 p, std::size_t id, const std::string& name, std::string_view what) {
  if (is_finite(p)) return;
  throw InvalidInput(fmt::format("{}: {} {} is ({}, {}, {}); every coordinate must be a finite number", name, what, id, p.x, p.y, p.z));
}

}  // namespace delref::detail
