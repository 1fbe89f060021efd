// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/io/geojson.hpp>

#include "survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = delref_fuzz::text_of(data, size);
  delref_fuzz::survive([&] {
    const delref::PslgFile file = delref::parse_geojson(text, "fuzz.geojson");
    for (const auto& segment : file.pslg.segments) for (const auto v : segment) delref_fuzz::require(v < file.pslg.points.size());
    delref_fuzz::require(file.pslg.segment_markers.size() == file.pslg.segments.size());
  });
  return 0;
}
