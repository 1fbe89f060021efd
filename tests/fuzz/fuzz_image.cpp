// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <variant>

#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/images/image_reader.hpp>

#include "survive.hpp"

namespace {

/// There is a value for each voxel, and what the image stands for can be asked for its components.
void require_sound(const delref::ImageFile& file) {
  delref_fuzz::require(std::visit([](const auto& image) { return image.values.size() == image.grid.voxels(); }, file.image));
  if (delref::grid_of(file.image).voxels() > 4096) return;
  delref_fuzz::survive([&] {
    const delref::GreyLevelImage domain(file.image, 0.5, {.close_at_border = true});
    delref_fuzz::require(!domain.components(delref::Control{}).components.empty());
  });
  delref_fuzz::survive([&] {
    const delref::LabelledImage domain(file.image);
    delref_fuzz::require(!domain.components(delref::Control{}).components.empty());
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = delref_fuzz::text_of(data, size);
  const auto beside = [&](const std::string&) { return std::string(text.substr(text.size() / 2)); };
  delref_fuzz::survive([&] { require_sound(delref::parse_inr(text, "fuzz.inr")); });
  delref_fuzz::survive([&] { require_sound(delref::parse_nifti(text, "fuzz.nii")); });
  delref_fuzz::survive([&] { require_sound(delref::parse_nifti_pair(text.substr(0, 348), text.substr(std::min<std::size_t>(size, 348)), "fuzz.hdr")); });
  delref_fuzz::survive([&] { require_sound(delref::parse_nrrd(text, beside, "fuzz.nrrd")); });
  delref_fuzz::survive([&] { require_sound(delref::parse_meta_image(text, beside, "fuzz.mha")); });
  return 0;
}
