// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the surface triangles of a mesh in the formats of surfaces, which viewers, printers and modelling programs open: .off, .stl,
// .ply and .obj, through CGAL's writers. They carry neither regions nor markers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <locale>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <delref/core/budget.hpp>
#include <delref/io/extension.hpp>
#include <delref/io/file.hpp>
#include <delref/io/text_sink.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

inline constexpr std::string_view surface_formats = ".off, .stl, .ply and .obj";

/// Whether the extension of a path is that of a format of surfaces.
inline bool is_surface_format(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 4> known{".off", ".stl", ".ply", ".obj"};
  return std::ranges::find(known, detail::lower_extension(path)) != known.end();
}

namespace detail {

/// A stream of the standard library over a sink.
class SinkBuffer : public std::streambuf {
 public:
  explicit SinkBuffer(TextSink& sink) : sink_(sink) {}

 protected:
  std::streamsize xsputn(const char* text, std::streamsize count) override {
    sink_ << std::string_view(text, static_cast<std::size_t>(count));
    return count;
  }
  int_type overflow(int_type c) override {
    if (!traits_type::eq_int_type(c, traits_type::eof())) sink_ << traits_type::to_char_type(c);
    return traits_type::not_eof(c);
  }

 private:
  TextSink& sink_;
};

/// Points and triangles as CGAL's writers take them.
struct SurfaceSoup {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// The triangles that a mesh lists, with the points that they use, in the order of the mesh.
inline SurfaceSoup surface_soup(const TetrahedralMesh& mesh) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.points.size(), unused);
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle) number[v] = 0;
  SurfaceSoup soup;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == unused) continue;
    number[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.emplace_back(mesh.points[v].x, mesh.points[v].y, mesh.points[v].z);
  }
  soup.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) soup.triangles.push_back({number[a], number[b], number[c]});
  return soup;
}

}  // namespace detail

/// Writes the triangles that a mesh lists, as text with the 17 digits from which the same doubles are read again; tetrahedra, and points
/// of no triangle, are left out. Requires valid indices and a path for which `is_surface_format`. Throws `OutputError`, and
/// `Interrupted` when the control says stop.
inline void write_surface(const std::filesystem::path& path, const TetrahedralMesh& mesh, const Control& control = Control{}) {
  const detail::SurfaceSoup soup = detail::surface_soup(mesh);
  const auto digits = CGAL::parameters::stream_precision(std::numeric_limits<double>::max_digits10);
  const auto write = [&](TextSink& sink) {
    detail::SinkBuffer buffer(sink);
    std::ostream out(&buffer);
    out.imbue(std::locale::classic());
    out.exceptions(std::ios::badbit);  // what the sink throws passes through
    const std::string extension = detail::lower_extension(path);
    if (extension == ".off") return CGAL::IO::write_OFF(out, soup.points, soup.triangles, digits);
    if (extension == ".stl") return CGAL::IO::write_STL(out, soup.points, soup.triangles, digits);
    if (extension == ".ply") return CGAL::IO::write_PLY(out, soup.points, soup.triangles, digits);
    if (extension == ".obj") return CGAL::IO::write_OBJ(out, soup.points, soup.triangles, digits);
    throw OutputError(detail::unknown_extension(path, "a surface that can be written;", surface_formats));
  };
  write_file(
      path,
      [&](TextSink& sink) {
        if (!write(sink)) throw OutputError(fmt::format("{}: cannot be written", path.string()));
      },
      control);
}

}  // namespace delref
