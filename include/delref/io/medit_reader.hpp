// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the .mesh format of MEDIT (Frey 2001, INRIA technical report 253), as text: vertices, edges, triangles and tetrahedra with
// their references. What tells more about those (corners, ridges, normals, required elements) is passed over; cells of other shapes
// are refused.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/medit.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

template <IndexedMesh Mesh>
class MeditReader {
 public:
  MeditReader(std::string_view text, const std::string& name, const Control& control)
      : in_(text, name, TextScanner::Layout::lines), control_(control) {}

  Mesh read() {
    if (!has_token() || in_.word("MeshVersionFormatted") != "MeshVersionFormatted") {
      in_.fail("expected MeshVersionFormatted: this is not a text file in the format of MEDIT");
    }
    token();
    in_.integer<int>("the version");
    while (has_token()) {
      const std::string keyword(in_.word("a keyword"));
      if (keyword == "End") break;
      read_section(keyword);
    }
    if (!have_vertices_) in_.fail("the file ends without Vertices");
    return std::move(mesh_);
  }

 private:
  /// Fields are separated by blanks and ends of lines alike.
  bool has_token() { return in_.has_field() || in_.next_line(); }
  void token() {
    if (!has_token()) in_.fail("the file ends in the middle of a section");
  }

  void read_section(const std::string& keyword) {
    if (keyword == "Dimension") return read_dimension();
    if (keyword == "Vertices") return read_vertices();
    bool known = false;
    for_each_block(mesh_, [&](const auto& block) {
      if (keyword != medit_keywords[block.dimension]) return;
      known = true;
      read_cells(block, keyword);
    });
    if (known) return;
    static constexpr std::array<std::string_view, 4> other_shapes{"Quadrilaterals", "Hexahedra", "Prisms", "Pyramids"};
    if (keyword == medit_keywords[3] || std::ranges::find(other_shapes, keyword) != other_shapes.end()) {
      in_.fail(fmt::format("{} are not read; only {}triangles and edges are", keyword, dimension_of<Mesh> == 3 ? "tetrahedra, " : ""));
    }
    for (std::size_t i = 0; has_token() && in_.at_number(); ++i) {
      ask_sometimes(control_, i);
      in_.word(keyword);
    }
  }
  void read_dimension() {
    token();
    dimension_ = in_.integer<int>("the dimension");
    if (dimension_ != 2 && dimension_ != 3) in_.fail(fmt::format("the dimension is {}; it can be 2 or 3", dimension_));
    if (dimension_ < static_cast<int>(dimension_of<Mesh>)) in_.fail("the dimension is 2; only meshes of space are read here");
  }
  void read_vertices() {
    if (std::exchange(have_vertices_, true)) in_.fail("Vertices are there twice");
    if (dimension_ == 0) in_.fail("Vertices come before Dimension");
    token();
    const std::size_t count = in_.count("the number of vertices", 6);
    mesh_.points.reserve(count);
    mesh_.point_markers.reserve(count);
    const auto coordinate = [&](const std::string& what, std::size_t i) {
      token();
      return in_.number(what, i);
    };
    for (std::size_t i = 1; i <= count; ++i) {
      ask_sometimes(control_, i);
      const double x = coordinate(names_.x, i), y = coordinate(names_.y, i), z = dimension_ == 3 ? coordinate(names_.z, i) : 0;
      if constexpr (dimension_of<Mesh> == 2) {
        if (z != 0) in_.fail(fmt::format("vertex {} has z coordinate {}; only planar meshes, with z = 0, are read", i, z));
        mesh_.points.push_back({x, y});
      } else {
        mesh_.points.push_back({x, y, z});
      }
      token();
      mesh_.point_markers.push_back(in_.integer<int>("the reference of vertex", i));
    }
  }
  template <class Block>
  void read_cells(const Block& block, const std::string& keyword) {
    if (!have_vertices_) in_.fail(fmt::format("{} come before Vertices", keyword));
    if (!block.cells.empty()) in_.fail(fmt::format("{} are there twice", keyword));
    token();
    const std::size_t count = in_.count(fmt::format("the number of {}", keyword), 2 * (block.corners + 1));
    block.cells.reserve(count);
    block.labels.reserve(count);
    const std::string corner_name = fmt::format("a vertex of {}, number", keyword),
                      reference_name = fmt::format("the reference of {}, number", keyword);
    for (std::size_t i = 1; i <= count; ++i) {
      ask_sometimes(control_, i);
      auto& cell = block.cells.emplace_back();
      for (auto& corner : cell) {
        token();
        const auto vertex = in_.integer<std::size_t>(corner_name, i);
        if (vertex == 0 || vertex > mesh_.points.size()) {
          in_.fail(fmt::format("{} {} is vertex {}, but the vertices are numbered from 1 and there are {}", corner_name, i, vertex,
                               mesh_.points.size()));
        }
        corner = static_cast<typename Mesh::Index>(vertex - 1);
      }
      token();
      block.labels.push_back(in_.integer<int>(reference_name, i));
    }
  }

  TextScanner in_;
  const Control& control_;
  Mesh mesh_;
  CoordinateNames names_{"vertex"};
  int dimension_ = 0;
  bool have_vertices_ = false;
};

}  // namespace detail

/// The mesh in the text of a .mesh file; `name` is what complaints call it. Carriers, provenance and input elements are not in it.
/// Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
template <IndexedMesh Mesh>
Mesh parse_medit(std::string_view text, const std::string& name, const Control& control = Control{}) {
  return detail::MeditReader<Mesh>(text, name, control).read();
}

/// Reads a .mesh file. Throws as `read_file` and `parse_medit`.
template <IndexedMesh Mesh>
Mesh read_medit(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_medit<Mesh>(read_file(path, control), path.string(), control);
}

}  // namespace delref
