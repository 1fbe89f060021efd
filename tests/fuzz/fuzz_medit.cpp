// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/io/medit_reader.hpp>

#include "survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = delref_fuzz::text_of(data, size);
  delref_fuzz::survive([&] { delref_fuzz::require_sound(delref::parse_medit<delref::PlanarMesh>(text, "fuzz.mesh")); });
  delref_fuzz::survive([&] { delref_fuzz::require_sound(delref::parse_medit<delref::TetrahedralMesh>(text, "fuzz.mesh")); });
  return 0;
}
