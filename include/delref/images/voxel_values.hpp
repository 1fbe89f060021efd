// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the bytes of an image file to an image, without loss: the part that all image formats have in common.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/images/gzip.hpp>

namespace delref {

/// An image out of a file, and what a user should know about how it was read.
struct ImageFile {
  AnyImage image;
  std::vector<std::string> notes;
};

namespace detail {

enum class VoxelType : unsigned char { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

inline std::size_t bytes_of(VoxelType type) {
  switch (type) {
    case VoxelType::int8: case VoxelType::uint8: return 1;
    case VoxelType::int16: case VoxelType::uint16: return 2;
    case VoxelType::int32: case VoxelType::uint32: case VoxelType::float32: return 4;
    case VoxelType::int64: case VoxelType::uint64: case VoxelType::float64: return 8;
  }
  return 0;
}

/// What a header says of an image.
struct ImageHeader {
  ImageGrid grid;
  VoxelType type = VoxelType::uint8;
  std::endian order = std::endian::native;
  /// Where the values begin in the decompressed file of the values.
  std::size_t offset = 0;
  /// A value means `slope * value + intercept`.
  double slope = 1, intercept = 0;
  /// Whether the file of the values is compressed; when the header does not say, its first bytes tell.
  std::optional<bool> compressed;
  std::vector<std::string> notes;
};

/// A piece of a file in a message: what can be printed of it, and not more than a person reads.
inline std::string shown(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 40)) out += c >= ' ' && c <= '~' ? c : '?';
  return text.size() > 40 ? out + "..." : out;
}

/// The bytes of the values. Throws `InvalidInput` when a lying header asks for more than the file can have: before there is memory for it.
inline std::string voxel_bytes(const ImageHeader& header, std::string_view file, const std::string& name, const Control& control) {
  constexpr double greatest_compression = 1040;  // of deflate
  const auto [nx, ny, nz] = header.grid.size;
  const double needed = static_cast<double>(header.offset) + static_cast<double>(nx) * ny * nz * static_cast<double>(bytes_of(header.type));
  const auto there = static_cast<double>(file.size());
  const auto fail = [&](double found) {
    throw InvalidInput(
        fmt::format("{}: {:.0f} bytes are needed for {} x {} x {} voxels of {} bytes each, but there are {:.0f}: the header "
                    "lies, or the file is cut off",
                    name, needed, nx, ny, nz, bytes_of(header.type), found));
  };
  // Values without compression may begin like a compressed file by chance.
  const bool compressed = header.compressed.value_or(is_gzip(file) && there != needed);
  if (!compressed && !(needed <= there)) fail(there);
  if (!(needed <= greatest_compression * there)) {
    throw InvalidInput(
        fmt::format("{}: {} x {} x {} voxels of {} bytes each cannot come out of {:.0f} compressed bytes: the header lies, or "
                    "the file is cut off",
                    name, nx, ny, nz, bytes_of(header.type), there));
  }
  // One more byte than is needed: only at the end of what is compressed is its checksum looked at.
  const auto size = static_cast<std::size_t>(needed);
  std::string bytes = first_bytes(file, compressed, size + 1, name, control);
  if (bytes.size() < size) fail(static_cast<double>(bytes.size()));
  bytes.resize(size);
  bytes.erase(0, header.offset);
  return bytes;
}

template <class Stored, class Kept, class Convert>
Image<Kept> converted(const ImageHeader& header, std::string_view bytes, const Control& control, Convert&& convert) {
  Image<Kept> image{header.grid, std::vector<Kept>(header.grid.voxels())};
  StopCheck stop(control);
  for (std::size_t i = 0; i != image.values.size(); ++i) {
    stop();
    image.values[i] = convert(number_from_bytes<Stored>(bytes.data() + i * sizeof(Stored), header.order));
  }
  return image;
}

/// As `float` where every value is one, which halves the memory.
inline AnyImage smallest(Image<double> image) {
  const auto fits = [](double v) { return std::isnan(v) || static_cast<double>(static_cast<float>(v)) == v; };
  if (!std::ranges::all_of(image.values, fits)) return image;
  Image<float> small{image.grid, std::vector<float>(image.values.size())};
  std::ranges::transform(image.values, small.values.begin(), [](double v) { return static_cast<float>(v); });
  return small;
}

/// The type that keeps all values of a stored type, or would but for some that are refused.
template <class Stored>
AnyImage keep_values(const ImageHeader& header, std::string_view bytes, const std::string& name, const Control& control) {
  const auto exact = [&](Stored v) {
    if constexpr (std::is_integral_v<Stored> && sizeof(Stored) == 8) {
      constexpr Stored limit = Stored{1} << 53;
      if (v > limit || (std::is_signed_v<Stored> && v < Stored{0} - limit)) {
        throw InvalidInput(fmt::format(
            "{}: the value {} has more than 53 bits and would lose digits; convert the image to another type", name, v));
      }
    }
    return static_cast<double>(v);
  };
  if (header.slope != 1 || header.intercept != 0) {
    return smallest(converted<Stored, double>(header, bytes, control, [&](Stored v) { return header.slope * exact(v) + header.intercept; }));
  }
  if constexpr (std::is_same_v<Stored, float>) {
    return converted<float, float>(header, bytes, control, [](float v) { return v; });
  } else if constexpr (std::is_same_v<Stored, double>) {
    return smallest(converted<double, double>(header, bytes, control, [](double v) { return v; }));
  } else {
    bool fits = true;
    Image<std::int32_t> image = converted<Stored, std::int32_t>(header, bytes, control, [&](Stored v) {
      fits = fits && std::in_range<std::int32_t>(v);
      return static_cast<std::int32_t>(v);
    });
    if (fits) return image;
    image.values = {};
    return smallest(converted<Stored, double>(header, bytes, control, exact));
  }
}

/// The image that a header and the bytes of the file with its values give. Throws `InvalidInput` when the header makes no sense, there
/// are fewer bytes than it says, or a whole number has more than 53 bits; `Interrupted`.
inline ImageFile decode_image(ImageHeader header, std::string_view file, const std::string& name, const Control& control) {
  try {
    check_grid(header.grid);
  } catch (const InvalidInput& error) {
    std::vector<Defect> defects = error.defects();
    for (Defect& defect : defects) defect.message = name + ": " + defect.message;
    throw InvalidInput(std::move(defects));
  }
  if (!std::isfinite(header.slope) || !std::isfinite(header.intercept) || header.slope == 0) {
    throw InvalidInput(fmt::format("{}: values are to be scaled by {} and moved by {}, which makes no sense", name,
                                   describe(header.slope), describe(header.intercept)));
  }
  const std::string bytes = voxel_bytes(header, file, name, control);
  const auto keep = [&]<class Stored>(std::type_identity<Stored>) { return keep_values<Stored>(header, bytes, name, control); };
  const auto decode = [&]() -> AnyImage {
    switch (header.type) {
      case VoxelType::int8: return keep(std::type_identity<std::int8_t>{});
      case VoxelType::uint8: return keep(std::type_identity<std::uint8_t>{});
      case VoxelType::int16: return keep(std::type_identity<std::int16_t>{});
      case VoxelType::uint16: return keep(std::type_identity<std::uint16_t>{});
      case VoxelType::int32: return keep(std::type_identity<std::int32_t>{});
      case VoxelType::uint32: return keep(std::type_identity<std::uint32_t>{});
      case VoxelType::int64: return keep(std::type_identity<std::int64_t>{});
      case VoxelType::uint64: return keep(std::type_identity<std::uint64_t>{});
      case VoxelType::float32: return keep(std::type_identity<float>{});
      case VoxelType::float64: return keep(std::type_identity<double>{});
    }
    return {};
  };
  return {decode(), std::move(header.notes)};
}

}  // namespace detail
}  // namespace delref
