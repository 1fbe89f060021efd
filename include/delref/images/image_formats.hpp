// SPDX-License-Identifier: GPL-3.0-or-later
//
// The formats of images, told by the extension of a file's name. Needs none of the libraries that read them.
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include <delref/io/extension.hpp>

namespace delref {

/// What `read_image` reads, for help texts and messages.
inline constexpr std::string_view image_formats = ".inr, .nii, .hdr with .img (NIfTI and Analyze), each also with .gz; .nrrd, .nhdr, .mha, .mhd";

namespace detail {

/// The extension of an image's file in lower case, without a `.gz` after it.
inline std::string image_extension(const std::filesystem::path& path) {
  const std::string last = lower_extension(path);
  return last == ".gz" ? lower_extension(path.stem()) : last;
}

}  // namespace detail

/// True when `read_image` would try to read a file of this name.
inline bool is_image_file(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 8> known{".inr", ".nii", ".hdr", ".img", ".nrrd", ".nhdr", ".mha", ".mhd"};
  return std::ranges::find(known, detail::image_extension(path)) != known.end();
}

}  // namespace delref
