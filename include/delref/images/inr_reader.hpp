// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads INR images (Inrimage-4, of INRIA; .inr), compressed by gzip or not: a header of lines KEY=VALUE, then the values. The place is
// that of CGAL's images: voxel (0, 0, 0) is at TX, TY, TZ, and spacings are VX, VY, VZ.
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/images/gzip.hpp>
#include <delref/images/image_fields.hpp>
#include <delref/images/voxel_values.hpp>

namespace delref {

namespace detail {

/// Gathers the fields of an INR header.
class InrHeader {
 public:
  explicit InrHeader(std::string_view text, const std::string& name) : name_(name) {
    const std::size_t length = text.size();
    if (take_line(text) != "#INRIMAGE-4#{") throw InvalidInput(fmt::format("{}: is no INR image: it does not begin with #INRIMAGE-4#{{", name));
    for (;;) {
      if (text.find('\n') == std::string_view::npos) {
        throw InvalidInput(fmt::format("{}: the header of the INR image has no end (##}}) in the first {} bytes", name, longest_image_header));
      }
      const std::string_view line = take_line(text);
      if (line.starts_with("##}")) break;
      if (line.starts_with('#') || trimmed(line).empty()) continue;
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos)
        throw InvalidInput(fmt::format("{}: the header's line \"{}\" is not of the form KEY=VALUE", name, shown(line)));
      read({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), &name});
    }
    header_.offset = length - text.size();
  }

  ImageHeader take() {
    if (header_.grid.size[0] < 1 || header_.grid.size[1] < 1 || header_.grid.size[2] < 1)
      throw InvalidInput(name_ + ": the header does not give XDIM, YDIM and ZDIM");
    if (kind_ == Kind::unknown || bits_ == 0) throw InvalidInput(name_ + ": the header does not give TYPE and PIXSIZE");
    header_.type = type();
    if (!order_known_ && bits_ > 8) throw InvalidInput(name_ + ": the header does not give CPU, on which the order of bytes depends");
    return std::move(header_);
  }

 private:
  enum class Kind : unsigned char { unknown, real, with_sign, without_sign };

  void read(const ImageField& field) {
    const auto axis = [&](std::string_view letters) { return letters.find(field.key.size() == 2 ? field.key[1] : field.key[0]); };
    if (field.key == "XDIM" || field.key == "YDIM" || field.key == "ZDIM") header_.grid.size[axis("XYZ")] = field.size();
    else if (field.key == "VX" || field.key == "VY" || field.key == "VZ") header_.grid.spacing[axis("XYZ")] = field.number();
    else if (field.key == "TX") header_.grid.origin.x = field.number();
    else if (field.key == "TY") header_.grid.origin.y = field.number();
    else if (field.key == "TZ") header_.grid.origin.z = field.number();
    else if (field.key == "RX" || field.key == "RY" || field.key == "RZ") read_rotation(field);
    else if (field.key == "VDIM") read_components(field);
    else if (field.key == "TYPE") read_type(field);
    else if (field.key == "PIXSIZE") read_bits(field);
    else if (field.key == "CPU") read_order(field);
    else if (field.key == "SCALE" && field.value != "2**0")
      header_.notes.push_back(fmt::format("{}: SCALE={} is not applied to the values", name_, shown(field.value)));
  }
  void read_rotation(const ImageField& field) const {
    if (field.number() != 0) field.fail("turned INR images are not supported: resample it on an upright grid, or use NIfTI");
  }
  void read_components(const ImageField& field) const {
    if (field.size() != 1) field.fail("images with several values per voxel (colours, vectors) are not supported: extract one");
  }
  void read_type(const ImageField& field) {
    if (field.value == "float") kind_ = Kind::real;
    else if (field.value == "signed fixed") kind_ = Kind::with_sign;
    else if (field.value == "unsigned fixed") kind_ = Kind::without_sign;
    else field.fail("known are float, signed fixed and unsigned fixed");
  }
  void read_bits(const ImageField& field) {
    const std::string_view number = field.value.ends_with("bits") ? trimmed(field.value.substr(0, field.value.size() - 4)) : field.value;
    bits_ = ImageField{field.key, number, &name_}.size();
    if (bits_ != 8 && bits_ != 16 && bits_ != 32 && bits_ != 64) field.fail("known are 8, 16, 32 and 64 bits");
  }
  void read_order(const ImageField& field) {
    order_known_ = true;
    if (field.value == "decm" || field.value == "alpha" || field.value == "pc") header_.order = std::endian::little;
    else if (field.value == "sun" || field.value == "sgi") header_.order = std::endian::big;
    else field.fail("known are decm, alpha, pc, sun and sgi");
  }
  VoxelType type() const {
    if (kind_ == Kind::real) {
      if (bits_ < 32) throw InvalidInput(fmt::format("{}: TYPE=float of {} bits is not known: 32 and 64 are", name_, bits_));
      return bits_ == 32 ? VoxelType::float32 : VoxelType::float64;
    }
    const bool sign = kind_ == Kind::with_sign;
    switch (bits_) {
      case 8: return sign ? VoxelType::int8 : VoxelType::uint8;
      case 16: return sign ? VoxelType::int16 : VoxelType::uint16;
      case 32: return sign ? VoxelType::int32 : VoxelType::uint32;
      default: return sign ? VoxelType::int64 : VoxelType::uint64;
    }
  }

  const std::string& name_;
  ImageHeader header_;
  Kind kind_ = Kind::unknown;
  int bits_ = 0;
  bool order_known_ = false;
};

}  // namespace detail

/// The image in the bytes of an .inr or .inr.gz file. `name` is what messages call it.
/// Throws `InvalidInput` in words, `Interrupted`.
inline ImageFile parse_inr(std::string_view bytes, const std::string& name, const Control& control = Control{}) {
  const std::string start = detail::first_bytes(bytes, detail::is_gzip(bytes), detail::longest_image_header, name, control);
  return detail::decode_image(detail::InrHeader(start, name).take(), bytes, name, control);
}

}  // namespace delref
