// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads NIfTI images, version 1 and 2, as one file (.nii) or two (.hdr and .img), and Analyze 7.5 (.hdr and .img), compressed by gzip or
// not. libnifti gives the layout of the header, its byte order and the places of voxels; it reads no file, and only headers that were
// checked before reach it, for it can print.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nifti2_io.h>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/images/gzip.hpp>
#include <delref/images/voxel_values.hpp>
#include <delref/io/binary_numbers.hpp>

namespace delref {

namespace detail {

struct FreeNifti {
  void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using NiftiImage = std::unique_ptr<nifti_image, FreeNifti>;

/// Which of the formats a header is of.
enum class NiftiKind : unsigned char { analyze, one_file, two_files };

/// Reads the header of any of the formats.
class NiftiHeader {
 public:
  NiftiHeader(std::string_view bytes, const std::string& name) : name_(name) {
    constexpr std::endian other_order = std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
    const bool has_size = bytes.size() >= sizeof(std::int32_t);
    const char* const first = bytes.data();
    const auto size = has_size ? number_from_bytes<std::int32_t>(first, std::endian::native) : 0;
    const auto other = has_size ? number_from_bytes<std::int32_t>(first, other_order) : 0;
    constexpr std::int32_t first_version = 348, second_version = 540;
    if (size == first_version || other == first_version) read_first(bytes, size != first_version);
    else if (size == second_version || other == second_version) read_second(bytes, size != second_version);
    else throw InvalidInput(fmt::format("{}: is no NIfTI or Analyze image: its header does not begin with its length, 348 or 540", name));
  }

  NiftiKind kind() const { return kind_; }
  ImageHeader take() { return std::move(out_); }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw InvalidInput(name_ + ": " + why); }

  template <class Header>
  Header header_of(std::string_view bytes) const {
    if (bytes.size() < sizeof(Header)) fail(fmt::format("the file ends within the header: {} of {} bytes", bytes.size(), sizeof(Header)));
    std::array<char, sizeof(Header)> copy{};
    std::ranges::copy(bytes.substr(0, copy.size()), copy.begin());
    return std::bit_cast<Header>(copy);
  }

  void read_first(std::string_view bytes, bool swapped) {
    auto header = header_of<nifti_1_header>(bytes);
    const std::string_view magic(header.magic, 3);
    const bool is_nifti = header.magic[3] == '\0' && (magic == "n+1" || magic == "ni1");
    kind_ = !is_nifti ? NiftiKind::analyze : magic == "n+1" ? NiftiKind::one_file : NiftiKind::two_files;
    if (swapped) swap_nifti_header(&header, kind_ == NiftiKind::analyze ? 0 : 1);
    if (kind_ == NiftiKind::analyze) header.scl_slope = 0, header.scl_inter = 0;
    check(header, swapped);
    place(header, NiftiImage(nifti_convert_n1hdr2nim(header, nullptr)));
  }
  void read_second(std::string_view bytes, bool swapped) {
    auto header = header_of<nifti_2_header>(bytes);
    const std::string_view magic(header.magic, 3);
    if (magic != "n+2" && magic != "ni2") fail("the header has the length of NIfTI-2 but not its mark (n+2 or ni2)");
    kind_ = magic == "n+2" ? NiftiKind::one_file : NiftiKind::two_files;
    if (swapped) swap_nifti_header(&header, 2);
    check(header, swapped);
    place(header, NiftiImage(nifti_convert_n2hdr2nim(header, nullptr)));
  }

  template <class Header>
  void check(const Header& header, bool swapped) {
    out_.order = swapped ? (std::endian::native == std::endian::little ? std::endian::big : std::endian::little) : std::endian::native;
    if (!(header.dim[0] >= 1 && header.dim[0] <= 7)) fail(fmt::format("the header says that the image has {} dimensions", header.dim[0]));
    for (std::size_t i = 1; i != 4; ++i) {
      const auto size = static_cast<std::int64_t>(header.dim[i]);
      if (static_cast<std::int64_t>(header.dim[0]) < static_cast<std::int64_t>(i)) out_.grid.size[i - 1] = 1;
      else if (size < 1 || size > longest_image_axis) fail(fmt::format("the header says that there are {} voxels along axis {}", size, i));
      else out_.grid.size[i - 1] = static_cast<int>(size);
    }
    for (std::size_t i = 4; i != 8; ++i) {
      if (static_cast<std::int64_t>(header.dim[0]) < static_cast<std::int64_t>(i) || header.dim[i] <= 1) continue;
      fail(fmt::format("the image has {} volumes or components along axis {}; extract one", header.dim[i], i));
    }
    for (std::size_t i = 1; i != 4; ++i) check_spacing(static_cast<double>(header.pixdim[i]), i);
    read_type(header.datatype, header.bitpix);
    read_offset(static_cast<double>(header.vox_offset), sizeof header);
    const auto slope = static_cast<double>(header.scl_slope), intercept = static_cast<double>(header.scl_inter);
    if (slope != 0) out_.slope = slope, out_.intercept = intercept;
  }

  void check_spacing(double spacing, std::size_t axis) {
    out_.grid.spacing[axis - 1] = std::abs(spacing);
    if (spacing == 0 || !std::isfinite(spacing))
      fail(fmt::format("the header says that the voxels' spacing along axis {} is {}", axis, describe(spacing)));
    if (spacing < 0)
      out_.notes.push_back(
          fmt::format("{}: the spacing along axis {} is negative, {}; its sign is not used", name_, axis, describe(spacing)));
  }

  void read_type(int code, int bits) {
    switch (code) {
      case DT_UINT8: out_.type = VoxelType::uint8; break;
      case DT_INT8: out_.type = VoxelType::int8; break;
      case DT_INT16: out_.type = VoxelType::int16; break;
      case DT_UINT16: out_.type = VoxelType::uint16; break;
      case DT_INT32: out_.type = VoxelType::int32; break;
      case DT_UINT32: out_.type = VoxelType::uint32; break;
      case DT_INT64: out_.type = VoxelType::int64; break;
      case DT_UINT64: out_.type = VoxelType::uint64; break;
      case DT_FLOAT32: out_.type = VoxelType::float32; break;
      case DT_FLOAT64: out_.type = VoxelType::float64; break;
      case DT_RGB24: case DT_RGBA32: fail("colour images are not supported: extract one value per voxel");
      case DT_COMPLEX64:
      case DT_COMPLEX128:
      case DT_COMPLEX256:
        fail("images of complex numbers are not supported: extract one value per voxel");
      case DT_FLOAT128: fail("values of 128 bits are not supported: convert the image to another type");
      default: fail(fmt::format("the header's type of values, {}, is not known", code));
    }
    if (bits != static_cast<int>(8 * bytes_of(out_.type)))
      fail(fmt::format("the header says {} bits per voxel, but its type of values, {}, has {}", bits, code,
                       8 * bytes_of(out_.type)));
  }

  void read_offset(double offset, std::size_t header) {
    if (kind_ == NiftiKind::one_file && offset == 0) offset = static_cast<double>(header + 4);
    const double least = kind_ == NiftiKind::one_file ? static_cast<double>(header) : 0;
    if (!(offset >= least && offset <= 2147483647.0 && std::floor(offset) == offset)) {
      fail(fmt::format("the header says that the values begin at byte {}", describe(offset)));
    }
    out_.offset = static_cast<std::size_t>(offset);
  }

  /// Takes the rigid placement where the general one is sheared.
  template <class Header>
  void place(const Header& header, const NiftiImage& image) {
    if (!image) fail("libnifti does not take the header");
    const ImageGrid plain = out_.grid;
    if (kind_ == NiftiKind::analyze) return;
    check_placement(header);
    if (header.sform_code > 0) {
      place_by(image->sto_xyz.m);
      if (is_good(out_.grid) || header.qform_code <= 0) return;
      out_.notes.push_back(name_ + ": the general placement (sform) is no grid at right angles; the rigid one (qform) is used");
      out_.grid = plain;
    }
    if (header.qform_code > 0) place_by(image->qto_xyz.m);
  }
  /// libnifti takes what is no number for 0.
  template <class Header>
  void check_placement(const Header& header) const {
    const auto finite = [](auto... numbers) { return (std::isfinite(numbers) && ...); };
    bool good = header.qform_code <= 0 || finite(header.quatern_b, header.quatern_c, header.quatern_d, header.qoffset_x,
                                                 header.qoffset_y, header.qoffset_z);
    for (std::size_t i = 0; i != 4; ++i) good = good && (header.sform_code <= 0 || finite(header.srow_x[i], header.srow_y[i], header.srow_z[i]));
    if (!good) fail("the header's placement of the image has entries that are not numbers");
  }
  static bool is_good(const ImageGrid& grid) {
    try {
      check_grid(grid);
      return true;
    } catch (const InvalidInput&) {
      return false;
    }
  }
  template <class Matrix>
  void place_by(const Matrix& m) {
    for (std::size_t j = 0; j != 3; ++j) {
      const Vector3 column{m[0][j], m[1][j], m[2][j]};
      const double length = std::sqrt(squared_length(column));
      out_.grid.spacing[j] = length;
      out_.grid.axes[j] = (1 / length) * column;
    }
    out_.grid.origin = {m[0][3], m[1][3], m[2][3]};
  }

  const std::string& name_;
  NiftiKind kind_ = NiftiKind::analyze;
  ImageHeader out_;
};

inline NiftiHeader nifti_header(std::string_view bytes, const std::string& name, const Control& control) {
  nifti_set_debug_level(0);
  return {first_bytes(bytes, is_gzip(bytes), sizeof(nifti_2_header), name, control), name};
}

}  // namespace detail

/// The image in the bytes of a .nii or .nii.gz file. `name` is what messages call it. Throws `InvalidInput` in words, `Interrupted`.
inline ImageFile parse_nifti(std::string_view bytes, const std::string& name, const Control& control = Control{}) {
  detail::NiftiHeader header = detail::nifti_header(bytes, name, control);
  if (header.kind() != detail::NiftiKind::one_file)
    throw InvalidInput(name + ": its header is one of two files; give the .hdr file, beside which the .img file stands");
  return detail::decode_image(header.take(), bytes, name, control);
}

/// The image in the bytes of a .hdr file and of its .img file, each compressed by gzip or not.
inline ImageFile parse_nifti_pair(std::string_view header_bytes, std::string_view values, const std::string& name,
                                  const Control& control = Control{}) {
  detail::NiftiHeader header = detail::nifti_header(header_bytes, name, control);
  if (header.kind() == detail::NiftiKind::one_file) return parse_nifti(header_bytes, name, control);
  return detail::decode_image(header.take(), values, name, control);
}

}  // namespace delref
