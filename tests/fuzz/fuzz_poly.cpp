// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/io/triangle_poly.hpp>

#include "survive.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = delref_fuzz::text_of(data, size);
  const auto vertices = [] { return delref::parse_triangle_node("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n", "fuzz.node"); };
  delref_fuzz::survive([&] {
    const delref::Pslg pslg = delref::parse_triangle_poly(text, "fuzz.poly", vertices);
    delref_fuzz::require(pslg.attributes.size() == pslg.points.size() * pslg.attribute_count);
    delref_fuzz::require(pslg.point_markers.empty() || pslg.point_markers.size() == pslg.points.size());
    delref_fuzz::require(pslg.segment_markers.empty() || pslg.segment_markers.size() == pslg.segments.size());
  });
  delref_fuzz::survive([&] { delref::parse_triangle_node(text, "fuzz.node"); });
  return 0;
}
