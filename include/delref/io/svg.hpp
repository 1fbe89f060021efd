// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a mesh: its triangles coloured by smallest angle or by region, the subsegments over them, what is unmet marked, and a
// legend. Triangles of a colour share one path with coordinates of limited precision, and triangles too small to be seen are left
// out, so that a mesh of 150,000 triangles is a file of a few megabytes that a browser shows at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pugixml.hpp>

#include <delref/core/budget.hpp>
#include <delref/core/outcome.hpp>
#include <delref/io/colours.hpp>
#include <delref/io/file.hpp>
#include <delref/io/smallest_angles.hpp>
#include <delref/io/svg_path.hpp>
#include <delref/mesh/planar_mesh.hpp>

namespace delref {

/// What the colour of a triangle tells.
enum class SvgColouring : unsigned char { smallest_angle, region };

/// How to draw.
struct SvgOptions {
  SvgColouring colouring = SvgColouring::smallest_angle;
  /// The longer side of the picture of the mesh, in pixels; the legend comes below.
  double size = 1000;
  /// A line above the legend; empty for none.
  std::string title;
  /// What is unmet: filled in the colour of alarm, with a ring (one for several at the same place). Where that would hide the picture,
  /// because more than 50 triangles are and more than 5 %, they are outlined only.
  std::span<const Unmet<Point2>> unmet;
};

namespace detail {

/// One picture. The document is built by pugixml, the long paths by SvgPath.
class SvgPicture {
 public:
  SvgPicture(const PlanarMesh& mesh, const SvgOptions& options) : mesh_(mesh), options_(options), frame_(mesh.points, options.size) {}

  std::string draw() {
    colour_triangles();
    const double height = frame_.height() + legend_height;
    pugi::xml_node svg = document_.append_child("svg");
    set(svg, "xmlns", "http://www.w3.org/2000/svg");
    set(svg, "viewBox", fmt::format("0 0 {:.0f} {:.0f}", frame_.width(), height));
    set(svg, "width", fmt::format("{:.0f}", frame_.width()));
    set(svg, "height", fmt::format("{:.0f}", height));
    set(svg, "font-family", "Helvetica, Arial, sans-serif");
    add_rectangle(svg, 0, 0, frame_.width(), height, "#ffffff");
    pugi::xml_node drawing = svg.append_child("g");
    set(drawing, "transform", fmt::format("scale({})", 1 / SvgFrame::steps_per_pixel));
    set(drawing, "stroke-linejoin", "round");
    set(drawing, "stroke-linecap", "round");
    draw_triangles(drawing);
    draw_subsegments(drawing);
    draw_unmet(svg);
    draw_legend(svg);
    std::ostringstream text;
    document_.save(text, " ", pugi::format_default | pugi::format_no_declaration);
    return std::move(text).str();
  }

 private:
  static constexpr double legend_height = 92, margin = 20;
  static constexpr double degrees_per_colour = 2.5;
  static constexpr const char* ink = "#22303a";
  static constexpr const char* alarm = "#d6006c";

  static void set(pugi::xml_node node, const char* name, const std::string& value) { node.append_attribute(name).set_value(value.c_str()); }
  static void add_rectangle(pugi::xml_node parent, double x, double y, double width, double height, const std::string& fill) {
    pugi::xml_node node = parent.append_child("rect");
    set(node, "x", fmt::format("{:.5g}", x));
    set(node, "y", fmt::format("{:.5g}", y));
    set(node, "width", fmt::format("{:.5g}", width));
    set(node, "height", fmt::format("{:.5g}", height));
    set(node, "fill", fill);
  }
  static pugi::xml_node add_text(pugi::xml_node parent, double x, double y, double size, const std::string& text, const char* anchor = "start") {
    pugi::xml_node node = parent.append_child("text");
    set(node, "x", fmt::format("{:.5g}", x));
    set(node, "y", fmt::format("{:.5g}", y));
    set(node, "font-size", fmt::format("{}", size));
    set(node, "fill", ink);
    set(node, "text-anchor", anchor);
    node.text().set(text.c_str());
    return node;
  }

  void colour_triangles() {
    for (const auto& unmet : options_.unmet) {
      if (is_finite(unmet.place)) unmet_.push_back(frame_(unmet.place));
    }
    std::ranges::sort(unmet_);
    for (const int label : mesh_.regions) labels_.try_emplace(label, 0);
    std::size_t rank = 0;
    for (auto& [label, place] : labels_) place = rank++;
    const SmallestAngles angles(mesh_);
    for (std::size_t i = 0; i != mesh_.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh_.triangles[i];
      const double angle = angles(i);
      smallest_angle_ = std::min(smallest_angle_, angle);
      const auto bin = static_cast<std::size_t>(std::clamp(angle, 0.0, 59.99) / degrees_per_colour);
      const std::size_t colour = by_region() ? (mesh_.regions.empty() ? 0 : labels_.at(mesh_.regions[i])) : bin;
      const SvgFrame::Corner p = frame_(mesh_.points[a]), q = frame_(mesh_.points[b]), r = frame_(mesh_.points[c]);
      area_ += std::abs(frame_.doubled_area(p, q, r)) / 2;
      if (std::ranges::binary_search(unmet_, frame_(barycentre(i)))) {
        alarms_.add({p, q, r}, true);
        ++alarm_count_;
      }
      if (frame_.doubled_area(p, q, r) != 0) paths_[colour].add({p, q, r}, true);
    }
  }
  /// Whether alarms everywhere would hide the picture.
  bool is_unmet_as_a_rule() const { return alarm_count_ > 50 && 20 * alarm_count_ > mesh_.triangles.size(); }
  Point2 barycentre(std::size_t i) const {
    const auto& [a, b, c] = mesh_.triangles[i];
    const Point2 p = mesh_.points[a];
    return p + (1.0 / 3) * ((mesh_.points[b] - p) + (mesh_.points[c] - p));
  }
  bool by_region() const { return options_.colouring == SvgColouring::region; }
  std::string colour_of(std::size_t place) const {
    return (by_region() ? region_colour(place) : angle_colour((static_cast<double>(place) + 0.5) * degrees_per_colour)).hex();
  }
  /// The side of a typical triangle in the picture, in steps.
  double typical_side() const {
    return mesh_.triangles.empty() ? 100 * SvgFrame::steps_per_pixel : 1.5 * std::sqrt(area_ / static_cast<double>(mesh_.triangles.size()));
  }
  void draw_triangles(pugi::xml_node drawing) {
    pugi::xml_node group = drawing.append_child("g");
    // Lines take a fixed small part of a triangle: a fine mesh is not drowned in them.
    const double width = std::clamp(0.045 * typical_side(), 0.6, 0.9 * SvgFrame::steps_per_pixel);
    set(group, "stroke-width", fmt::format("{:.3g}", width));
    for (const auto& [place, path] : paths_) {
      const Colour line = by_region() ? region_colour(place) : angle_colour((static_cast<double>(place) + 0.5) * degrees_per_colour);
      pugi::xml_node node = group.append_child("path");
      set(node, "fill", colour_of(place));
      set(node, "stroke", mix(line, {0.10, 0.16, 0.22}, 0.45).hex());
      set(node, "d", path.text());
    }
    if (alarms_.text().empty()) return;
    pugi::xml_node node = group.append_child("path");
    set(node, "fill", is_unmet_as_a_rule() ? "none" : alarm);
    set(node, "stroke", alarm);
    set(node, "d", alarms_.text());
  }
  void draw_subsegments(pugi::xml_node drawing) {
    SvgPath path;
    for (const auto& [a, b] : mesh_.edges) {
      const SvgFrame::Corner p = frame_(mesh_.points[a]), q = frame_(mesh_.points[b]);
      if (p != q) path.add({p, q}, false);
    }
    pugi::xml_node node = drawing.append_child("path");
    set(node, "fill", "none");
    set(node, "stroke", ink);
    set(node, "stroke-width", fmt::format("{:.3g}", std::clamp(0.16 * typical_side(), 0.45 * SvgFrame::steps_per_pixel, 2.0 * SvgFrame::steps_per_pixel)));
    set(node, "d", path.text());
  }
  void draw_unmet(pugi::xml_node svg) {
    if (options_.unmet.empty() || is_unmet_as_a_rule()) return;
    pugi::xml_node group = svg.append_child("g");
    set(group, "fill", "none");
    set(group, "stroke", alarm);
    const bool many = options_.unmet.size() > 2000;
    set(group, "stroke-width", many ? "0.7" : "1.3");
    std::vector<SvgFrame::Corner> places = unmet_;
    const auto repeated = std::ranges::unique(places, [](const auto& a, const auto& b) { return a.x / 10 == b.x / 10 && a.y / 10 == b.y / 10; });
    places.erase(repeated.begin(), repeated.end());
    for (const auto& place : places) {
      pugi::xml_node node = group.append_child("circle");
      set(node, "cx", fmt::format("{:.5g}", static_cast<double>(place.x) / SvgFrame::steps_per_pixel));
      set(node, "cy", fmt::format("{:.5g}", static_cast<double>(place.y) / SvgFrame::steps_per_pixel));
      set(node, "r", many ? "2" : "4");
    }
  }

  void draw_legend(pugi::xml_node svg) {
    const double top = frame_.height(), right = frame_.width() - margin;
    if (!options_.title.empty()) set(add_text(svg, margin, top + 18, 15, options_.title), "font-weight", "bold");
    std::string counts = fmt::format("{} triangles, {} vertices", grouped(mesh_.triangles.size()), grouped(mesh_.points.size()));
    if (!mesh_.triangles.empty()) counts += fmt::format(", smallest angle {:.1f}°", smallest_angle_);
    add_text(svg, margin, top + 38, 12, counts);
    by_region() ? draw_region_keys(svg, top + 50, right) : draw_angle_scale(svg, top + 50);
    if (options_.unmet.empty()) return;
    pugi::xml_node ring = svg.append_child("circle");
    set(ring, "cx", fmt::format("{:.5g}", margin + 5));
    set(ring, "cy", fmt::format("{:.5g}", top + legend_height - 6));
    set(ring, "r", "3.5");
    set(ring, "fill", "none");
    set(ring, "stroke", alarm);
    add_text(svg, margin + 16, top + legend_height - 2.5, 10.5, fmt::format("{} unmet", grouped(options_.unmet.size())));
  }
  void draw_angle_scale(pugi::xml_node svg, double y) const {
    constexpr int colours = static_cast<int>(60 / degrees_per_colour);
    const double width = std::min(360.0, frame_.width() - 2 * margin), step = width / colours;
    for (int i = 0; i != colours; ++i) add_rectangle(svg, margin + i * step, y, step + 0.3, 10, colour_of(static_cast<std::size_t>(i)));
    for (int degrees = 0; degrees <= 60; degrees += 10) {
      add_text(svg, margin + width * degrees / 60, y + 22, 10.5, fmt::format("{}°", degrees), degrees == 0 ? "start" : "middle");
    }
    if (width + 160 < frame_.width()) add_text(svg, margin + width + 18, y + 9, 10.5, "smallest angle of a triangle");
  }
  void draw_region_keys(pugi::xml_node svg, double y, double right) const {
    double x = margin;
    for (const auto& [label, place] : labels_) {
      if (x + 90 > right) {
        add_text(svg, x, y + 9, 10.5, fmt::format("and {} more", labels_.size() - place));
        return;
      }
      add_rectangle(svg, x, y, 10, 10, colour_of(place));
      const std::string name = fmt::format("region {}", label);
      add_text(svg, x + 14, y + 9, 10.5, name);
      x += 26 + 6 * static_cast<double>(name.size());
    }
  }
  /// Digits in groups of three.
  static std::string grouped(std::size_t count) {
    std::string digits = fmt::format("{}", count);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
  }

  const PlanarMesh& mesh_;
  const SvgOptions& options_;
  SvgFrame frame_;
  std::map<int, std::size_t> labels_;
  std::map<std::size_t, SvgPath> paths_;
  SvgPath alarms_;
  std::vector<SvgFrame::Corner> unmet_;
  std::size_t alarm_count_ = 0;
  double smallest_angle_ = 60, area_ = 0;
  pugi::xml_document document_;
};

}  // namespace detail

/// Draws a mesh. Requires valid indices and finite coordinates. Throws `OutputError`, and `Interrupted` when the control says stop
/// before it is drawn.
inline void write_svg(const std::filesystem::path& path, const PlanarMesh& mesh, const SvgOptions& options = {},
                      const Control& control = Control{}) {
  write_file(path, [&](TextSink& out) { out << detail::SvgPicture(mesh, options).draw(); }, control);
}

}  // namespace delref
