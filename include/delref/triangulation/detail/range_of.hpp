// SPDX-License-Identifier: GPL-3.0-or-later
//
// A range of delref's handles over a pair of CGAL's iterators. Its operators are members and hidden friends, so that a program that
// only imports the module can iterate it and pipe it into standard views.
#pragma once

#include <cstddef>
#include <iterator>
#include <ranges>

namespace delref::detail {

/// Iterates `Handle`s made of those iterators of `Base` that satisfy `Keep`.
template <class Handle, class Base, class Keep>
class HandleIterator {
 public:
  using value_type = Handle;
  using difference_type = std::ptrdiff_t;

  HandleIterator() = default;
  HandleIterator(Base at, Base end) : at_(at), end_(end) { skip(); }

  Handle operator*() const { return Handle{at_}; }
  HandleIterator& operator++() {
    ++at_;
    skip();
    return *this;
  }
  HandleIterator operator++(int) {
    HandleIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const HandleIterator& a, const HandleIterator& b) { return a.at_ == b.at_; }

 private:
  void skip() {
    while (!(at_ == end_) && !Keep{}(at_)) ++at_;
  }
  Base at_{}, end_{};
};

template <class Iterator>
class HandleRange : public std::ranges::view_base {
 public:
  HandleRange() = default;
  HandleRange(Iterator begin, Iterator end) : begin_(begin), end_(end) {}
  Iterator begin() const { return begin_; }
  Iterator end() const { return end_; }

 private:
  Iterator begin_, end_;
};

template <class Handle, class Base, class Keep>
auto range_of(Base begin, Base end, Keep) {
  using Iterator = HandleIterator<Handle, Base, Keep>;
  return HandleRange<Iterator>(Iterator(begin, end), Iterator(end, end));
}

}  // namespace delref::detail
