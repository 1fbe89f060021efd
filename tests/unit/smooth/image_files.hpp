// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bytes of image files, made by hand.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <zlib.h>

#include <nifti1.h>
#include <nifti2.h>

namespace delref_test {

/// The bytes of numbers, in the order asked for.
template <class Number>
std::string bytes_of(const std::vector<Number>& numbers, std::endian order = std::endian::native) {
  std::string out;
  for (const Number n : numbers) {
    std::string bytes(sizeof n, '\0');
    std::memcpy(bytes.data(), &n, sizeof n);
    if (order != std::endian::native) bytes = std::string(bytes.rbegin(), bytes.rend());
    out += bytes;
  }
  return out;
}

/// `window`: 15 + 16 for gzip, 15 for zlib.
inline std::string deflated(const std::string& bytes, int window = 15 + 16) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY);
  std::string out(bytes.size() + bytes.size() / 100 + 1000, '\0'), in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// An INR file of 4 x 3 x 2 voxels; `fields` are lines that come before the end of the header and may say otherwise.
inline std::string inr(const std::string& type, const std::string& values, const std::string& fields = "") {
  std::string header = "#INRIMAGE-4#{\nXDIM=4\nYDIM=3\nZDIM=2\nVDIM=1\nTYPE=" + type + "\nCPU=decm\nVX=0.5\nVY=1\nVZ=2\n" + fields;
  header += std::string(252 - header.size() % 256, '\n') + "##}\n";
  return header + values;
}

/// The header of a NIfTI image of 4 x 3 x 2 voxels of 16 bits in one file.
inline nifti_1_header nifti_header() {
  nifti_1_header h{};
  h.sizeof_hdr = 348;
  h.dim[0] = 3, h.dim[1] = 4, h.dim[2] = 3, h.dim[3] = 2;
  h.datatype = DT_INT16, h.bitpix = 16;
  h.pixdim[0] = 1, h.pixdim[1] = 0.5F, h.pixdim[2] = 1, h.pixdim[3] = 2;
  h.vox_offset = 352;
  std::memcpy(h.magic, "n+1", 4);
  return h;
}

template <class Header>
std::string nifti(const Header& header, const std::string& values, std::size_t gap = 4) {
  std::string out(sizeof header, '\0');
  std::memcpy(out.data(), &header, sizeof header);
  return out + std::string(gap, '\0') + values;
}

}  // namespace delref_test
