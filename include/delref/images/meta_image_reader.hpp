// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads MetaImages (.mha, .mhd; the format of ITK): a header of lines "Key = Value" of which ElementDataFile is the last, then the values,
// or the name of a file beside it that holds them. Scalars of three dimensions, raw or compressed by zlib.
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
#include <delref/domain/invalid_input.hpp>
#include <delref/images/image_fields.hpp>
#include <delref/images/nrrd_reader.hpp>
#include <delref/images/voxel_values.hpp>

namespace delref {

namespace detail {

/// Gathers the fields of a MetaImage header.
class MetaImageHeader {
 public:
  MetaImageHeader(std::string_view text, const std::string& name) : name_(name) {
    out_.header.order = std::endian::little;
    out_.header.compressed = false;
    const std::string_view all = text.substr(0, longest_image_header);
    std::string_view left = all;
    while (!has_values_) {
      if (left.empty())
        throw InvalidInput(
            fmt::format("{}: is no MetaImage, or its header is cut off: there is no ElementDataFile in the first {} bytes", name,
                        longest_image_header));
      const std::string_view line = take_line(left);
      if (trimmed(line).empty()) continue;
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos)
        throw InvalidInput(fmt::format("{}: the header's line \"{}\" is not of the form KEY = VALUE", name, shown(line)));
      read({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), &name});
    }
    out_.values = all.size() - left.size();
  }

  DetachableHeader take() {
    if (!has_dimension_ || !has_sizes_ || !has_type_) throw InvalidInput(name_ + ": the header must give NDims, DimSize and ElementType");
    return std::move(out_);
  }

 private:
  void read(const ImageField& field) {
    ImageHeader& header = out_.header;
    const std::string_view key = field.key;
    if (key == "ObjectType") {
      if (field.value != "Image") field.fail("only images are supported");
    } else if (key == "NDims") {
      has_dimension_ = true;
      if (field.size() != 3) field.fail("images of three dimensions are supported: extract one");
    } else if (key == "DimSize") {
      has_sizes_ = true;
      const auto sizes = field.sizes(3);
      header.grid.size = {sizes[0], sizes[1], sizes[2]};
    } else if (key == "ElementSpacing") {
      const auto spacings = field.numbers(3);
      header.grid.spacing = {spacings[0], spacings[1], spacings[2]};
    } else if (key == "Offset" || key == "Origin" || key == "Position") {
      const auto origin = field.numbers(3);
      header.grid.origin = {origin[0], origin[1], origin[2]};
    } else if (key == "TransformMatrix" || key == "Rotation" || key == "Orientation") {
      const auto m = field.numbers(9);
      for (std::size_t i = 0; i != 3; ++i) header.grid.axes[i] = {m[3 * i], m[3 * i + 1], m[3 * i + 2]};
    } else if (key == "ElementType") {
      read_type(field);
    } else if (key == "ElementNumberOfChannels") {
      if (field.size() != 1) field.fail("images with several values per voxel (colours, vectors) are not supported: extract one");
    } else if (key == "BinaryData") {
      if (!is_true(field)) field.fail("values in words are not supported: write it with binary data");
    } else if (key == "BinaryDataByteOrderMSB" || key == "ElementByteOrderMSB") {
      header.order = is_true(field) ? std::endian::big : std::endian::little;
    } else if (key == "CompressedData") {
      header.compressed = is_true(field);
    } else if (key == "HeaderSize") {
      if (field.number() != 0) field.fail("skipping is not supported");
    } else if (key == "ElementDataFile") {
      has_values_ = true;
      if (field.value != "LOCAL" && field.value != "Local" && field.value != "local") out_.values_file = checked_values_file(field);
    }
  }

  static bool is_true(const ImageField& field) {
    if (field.value == "True" || field.value == "true" || field.value == "1") return true;
    if (field.value != "False" && field.value != "false" && field.value != "0") field.fail("it must be True or False");
    return false;
  }

  void read_type(const ImageField& field) {
    has_type_ = true;
    struct Name {
      std::string_view text;
      VoxelType type;
    };
    static constexpr std::array names{Name{"MET_CHAR", VoxelType::int8},        Name{"MET_UCHAR", VoxelType::uint8},
                                      Name{"MET_SHORT", VoxelType::int16},      Name{"MET_USHORT", VoxelType::uint16},
                                      Name{"MET_INT", VoxelType::int32},        Name{"MET_UINT", VoxelType::uint32},
                                      Name{"MET_LONG_LONG", VoxelType::int64},  Name{"MET_ULONG_LONG", VoxelType::uint64},
                                      Name{"MET_FLOAT", VoxelType::float32},    Name{"MET_DOUBLE", VoxelType::float64}};
    for (const Name& n : names) {
      if (n.text == field.value) return void(out_.header.type = n.type);
    }
    field.fail("that is no type of single values that is known");
  }

  const std::string& name_;
  DetachableHeader out_;
  bool has_dimension_ = false, has_sizes_ = false, has_type_ = false, has_values_ = false;
};

}  // namespace detail

/// The image in the bytes of an .mha file, or of an .mhd file of which `values_of(name)` gives the bytes of the file that it names.
/// `name` is what messages call it. Throws `InvalidInput` in words, `Interrupted`.
template <class ValuesOf>
ImageFile parse_meta_image(std::string_view bytes, ValuesOf&& values_of, const std::string& name, const Control& control = Control{}) {
  detail::DetachableHeader found = detail::MetaImageHeader(bytes, name).take();
  if (found.values_file.empty()) return detail::decode_image(std::move(found.header), bytes.substr(found.values), name, control);
  const std::string values = values_of(found.values_file);
  return detail::decode_image(std::move(found.header), values, name, control);
}

}  // namespace delref
