// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bytes that may be compressed by gzip (RFC 1952), through zlib, and never more of them than asked for: a small file can hold terabytes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <zlib.h>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref::detail {

inline bool is_gzip(std::string_view bytes) { return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

/// An inflater that is ended however one leaves.
class Inflater {
 public:
  Inflater() { ready_ = inflateInit2(&stream_, 15 + 32) == Z_OK; }  // gzip or zlib, told by the header
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() {
    if (ready_) inflateEnd(&stream_);
  }
  bool ready() const { return ready_; }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
  bool ready_ = false;
};

/// At most the first `most` bytes of what `bytes`, compressed by gzip or zlib, hold; fewer when that is all.
/// Throws `InvalidInput` when they are damaged or cut off before that, `Interrupted`.
inline std::string inflated(std::string_view bytes, std::size_t most, const std::string& name, const Control& control) {
  constexpr std::size_t chunk = std::size_t{1} << 20;
  Inflater inflater;
  if (!inflater.ready()) throw InvalidInput(fmt::format("{}: zlib cannot be started to decompress it", name));
  z_stream& stream = inflater.stream();
  std::string out;
  std::size_t used = 0;
  while (out.size() < most) {
    throw_if_stopped(control);
    const std::size_t had = out.size(), room = std::min(chunk, most - had), given = std::min(chunk, bytes.size() - used);
    out.resize(had + room);
    // zlib does not write to what it reads; its type is older than const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + used));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef*>(out.data() + had);
    stream.avail_out = static_cast<uInt>(room);
    const int state = inflate(&stream, Z_NO_FLUSH);
    used += given - stream.avail_in;
    out.resize(had + (room - stream.avail_out));
    if (state == Z_STREAM_END) {
      // Several compressed pieces one after the other count as one.
      if (!is_gzip(bytes.substr(used)) || inflateReset(&stream) != Z_OK) break;
    } else if (state == Z_BUF_ERROR || (state == Z_OK && used == bytes.size() && out.size() == had)) {
      throw InvalidInput(fmt::format("{}: the compressed data end too early, after {} bytes: the file is cut off", name, bytes.size()));
    } else if (state != Z_OK) {
      throw InvalidInput(fmt::format("{}: the compressed data are damaged after byte {}: {}", name, used,
                                     stream.msg != nullptr ? stream.msg : "no gzip"));
    }
  }
  return out;
}

/// The first `most` bytes of a file that is compressed or not; fewer when there are no more.
inline std::string first_bytes(std::string_view bytes, bool compressed, std::size_t most, const std::string& name, const Control& control) {
  return compressed ? inflated(bytes, most, name, control) : std::string(bytes.substr(0, most));
}

}  // namespace delref::detail
