// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/io/tetgen_mesh.hpp>
#include <delref/io/triangle_mesh.hpp>

#include "survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = delref_fuzz::text_of(data, size);
  // The four files in one, with lines of a single % between them.
  std::array<std::string_view, 4> parts;
  std::size_t begin = 0;
  for (std::string_view& part : parts) {
    const std::size_t end = text.find("%\n", begin);
    part = text.substr(begin, end == std::string_view::npos ? end : end - begin);
    begin = end == std::string_view::npos ? text.size() : end + 2;
  }
  delref_fuzz::survive([&] { delref_fuzz::require_sound(delref::parse_triangle_mesh({parts[0], parts[1], parts[2], parts[3]}, "fuzz")); });
  delref_fuzz::survive([&] { delref_fuzz::require_sound(delref::parse_tetgen_mesh({parts[0], parts[1], parts[2], parts[3]}, "fuzz")); });
  return 0;
}
