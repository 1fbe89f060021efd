// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fast way to write numbers as text. Doubles are written with the fewest digits from which the same double is read again, the
// same on every machine and in every locale.
#pragma once

#include <concepts>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/compile.h>
#include <fmt/format.h>

namespace delref {

/// Gathers text and hands it on in pieces of about 256 KiB. Call `flush` at the end. Whatever `put` throws passes through.
class TextSink {
 public:
  explicit TextSink(std::function<void(std::string_view)> put)
      : put_(std::move(put)), buffer_(std::make_unique<char[]>(capacity)) {}

  TextSink& operator<<(std::string_view text) {
    if (text.size() > capacity) {
      flush();
      put_(text);
      return *this;
    }
    make_room(text.size());
    std::memcpy(buffer_.get() + size_, text.data(), text.size());
    size_ += text.size();
    return *this;
  }
  TextSink& operator<<(const char* text) { return *this << std::string_view(text); }
  TextSink& operator<<(char c) {
    make_room(1);
    buffer_[size_++] = c;
    return *this;
  }
  template <std::integral Integer>
  TextSink& operator<<(Integer value) {
    make_room(longest_number);
    size_ = offset_after(fmt::format_to(buffer_.get() + size_, FMT_COMPILE("{}"), value));
    return *this;
  }
  /// The shortest digits that read back as the same double; `nan`, `inf` and `-inf` for what has no digits.
  TextSink& operator<<(double value) {
    make_room(longest_number);
    size_ = offset_after(fmt::format_to(buffer_.get() + size_, FMT_COMPILE("{}"), value));
    return *this;
  }

  /// Hands on what is gathered.
  void flush() {
    if (size_ != 0) put_(std::string_view(buffer_.get(), std::exchange(size_, 0)));
  }

 private:
  static constexpr std::size_t capacity = std::size_t{1} << 18;
  static constexpr std::size_t longest_number = 64;

  void make_room(std::size_t count) {
    if (capacity - size_ < count) flush();
  }
  std::size_t offset_after(const char* end) const { return static_cast<std::size_t>(end - buffer_.get()); }

  std::function<void(std::string_view)> put_;
  std::unique_ptr<char[]> buffer_;
  std::size_t size_ = 0;
};

}  // namespace delref
