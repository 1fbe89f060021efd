// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads NRRD images (.nrrd, .nhdr; teem's format, versions 1 to 5): a header of lines "field: value", an empty line, and the values, or
// the name of a file beside it that holds them. Scalars of three dimensions, raw or compressed by gzip.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/images/image_fields.hpp>
#include <delref/images/voxel_values.hpp>

namespace delref {

namespace detail {

/// A header whose values stand after it, or in another file.
struct DetachableHeader {
  ImageHeader header;
  /// The file of the values, beside that of the header; empty when they follow the header at byte `values`.
  std::string values_file;
  std::size_t values = 0;
};

/// Throws unless the name of a file of values is one of a file beside the header: whoever wrote a header shall not choose among all files.
inline std::string checked_values_file(const ImageField& field) {
  const std::string name(field.value);
  if (name.empty() || name.find_first_of("/\\") != std::string::npos || name == ".." || name.find('%') != std::string::npos ||
      name.starts_with("LIST")) {
    field.fail("the values must be in one file that stands beside the header, named without folders");
  }
  return name;
}

/// Gathers the fields of a NRRD header.
class NrrdHeader {
 public:
  NrrdHeader(std::string_view text, const std::string& name) : name_(name) {
    const std::string_view all = text.substr(0, longest_image_header);
    std::string_view left = all;
    const std::string_view magic = take_line(left);
    if (!magic.starts_with("NRRD000") || magic.size() != 8 || magic[7] < '1' || magic[7] > '5')
      throw InvalidInput(name + ": is no NRRD image: it does not begin with NRRD0001 to NRRD0005");
    while (!left.empty()) {
      const std::string_view line = take_line(left);
      if (line.empty()) break;
      const std::size_t colon = line.find(':');
      if (line[0] == '#' || line.substr(std::min(colon, line.size())).starts_with(":=")) continue;
      if (colon == std::string_view::npos)
        throw InvalidInput(fmt::format("{}: the header's line \"{}\" is not of the form FIELD: VALUE", name, shown(line)));
      read({trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)), &name});
    }
    out_.values = all.size() - left.size();
  }

  DetachableHeader take() {
    ImageHeader& header = out_.header;
    if (!has_dimension_ || !has_sizes_ || !has_type_ || !header.compressed)
      throw InvalidInput(name_ + ": the header must give dimension, sizes, type and encoding");
    if (!has_order_ && bytes_of(header.type) > 1) throw InvalidInput(name_ + ": the header does not give endian, the order of bytes");
    return std::move(out_);
  }

 private:
  void read(const ImageField& field) {
    ImageHeader& header = out_.header;
    const std::string_view key = field.key;
    if (key == "dimension") {
      has_dimension_ = true;
      if (field.size() != 3) field.fail("images of three dimensions with one value per voxel are supported: extract one");
    } else if (key == "sizes") {
      has_sizes_ = true;
      const auto sizes = field.sizes(3);
      header.grid.size = {sizes[0], sizes[1], sizes[2]};
    } else if (key == "type") {
      read_type(field);
    } else if (key == "encoding") {
      if (field.value != "raw" && field.value != "gzip" && field.value != "gz") field.fail("known are raw and gzip");
      header.compressed = field.value != "raw";
    } else if (key == "endian") {
      has_order_ = true;
      if (field.value != "little" && field.value != "big") field.fail("known are little and big");
      header.order = field.value == "little" ? std::endian::little : std::endian::big;
    } else if (key == "spacings") {
      const auto spacings = field.numbers(3);
      header.grid.spacing = {spacings[0], spacings[1], spacings[2]};
    } else if (key == "space directions") {
      read_directions(field);
    } else if (key == "space origin") {
      const auto origin = field.numbers(3);
      header.grid.origin = {origin[0], origin[1], origin[2]};
    } else if (key == "space dimension") {
      if (field.size() != 3) field.fail("only images in space are supported");
    } else if (key == "data file" || key == "datafile") {
      out_.values_file = checked_values_file(field);
    } else if (key == "line skip" || key == "lineskip" || key == "byte skip" || key == "byteskip") {
      if (field.number() != 0) field.fail("skipping is not supported");
    } else if (key == "axis mins" || key == "axismins" || key == "axis maxs" || key == "axismaxs") {
      header.notes.push_back(fmt::format("{}: \"{}\" is not used; the place of the image is given by space origin", name_, shown(key)));
    }
  }

  void read_directions(const ImageField& field) {
    const auto m = field.numbers(9);
    for (std::size_t i = 0; i != 3; ++i) {
      const Vector3 v{m[3 * i], m[3 * i + 1], m[3 * i + 2]};
      out_.header.grid.spacing[i] = std::sqrt(squared_length(v));
      out_.header.grid.axes[i] = (1 / out_.header.grid.spacing[i]) * v;
    }
  }

  void read_type(const ImageField& field) {
    has_type_ = true;
    struct Names {
      std::string_view all;
      VoxelType type;
    };
    static constexpr std::array types{
        Names{"|signed char|int8|int8_t|", VoxelType::int8},
        Names{"|unsigned char|uchar|uint8|uint8_t|", VoxelType::uint8},
        Names{"|short|short int|signed short|signed short int|int16|int16_t|", VoxelType::int16},
        Names{"|unsigned short|ushort|unsigned short int|uint16|uint16_t|", VoxelType::uint16},
        Names{"|int|signed int|int32|int32_t|", VoxelType::int32},
        Names{"|unsigned int|uint|uint32|uint32_t|", VoxelType::uint32},
        Names{"|long long|longlong|long long int|signed long long|signed long long int|int64|int64_t|", VoxelType::int64},
        Names{"|unsigned long long|ulonglong|unsigned long long int|uint64|uint64_t|", VoxelType::uint64},
        Names{"|float|", VoxelType::float32},
        Names{"|double|", VoxelType::float64}};
    for (const Names& names : types) {
      if (names.all.find(fmt::format("|{}|", field.value)) != std::string_view::npos) return void(out_.header.type = names.type);
    }
    field.fail("that is no type of values that is known");
  }

  const std::string& name_;
  DetachableHeader out_;
  bool has_dimension_ = false, has_sizes_ = false, has_type_ = false, has_order_ = false;
};

}  // namespace detail

/// The image in the bytes of a .nrrd file, or of an .nhdr file of which `values_of(name)` gives the bytes of the file that it names.
/// `name` is what messages call it. Throws `InvalidInput` in words, `Interrupted`.
template <class ValuesOf>
ImageFile parse_nrrd(std::string_view bytes, ValuesOf&& values_of, const std::string& name, const Control& control = Control{}) {
  detail::DetachableHeader found = detail::NrrdHeader(bytes, name).take();
  if (found.values_file.empty()) return detail::decode_image(std::move(found.header), bytes.substr(found.values), name, control);
  const std::string values = values_of(found.values_file);
  return detail::decode_image(std::move(found.header), values, name, control);
}

}  // namespace delref
