// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads polygonal surfaces from .ply files, text and binary of either byte order (ply_header.hpp). The element `vertex` gives the
// points, the list `vertex_indices` or `vertex_index` of the element `face` the facets; all else is passed over.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/plc.hpp>
#include <delref/io/binary_numbers.hpp>
#include <delref/io/file.hpp>
#include <delref/io/node_records.hpp>
#include <delref/io/plc_file.hpp>
#include <delref/io/ply_header.hpp>
#include <delref/io/text_scanner.hpp>

namespace delref {

namespace detail {

/// The elements after the header, one number after the other.
class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& name, const Control& control)
      : in_(text, name, TextScanner::Layout::lines), control_(control), header_(read_ply_header(in_)) {
    if (header_.layout == PlyLayout::text) return;
    in_.rest_of_line();
    bytes_ = text.substr(text.size() - in_.bytes_left());
  }

  PlcFile read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") read_vertices(element);
      else if (element.name == "face") read_faces(element);
      else pass_over(element);
    }
    if (out_.plc.points.empty()) in_.fail("the file has no element \"vertex\"");
    return std::move(out_);
  }

 private:
  /// Visits every element, and of each every property with its index and its values.
  template <class Visit>
  void for_each(const PlyElement& element, Visit&& visit) {
    if (element.properties.empty()) return;
    for (std::uint64_t i = 0; i != element.count; ++i) {
      ask_sometimes(control_, i);
      at_ = {element.name, i};
      if (header_.layout == PlyLayout::text) in_.need_line(element.name, i);
      for (std::size_t k = 0; k != element.properties.size(); ++k) visit(k, read_values(element.properties[k]));
    }
  }
  const std::vector<double>& read_values(const PlyProperty& property) {
    values_.clear();
    std::size_t count = 1;
    if (property.count) {
      const double length = read_number(*property.count);
      if (!(length >= 0 && length <= 4e9) || length != std::floor(length)) fail(fmt::format("a list has the length {}", length));
      count = static_cast<std::size_t>(length);
      const std::size_t each = header_.layout == PlyLayout::text ? 2 : size_of(property.type);
      if (count > (bytes_left() + 2) / each) fail(fmt::format("a list has the length {}, but only {} bytes follow", count, bytes_left()));
    }
    for (std::size_t i = 0; i != count; ++i) values_.push_back(read_number(property.type));
    return values_;
  }
  double read_number(PlyType type) {
    if (header_.layout == PlyLayout::text) {
      if (!in_.has_field()) in_.need_line("a property");
      return in_.number("a property");
    }
    const char* const bytes = bytes_.data();
    if (bytes_.size() < size_of(type)) fail("the file ends here");
    bytes_.remove_prefix(size_of(type));
    const auto order = header_.layout == PlyLayout::little ? std::endian::little : std::endian::big;
    switch (type) {
      case PlyType::int8: return number_from_bytes<std::int8_t>(bytes, order);
      case PlyType::uint8: return number_from_bytes<std::uint8_t>(bytes, order);
      case PlyType::int16: return number_from_bytes<std::int16_t>(bytes, order);
      case PlyType::uint16: return number_from_bytes<std::uint16_t>(bytes, order);
      case PlyType::int32: return number_from_bytes<std::int32_t>(bytes, order);
      case PlyType::uint32: return number_from_bytes<std::uint32_t>(bytes, order);
      case PlyType::float32: return double{number_from_bytes<float>(bytes, order)};
      case PlyType::float64: break;
    }
    return number_from_bytes<double>(bytes, order);
  }
  std::size_t bytes_left() const { return header_.layout == PlyLayout::text ? in_.bytes_left() : bytes_.size(); }
  [[noreturn]] void fail(std::string_view message) const {
    if (header_.layout == PlyLayout::text) in_.fail(fmt::format("{} {}: {}", at_.first, at_.second, message));
    throw InvalidInput(fmt::format("{}: {} {}: {}", in_.name(), at_.first, at_.second, message));
  }

  void read_vertices(const PlyElement& element) {
    const auto x = element.find("x"), y = element.find("y"), z = element.find("z");
    if (!x || !y || !z) in_.fail("the element \"vertex\" has no properties x, y and z");
    for (const auto k : {*x, *y, *z}) if (element.properties[k].count) in_.fail("x, y or z of the element \"vertex\" is a list");
    out_.plc.points.reserve(out_.plc.points.size() + element.count);
    Point3 p;
    for_each(element, [&](std::size_t k, const std::vector<double>& values) {
      if (k == *x) p.x = values[0];
      if (k == *y) p.y = values[0];
      if (k == *z) p.z = values[0];
      if (k + 1 == element.properties.size()) out_.plc.points.push_back(p);
    });
  }
  void read_faces(const PlyElement& element) {
    auto list = element.find("vertex_indices");
    if (!list) list = element.find("vertex_index");
    if (!list || !element.properties[*list].count) in_.fail("the element \"face\" has no list vertex_indices");
    out_.plc.facets.reserve(out_.plc.facets.size() + element.count);
    for_each(element, [&](std::size_t k, const std::vector<double>& values) {
      if (k != *list) return;
      if (values.size() < 3) fail(fmt::format("it has {} corners; a polygon has three or more", values.size()));
      std::vector<Plc::Index> corners;
      corners.reserve(values.size());
      for (const double value : values) {
        if (!(value >= 0 && value < static_cast<double>(out_.plc.points.size())) || value != std::floor(value)) {
          fail(fmt::format("a corner is vertex {}, but the vertices are numbered from 0 and there are {}", value, out_.plc.points.size()));
        }
        corners.push_back(static_cast<Plc::Index>(value));
      }
      add_polygon(out_.plc, std::move(corners));
    });
  }
  void pass_over(const PlyElement& element) {
    for_each(element, [](std::size_t, const std::vector<double>&) {});
    if (element.count != 0) out_.notes.push_back(fmt::format("{} elements \"{}\" are passed over", element.count, element.name));
  }

  TextScanner in_;
  const Control& control_;
  PlyHeader header_;
  std::string_view bytes_;
  std::pair<std::string_view, std::uint64_t> at_;
  std::vector<double> values_;
  PlcFile out_;
};

}  // namespace detail

/// The surface in the bytes of a .ply file; `name` is what complaints call it. Vertices must come before faces.
/// Throws `InvalidInput` with the line or element and what was expected there, `Interrupted` when the control says stop.
inline PlcFile parse_ply(std::string_view bytes, const std::string& name, const Control& control = Control{}) {
  return detail::PlyReader(bytes, name, control).read();
}

/// Reads a .ply file. Throws as `read_file` and `parse_ply`.
inline PlcFile read_ply(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_ply(read_file(path, control), path.string(), control);
}

}  // namespace delref
