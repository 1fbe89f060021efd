// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads GeoJSON (RFC 7946): polygons and multipolygons, bare, in features and in collections. Coordinates are taken as they are,
// in the plane; heights are dropped. Geometries that have no inside are passed over with a note.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/json.hpp>
#include <delref/io/polygons.hpp>

namespace delref {

namespace detail {

/// Walks through the objects of a file and gathers its polygons.
class GeojsonReader {
 public:
  explicit GeojsonReader(std::string name) : name_(std::move(name)) {}

  std::vector<LabelledPolygon> read(const nlohmann::json& root) {
    const std::string type = type_of(root, "the file");
    if (type == "FeatureCollection") {
      for (const auto& feature : member(root, "features", "the file", nlohmann::json::value_t::array)) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(root);
    } else if (type == "GeometryCollection") {
      for (const auto& geometry : member(root, "geometries", "the file", nlohmann::json::value_t::array)) read_as_feature(geometry);
    } else {
      read_as_feature(root);
    }
    if (polygons_.empty()) throw InvalidInput(fmt::format("{}: holds no polygon; nothing to mesh", name_));
    return std::move(polygons_);
  }
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    notes.reserve(passed_over_.size() + 1);
    for (const auto& [type, count] : passed_over_) notes.push_back(fmt::format("{}: {} of type {} passed over: only polygons are read", name_, count, type));
    if (unclosed_ != 0) notes.push_back(fmt::format("{}: {} rings did not end where they began, and were closed", name_, unclosed_));
    return notes;
  }

 private:
  using Json = nlohmann::json;

  std::string where() const { return fmt::format("feature {}", feature_); }
  [[noreturn]] void fail(const std::string& where, std::string_view message) const {
    throw InvalidInput(fmt::format("{}: {} {}", name_, where, message));
  }
  const Json& member(const Json& object, const char* key, const std::string& where, Json::value_t type) const {
    if (!object.is_object()) fail(where, fmt::format("is {}, not an object", object.type_name()));
    const auto found = object.find(key);
    if (found == object.end()) fail(where, fmt::format("has no \"{}\"", key));
    if (found->type() != type) fail(where, fmt::format("has a \"{}\" that is {}, not {}", key, found->type_name(), Json(type).type_name()));
    return *found;
  }
  std::string type_of(const Json& object, const std::string& where) const {
    return member(object, "type", where, Json::value_t::string).get<std::string>();
  }

  void read_feature(const Json& feature) {
    ++feature_;
    if (const std::string type = type_of(feature, where()); type != "Feature") fail(where(), fmt::format("has the type \"{}\", not Feature", type));
    label_ = feature_;
    max_area_ = 0;
    if (const auto properties = feature.find("properties"); properties != feature.end() && properties->is_object()) read_properties(*properties);
    if (const auto geometry = feature.find("geometry"); geometry == feature.end()) fail(where(), "has no \"geometry\"");
    else if (geometry->is_null()) ++passed_over_["null"];
    else read_geometry(*geometry);
  }
  void read_as_feature(const Json& geometry) {
    label_ = ++feature_;
    read_geometry(geometry);
  }
  void read_properties(const Json& properties) {
    if (const auto region = properties.find("region"); region != properties.end() && region->is_number_integer()) {
      const auto label = region->get<std::int64_t>();
      const bool fits = label >= std::numeric_limits<int>::min() && label <= std::numeric_limits<int>::max();
      if (!fits || (region->is_number_unsigned() && label < 0)) fail(where(), "has a property \"region\" that 32 bits cannot hold");
      label_ = static_cast<int>(label);
    }
    if (const auto bound = properties.find("max_area"); bound != properties.end() && bound->is_number()) {
      max_area_ = bound->get<double>();
      if (!(max_area_ > 0)) fail(where(), "has a property \"max_area\" that is not positive");
    }
  }
  void read_geometry(const Json& geometry) {
    const std::string type = type_of(geometry, where());
    if (type == "Polygon") {
      read_polygon(member(geometry, "coordinates", where(), Json::value_t::array));
    } else if (type == "MultiPolygon") {
      for (const Json& polygon : member(geometry, "coordinates", where(), Json::value_t::array)) read_polygon(polygon);
    } else if (type == "GeometryCollection") {
      for (const Json& part : member(geometry, "geometries", where(), Json::value_t::array)) read_geometry(part);
    } else if (type == "Point" || type == "MultiPoint" || type == "LineString" || type == "MultiLineString") {
      ++passed_over_[type];
    } else {
      fail(where(), fmt::format("has a geometry of type \"{}\", which GeoJSON does not know", type));
    }
  }
  void read_polygon(const Json& rings) {
    if (!rings.is_array()) fail(where(), fmt::format("has a polygon that is {}, not an array of rings", rings.type_name()));
    if (rings.empty()) {
      ++passed_over_["empty Polygon"];
      return;
    }
    LabelledPolygon polygon{label_, max_area_, {}};
    for (const Json& ring : rings) polygon.rings.push_back(read_ring(ring, polygon.rings.size()));
    polygons_.push_back(std::move(polygon));
  }
  std::vector<Point2> read_ring(const Json& positions, std::size_t number) {
    const auto ring_name = [&] { return fmt::format("{}, ring {} of polygon {} of the file,", where(), number + 1, polygons_.size() + 1); };
    if (!positions.is_array()) fail(ring_name(), fmt::format("is {}, not an array of positions", positions.type_name()));
    std::vector<Point2> ring;
    ring.reserve(positions.size());
    for (const Json& position : positions) {
      if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number()) {
        fail(ring_name(), fmt::format("has at place {} something that is no position, that is an array of two or more numbers", ring.size() + 1));
      }
      ring.push_back({position[0].get<double>(), position[1].get<double>()});
    }
    const bool closed = ring.size() > 1 && ring.front() == ring.back();
    if (closed) ring.pop_back();
    if (ring.size() < 3) fail(ring_name(), fmt::format("has {} different positions; a ring needs three", ring.size()));
    if (!closed) ++unclosed_;
    return ring;
  }

  std::string name_;
  std::vector<LabelledPolygon> polygons_;
  std::map<std::string, std::size_t> passed_over_;
  std::size_t unclosed_ = 0;
  int feature_ = 0, label_ = 0;
  double max_area_ = 0;
};

}  // namespace detail

/// The domain in the text of a GeoJSON file; `name` is what complaints call it.
///
/// Feature i, counted from 1, is the region with label i, or with the integer property "region" if it has one, and the area bound
/// in the property "max_area". A geometry outside of features counts as a feature, and so does each member of an outermost
/// GeometryCollection. Segments have the label of their feature as marker; see `polygons_to_pslg` for shared borders and holes.
/// Throws `InvalidInput` naming the feature and what is wrong with it, `Interrupted` when the control says stop.
inline PslgFile parse_geojson(std::string_view text, const std::string& name, const Control& control = Control{}) {
  detail::GeojsonReader reader(name);
  const std::vector<LabelledPolygon> polygons = reader.read(parse_json(text, name));
  PslgFile file = polygons_to_pslg(polygons, control);
  const std::vector<std::string> notes = reader.notes();
  file.notes.insert(file.notes.begin(), notes.begin(), notes.end());
  return file;
}

/// Reads a GeoJSON file. Throws as `read_file` and `parse_geojson`.
inline PslgFile read_geojson(const std::filesystem::path& path, const Control& control = Control{}) {
  return parse_geojson(read_file(path, control), path.string(), control);
}

}  // namespace delref
