// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images out of files, whichever of the known formats they are in.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/image.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/images/image_formats.hpp>
#include <delref/images/inr_reader.hpp>
#include <delref/images/meta_image_reader.hpp>
#include <delref/images/nifti_reader.hpp>
#include <delref/images/nrrd_reader.hpp>
#include <delref/images/voxel_values.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/file.hpp>

namespace delref {

namespace detail {

/// `name`, or `name.gz` where that stands and `name` does not.
inline std::filesystem::path compressed_or_not(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::path compressed = path;
  compressed += ".gz";
  return !std::filesystem::exists(path, ignored) && std::filesystem::exists(compressed, ignored) ? compressed : path;
}

inline ImageFile read_pair(const std::filesystem::path& path, const Control& control) {
  std::filesystem::path base = path;
  if (lower_extension(base) == ".gz") base.replace_extension();
  const bool upper = base.extension() == ".HDR" || base.extension() == ".IMG";
  const std::filesystem::path header = compressed_or_not(base.replace_extension(upper ? ".HDR" : ".hdr"));
  const std::filesystem::path values = compressed_or_not(base.replace_extension(upper ? ".IMG" : ".img"));
  const std::string header_bytes = read_file(header, control);
  return parse_nifti_pair(header_bytes, read_file(values, control), header.string(), control);
}

}  // namespace detail

/// The image in a file, its format told by the extension (`image_formats`).
/// Throws `InvalidInput` in words when it cannot be read, its header is damaged or lies, it ends too early, it has colours or several
/// volumes, its voxels have no positive spacing or its axes are not at right angles, or values would lose digits; `Interrupted`.
inline ImageFile read_image(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string extension = detail::image_extension(path), name = path.string();
  if (!is_image_file(path)) throw InvalidInput(detail::unknown_extension(path, "an image that can be read;", image_formats));
  if (extension == ".hdr" || extension == ".img") return detail::read_pair(path, control);
  const std::string bytes = read_file(path, control);
  const auto beside = [&](const std::string& values) {
    const std::filesystem::path file = path.parent_path() / values;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
      throw InvalidInput(fmt::format("{}: the file {} that holds its values is not there", name, file.string()));
    return read_file(file, control);
  };
  if (extension == ".inr") return parse_inr(bytes, name, control);
  if (extension == ".nii") return parse_nifti(bytes, name, control);
  if (extension == ".nrrd" || extension == ".nhdr") return parse_nrrd(bytes, beside, name, control);
  return parse_meta_image(bytes, beside, name, control);
}

}  // namespace delref
