// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads meshes of lines, triangles and (in space) tetrahedra from the MSH format 4.1 of Gmsh, as text. The label of an element is the
// one that the name of its physical group spells (physical_tags.hpp), or else the physical tag, or 0 without one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/mesh_blocks.hpp>
#include <delref/io/msh.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/physical_tags.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// The elements of one kind, as they come.
template <std::size_t Corners>
struct MshElement {
  std::uint64_t tag;
  std::array<std::uint32_t, Corners> corners;
  int label;
};

/// The sections of one file, gathered in the order in which they come.
template <IndexedMesh Mesh>
class MshReader {
 public:
  MshReader(std::string_view text, const std::string& name, const Control& control)
      : in_(text, name, TextScanner::Layout::free), control_(control) {}

  Mesh read() {
    if (in_.word("$MeshFormat") != "$MeshFormat") in_.fail("expected $MeshFormat: this is not a file in Gmsh's MSH format");
    read_format();
    while (in_.has_field()) read_section(std::string(in_.word("a section")));
    if (!have_nodes_) in_.fail("the file ends without a $Nodes section");
    if (!have_elements_) in_.fail("the file ends without an $Elements section");
    for_each_block(mesh_, [&](const auto& block) { put_in_order(elements_of(block), block.cells, block.labels); });
    return std::move(mesh_);
  }

 private:
  using Index = typename Mesh::Index;

  template <class Block>
  auto& elements_of(const Block&) {
    return std::get<std::vector<MshElement<Block::corners>>>(elements_);
  }

  void read_format() {
    const double version = in_.number("the version");
    if (version != 4.1) in_.fail(fmt::format("the version is {}; only 4.1 is read (gmsh -save -format msh41 converts it)", version));
    if (in_.integer<int>("the file type") != 0) in_.fail("the file is binary; only text is read (gmsh -save -format msh41 converts it)");
    in_.integer<int>("the data size");
    end_section("MeshFormat");
  }
  void read_section(const std::string& section) {
    if (section == "$PhysicalNames") return read_names();
    if (section == "$Entities") return read_entities();
    if (section == "$Nodes") return read_nodes();
    if (section == "$Elements") return read_elements();
    if (section == "$NodeData") return read_node_data();
    if (!section.starts_with('$')) in_.fail("expected a section, that is a word that starts with $");
    for (const std::string end = "$End" + section.substr(1); in_.word(end) != end;) {}
  }
  void end_section(std::string_view name) {
    const std::string end = fmt::format("$End{}", name);
    if (in_.word(end) != end) in_.fail(fmt::format("expected {}", end));
  }
  std::string_view quoted(std::string_view what) {
    if (!in_.has_field()) in_.fail(fmt::format("the file ends where {} was expected", what));
    std::string_view line = in_.rest_of_line();
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') in_.fail(fmt::format("expected {} in quotes on the line before", what));
    return line.substr(1, line.size() - 2);
  }

  void read_names() {
    for (std::size_t left = in_.count("the number of physical names", 6); left != 0; --left) {
      const auto dimension = in_.integer<int>("the dimension of a physical group");
      const auto tag = in_.integer<int>("the tag of a physical group");
      const std::string_view name = quoted("the name of a physical group");
      if (dimension < 1 || dimension > own_dimension) continue;
      const std::string_view kind = msh_group_name(static_cast<std::size_t>(dimension), dimension_of<Mesh>);
      if (const auto label = label_in_physical_name(name, kind)) labels_[{dimension, tag}] = *label;
    }
    end_section("PhysicalNames");
  }
  void read_entities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t& count : counts) count = in_.count("the number of entities", 1);
    for (int dimension = 0; dimension != 4; ++dimension) {
      for (std::size_t left = counts[static_cast<std::size_t>(dimension)]; left != 0; --left) {
        const auto entity = in_.integer<int>("the tag of an entity");
        for (int i = 0; i != (dimension == 0 ? 3 : 6); ++i) in_.number("the bounding box of an entity");
        for (std::size_t groups = in_.count("the number of physical tags", 2), i = 0; i != groups; ++i) {
          const auto tag = in_.integer<int>("a physical tag");
          if (i == 0) group_of_[{dimension, entity}] = tag == std::numeric_limits<int>::min() ? tag : std::abs(tag);
        }
        if (dimension == 0) continue;
        for (std::size_t bounds = in_.count("the number of bounding entities", 2); bounds != 0; --bounds) in_.integer<int>("a bounding entity");
      }
    }
    end_section("Entities");
  }
  void read_nodes() {
    if (std::exchange(have_nodes_, true)) in_.fail("there is a second $Nodes section");
    std::size_t blocks = in_.count("the number of node blocks", 8);
    const std::size_t total = in_.count("the number of nodes", 8);
    in_.integer<std::uint64_t>("the smallest node tag");
    in_.integer<std::uint64_t>("the largest node tag");
    mesh_.points.reserve(total);
    for (; blocks != 0; --blocks) {
      const auto dimension = in_.integer<int>("the dimension of an entity");
      in_.integer<int>("the tag of an entity");
      const bool parametric = in_.integer<int>("the parametric flag") != 0;
      const std::size_t count = in_.count("the number of nodes of a block", 8);
      for (std::size_t i = 0; i != count; ++i) {
        ask_sometimes(control_, i);
        node_tags_.push_back(in_.integer<std::uint64_t>("the tag of a node"));
      }
      for (std::size_t i = 0; i != count; ++i) read_node(parametric ? dimension : 0, i);
    }
    if (mesh_.points.size() != total) in_.fail(fmt::format("{} nodes were announced, the blocks hold {}", total, mesh_.points.size()));
    end_section("Nodes");
    index_tags();
  }
  void read_node(int parameters, std::size_t i) {
    ask_sometimes(control_, i);
    const std::uint64_t tag = node_tags_[mesh_.points.size()];
    const auto p = read_point<Point3>(in_, node_names_, tag);
    for (int k = 0; k < parameters; ++k) in_.number("a parameter of node", tag);
    if constexpr (own_dimension == 2) {
      if (p.z != 0) in_.fail(fmt::format("node {} has z coordinate {}; only planar meshes, with z = 0, are read", tag, p.z));
      mesh_.points.push_back({p.x, p.y});
    } else {
      mesh_.points.push_back(p);
    }
  }
  /// Tags are mostly 1, 2, 3, ...; when they are not, they are looked up in a sorted list.
  void index_tags() {
    for (std::size_t i = 0; i != node_tags_.size(); ++i) consecutive_ = consecutive_ && node_tags_[i] == node_tags_[0] + i;
    if (consecutive_) return;
    for (std::size_t i = 0; i != node_tags_.size(); ++i) sorted_tags_.emplace_back(node_tags_[i], static_cast<Index>(i));
    std::ranges::sort(sorted_tags_);
    const auto twice = std::ranges::adjacent_find(sorted_tags_, {}, &std::pair<std::uint64_t, Index>::first);
    if (twice != sorted_tags_.end()) in_.fail(fmt::format("node {} is there twice", twice->first));
  }
  Index read_node_tag(std::string_view what) {
    const auto tag = in_.integer<std::uint64_t>(what);
    if (consecutive_) {
      if (!node_tags_.empty() && tag >= node_tags_[0] && tag - node_tags_[0] < node_tags_.size()) {
        return static_cast<Index>(tag - node_tags_[0]);
      }
    } else {
      const auto found = std::ranges::lower_bound(sorted_tags_, tag, {}, &std::pair<std::uint64_t, Index>::first);
      if (found != sorted_tags_.end() && found->first == tag) return found->second;
    }
    in_.fail(fmt::format("{} is node {}, but there is no such node", what, tag));
  }
  int label_of_entity(int dimension, int entity) const {
    const auto group = group_of_.find({dimension, entity});
    if (group == group_of_.end()) return 0;
    const auto label = labels_.find({dimension, group->second});
    return label == labels_.end() ? group->second : label->second;
  }
  template <std::size_t Corners>
  void read_block(std::vector<MshElement<Corners>>& out, std::size_t count, int label) {
    for (std::size_t i = 0; i != count; ++i) {
      ask_sometimes(control_, i);
      MshElement<Corners> element{in_.integer<std::uint64_t>("the tag of an element"), {}, label};
      for (auto& corner : element.corners) corner = read_node_tag("a corner of an element");
      out.push_back(element);
    }
  }
  void read_elements() {
    if (!have_nodes_) in_.fail("$Elements comes before $Nodes");
    if (std::exchange(have_elements_, true)) in_.fail("there is a second $Elements section");
    std::size_t blocks = in_.count("the number of element blocks", 8);
    const std::size_t total = in_.count("the number of elements", 4);
    in_.integer<std::uint64_t>("the smallest element tag");
    in_.integer<std::uint64_t>("the largest element tag");
    for (std::size_t done = 0; blocks != 0; --blocks) {
      const auto dimension = in_.integer<int>("the dimension of an entity");
      const auto entity = in_.integer<int>("the tag of an entity");
      const auto type = in_.integer<int>("the type of a block of elements");
      const std::size_t count = in_.count("the number of elements of a block", 4);
      if ((done += count) > total) in_.fail(fmt::format("{} elements were announced, the blocks hold more", total));
      const int label = label_of_entity(dimension, entity);
      bool known = type == msh_element_types[0];
      if (std::vector<MshElement<1>> points; known) read_block(points, count, label);
      for_each_block(mesh_, [&](const auto& block) {
        if (type != msh_element_types[block.dimension]) return;
        known = true;
        read_block(elements_of(block), count, label);
      });
      if (!known) in_.fail(fmt::format("the elements are of type {}; only lines (1), triangles (2){} and points (15) are read", type,
                                       own_dimension == 3 ? ", tetrahedra (4)" : ""));
    }
    end_section("Elements");
  }
  /// The markers of the vertices; any other data is read and dropped.
  void read_node_data() {
    bool markers = false;
    for (std::size_t left = in_.count("the number of string tags", 2); left != 0; --left) markers = quoted("a string tag") == "marker" || markers;
    for (std::size_t left = in_.count("the number of real tags", 2); left != 0; --left) in_.number("a real tag");
    std::vector<std::uint64_t> tags;
    for (std::size_t left = in_.count("the number of integer tags", 2); left != 0; --left) tags.push_back(in_.integer<std::uint64_t>("an integer tag"));
    if (tags.size() < 3 || !have_nodes_) in_.fail("expected $NodeData after $Nodes, with at least three integer tags");
    if (tags[1] > 9) in_.fail(fmt::format("node data with {} components is not known", tags[1]));
    in_.check_room(tags[2], 4, "the number of nodes with data");
    if (markers) mesh_.point_markers.assign(mesh_.points.size(), 0);
    for (std::size_t i = 0; i != tags[2]; ++i) {
      ask_sometimes(control_, i);
      const auto node = read_node_tag("a node with data");
      if (markers && tags[1] == 1) mesh_.point_markers[node] = read_label(in_, "the marker of node", node + std::size_t{1});
      else for (std::uint64_t k = 0; k != tags[1]; ++k) in_.number("the value of a node");
    }
    end_section("NodeData");
  }
  /// By tag, which is the order in which `write_msh` was given them.
  template <std::size_t Corners>
  static void put_in_order(std::vector<MshElement<Corners>>& elements, std::vector<std::array<Index, Corners>>& out, std::vector<int>& labels) {
    const auto order = [](const auto& e) { return std::tie(e.tag, e.corners); };
    if (!std::ranges::is_sorted(elements, {}, order)) std::ranges::sort(elements, {}, order);
    out.reserve(elements.size());
    labels.reserve(elements.size());
    for (const auto& element : elements) {
      out.push_back(element.corners);
      labels.push_back(element.label);
    }
  }

  static constexpr int own_dimension = static_cast<int>(dimension_of<Mesh>);

  TextScanner in_;
  const Control& control_;
  Mesh mesh_;
  CoordinateNames node_names_{"node"};
  std::map<std::pair<int, int>, int> labels_, group_of_;
  std::vector<std::uint64_t> node_tags_;
  std::vector<std::pair<std::uint64_t, Index>> sorted_tags_;
  std::tuple<std::vector<MshElement<2>>, std::vector<MshElement<3>>, std::vector<MshElement<4>>> elements_;
  bool consecutive_ = true, have_nodes_ = false, have_elements_ = false;
};

}  // namespace detail

/// The mesh in the text of a .msh file; `name` is what complaints call it. Vertices in the order of the file, elements in that of
/// their tags. Throws `InvalidInput` with the line and what was expected there, `Interrupted` when the control says stop.
template <IndexedMesh Mesh = PlanarMesh>
Mesh parse_msh(std::string_view text, const std::string& name, const Control& control = Control{}) {
  return detail::MshReader<Mesh>(text, name, control).read();
}

/// Reads a .msh file. Throws as `read_file` and `parse_msh`.
template <IndexedMesh Mesh = PlanarMesh>
Mesh read_msh(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_msh<Mesh>(read_file(path, control), path.string(), control);
}

}  // namespace delref
