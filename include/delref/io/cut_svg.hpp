// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a tetrahedral mesh cut open: the tetrahedra on the near side of a plane are taken away, and the faces of the others are drawn
// from behind to the front (the painter's algorithm), shaded by their direction. Of a mesh without tetrahedra its triangles are drawn.
// What others hide is found beforehand on a raster, and left out, so that the file is as large as what is seen of the mesh.
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
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/io/colours.hpp>
#include <delref/io/file.hpp>
#include <delref/io/svg_path.hpp>
#include <delref/mesh/scaling.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

namespace delref {

/// How to cut and from where to look.
struct CutSvgOptions {
  /// The direction in which the tetrahedra are taken away, towards the viewer, of any length. Zero: the axis along which the mesh is
  /// shortest, which makes the cut large.
  Vector3 normal{};
  /// Where the plane stands between the far end of the mesh (0) and the near one (1).
  double position = 0.55;
  /// How far the viewer stands aside of the normal, to the right and upwards, in degrees.
  double turn = 22, tilt = 16;
  /// The longer side of the picture of the mesh, in pixels; a line about the mesh comes below.
  double size = 900;
  /// The line below; empty: counts of the mesh.
  std::string title;
};

namespace detail {

/// One picture of a cut.
class CutPicture {
 public:
  CutPicture(const TetrahedralMesh& mesh, const CutSvgOptions& options, const Control& control)
      : mesh_(mesh), options_(options), control_(control), points_(PowerOfTwoScaling(largest_absolute_coordinate(mesh.points))(mesh.points)) {
    choose_view();
    for (const int label : mesh.regions) ranks_.try_emplace(label, 0);
    std::size_t rank = 0;
    for (auto& [label, place] : ranks_) place = rank++;
    if (mesh.tetrahedra.empty()) collect_triangles();
    else collect_faces();
  }

  std::string draw() {
    std::vector<Point2> seen;
    for (const Face& f : faces_)
      for (const auto i : f.corners) seen.push_back(plane_[i]);
    const SvgFrame frame(seen, options_.size);
    std::vector<SvgFrame::Corner> corners(points_.size());
    for (const Face& f : faces_)
      for (const auto i : f.corners) corners[i] = frame(plane_[i]);
    std::int32_t pixel = 10;
    keep_visible(frame, corners, pixel);
    while (faces_.size() > most_faces) keep_visible(frame, corners, pixel *= 2);
    return text(frame, corners, pixel);
  }

 private:
  struct Face {
    std::array<std::uint32_t, 3> corners;  ///< counterclockwise, seen from outside
    double depth = 0;                      ///< of its middle, growing towards the viewer
    std::uint16_t colour = 0;              ///< a shade, of a region, of its surface or its cut
  };
  static constexpr std::size_t most_faces = 60'000;
  static constexpr std::uint16_t shades = 32;

  static Vector3 unit(Vector3 v) { return 1 / std::sqrt(squared_length(v)) * v; }
  /// A frame of the picture: to the right, upwards, towards the viewer.
  void choose_view() {
    Point3 low, high;
    if (!points_.empty()) low = high = points_.front();
    for (const Point3 p : points_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vector3 box = high - low;
    normal_ = options_.normal;
    if (!(squared_length(normal_) > 0))
      normal_ = box.z <= box.x && box.z <= box.y ? Vector3{0, 0, 1} : box.y <= box.x ? Vector3{0, -1, 0} : Vector3{1, 0, 0};
    normal_ = unit(normal_);
    const Vector3 up = std::abs(normal_.z) > 0.9 ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
    const Vector3 right = unit(cross(up, normal_));
    constexpr double degree = 3.14159265358979324 / 180;
    const double turn = options_.turn * degree, tilt = options_.tilt * degree;
    towards_ = std::cos(tilt) * (std::cos(turn) * normal_ + std::sin(turn) * right) + std::sin(tilt) * cross(normal_, right);
    right_ = unit(cross(cross(normal_, right), towards_));
    up_ = cross(towards_, right_);
    light_ = unit(towards_ - 0.5 * right_ + 0.7 * up_);

    double near = -std::numeric_limits<double>::infinity(), far = -near;
    plane_.reserve(points_.size());
    for (const Point3 p : points_) {
      const Vector3 v = p - Point3{};
      plane_.push_back({dot(v, right_), dot(v, up_)});
      near = std::max(near, dot(v, normal_)), far = std::min(far, dot(v, normal_));
    }
    cut_ = far + options_.position * (near - far);
  }
  bool is_kept(const std::array<std::uint32_t, 4>& t) const {
    double sum = 0;
    for (const auto i : t) sum += dot(points_[i] - Point3{}, normal_);
    return sum <= 4 * cut_;
  }

  /// The faces of kept tetrahedra that no other kept one has, as far as they look at the viewer. All are kept when nothing else is.
  void collect_faces() {
    struct Side {
      std::array<std::uint32_t, 3> sorted, corners;
      std::uint32_t tetrahedron;
      bool kept;
    };
    bool all = true;
    for (const auto& t : mesh_.tetrahedra) all = all && !is_kept(t);
    std::vector<Side> sides;
    sides.reserve(4 * mesh_.tetrahedra.size());
    for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
      if (t % 8192 == 0) throw_if_stopped(control_);
      const auto& [a, b, c, d] = mesh_.tetrahedra[t];
      const bool kept = all || is_kept(mesh_.tetrahedra[t]);
      for (std::array<std::uint32_t, 3> f : {std::array{a, c, b}, {a, b, d}, {b, c, d}, {a, d, c}}) {
        const auto corners = f;
        std::ranges::sort(f);
        sides.push_back({f, corners, t, kept});
      }
    }
    StopCheck check(control_);
    std::ranges::sort(sides, [&](const Side& a, const Side& b) {
      check();
      return a.sorted != b.sorted ? a.sorted < b.sorted : a.tetrahedron < b.tetrahedron;
    });
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].sorted == sides[i].sorted) ++end;
      const bool is_pair = end - i == 2;
      for (std::size_t k = i; k < end; ++k)
        if (sides[k].kept && !(is_pair && sides[2 * i + 1 - k].kept)) add_face(sides[k].corners, rank_of(sides[k].tetrahedron), is_pair);
      i = end;
    }
    std::ranges::stable_sort(faces_, {}, &Face::depth);
  }
  std::size_t rank_of(std::uint32_t tetrahedron) const {
    return mesh_.regions.empty() ? 0 : std::min<std::size_t>(ranks_.at(mesh_.regions[tetrahedron]), 1000);
  }
  /// Of a surface alone, both sides of the triangles behind the plane, or of all when none is: the inner side as a cut is.
  void collect_triangles() {
    const auto is_behind = [&](const std::array<std::uint32_t, 3>& t) {
      double sum = 0;
      for (const auto i : t) sum += dot(points_[i] - Point3{}, normal_);
      return sum <= 3 * cut_;
    };
    const bool all = std::ranges::none_of(mesh_.triangles, is_behind);
    StopCheck check(control_);
    for (const auto& t : mesh_.triangles) {
      check();
      if (!all && !is_behind(t)) continue;
      add_face(t, 0, false);
      add_face({t[0], t[2], t[1]}, 0, true);
    }
    std::ranges::stable_sort(faces_, {}, &Face::depth);
  }
  void add_face(const std::array<std::uint32_t, 3>& corners, std::size_t rank, bool is_cut) {
    const Point3 a = points_[corners[0]], b = points_[corners[1]], c = points_[corners[2]];
    const Vector3 n = cross(b - a, c - a);
    if (!(dot(n, towards_) > 0)) return;
    const double length = std::sqrt(squared_length(n)), light = std::max(0.0, dot(n, light_) / length);
    const auto shade = static_cast<std::uint16_t>(std::lround(light * (shades - 1)));
    const double depth = dot(a - Point3{}, towards_) + dot(b - Point3{}, towards_) + dot(c - Point3{}, towards_);
    faces_.push_back({corners, depth, static_cast<std::uint16_t>((2 * rank + (is_cut ? 1 : 0)) * shades + shade)});
  }

  /// Drops the faces that are nearest at the middle of no square of the raster, whose side is in steps of the frame.
  void keep_visible(const SvgFrame& frame, const std::vector<SvgFrame::Corner>& corners, std::int32_t side) {
    const auto columns = static_cast<std::int32_t>(frame.width() * SvgFrame::steps_per_pixel) / side + 1;
    const auto rows = static_cast<std::int32_t>(frame.height() * SvgFrame::steps_per_pixel) / side + 1;
    constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::pair<float, std::uint32_t>> raster(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                                                        {-std::numeric_limits<float>::infinity(), nobody});
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      if (i % 4096 == 0) throw_if_stopped(control_);
      const auto [ia, ib, ic] = faces_[i].corners;
      const auto a = corners[ia], b = corners[ib], c = corners[ic];
      const double area = SvgFrame::doubled_area(a, b, c);
      if (area == 0) continue;
      const auto depth = [&](std::uint32_t k) { return dot(points_[k] - Point3{}, towards_); };
      const auto first = [&](auto... v) { return std::max(0, (std::min({v...}) - side / 2) / side); };
      const auto last = [&](std::int32_t end, auto... v) { return std::min(end - 1, std::max({v...}) / side); };
      for (std::int32_t y = first(a.y, b.y, c.y); y <= last(rows, a.y, b.y, c.y); ++y)
        for (std::int32_t x = first(a.x, b.x, c.x); x <= last(columns, a.x, b.x, c.x); ++x) {
          const SvgFrame::Corner p{x * side + side / 2, y * side + side / 2};
          const double u = SvgFrame::doubled_area(p, b, c) / area, v = SvgFrame::doubled_area(a, p, c) / area, w = 1 - u - v;
          if (u < 0 || v < 0 || w < 0) continue;
          auto& square = raster[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
          const auto z = static_cast<float>(u * depth(ia) + v * depth(ib) + w * depth(ic));
          if (z > square.first) square = {z, i};
        }
    }
    std::vector<bool> is_seen(faces_.size());
    for (const auto& [z, i] : raster)
      if (i != nobody) is_seen[i] = true;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (is_seen[i]) faces_[kept++] = faces_[i];
    faces_.resize(kept);
  }

  /// The cut in the colour of the region, the surface in a pale one.
  static Colour fill(std::uint16_t colour) {
    const std::size_t kind = colour / shades;
    const double light = static_cast<double>(colour % shades) / (shades - 1);
    const Colour region = region_colour(kind / 2);
    const Colour base = kind % 2 == 1 ? region : mix(region, {0.93, 0.91, 0.87}, 0.8);
    return mix(mix(base, {0.10, 0.16, 0.22}, 0.5), mix(base, {1, 1, 1}, 0.25), light);
  }
  std::string text(const SvgFrame& frame, const std::vector<SvgFrame::Corner>& corners, std::int32_t pixel) const {
    constexpr double line_height = 28;
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "font-family=\"Helvetica, Arial, sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        frame.width(), frame.height() + line_height);
    const double side = std::sqrt(frame.width() * frame.height() / (static_cast<double>(faces_.size()) + 1)) * SvgFrame::steps_per_pixel;
    out += fmt::format("<g transform=\"scale({})\" stroke=\"#22303a\" stroke-opacity=\"0.55\" stroke-linejoin=\"round\" stroke-width=\"{:.3g}\">\n",
                       1 / SvgFrame::steps_per_pixel, std::clamp(0.045 * side, 0.1 * pixel, 9.0));
    for (std::size_t i = 0; i < faces_.size();) {
      SvgPath path;
      const std::uint16_t colour = faces_[i].colour;
      for (; i < faces_.size() && faces_[i].colour == colour; ++i) {
        const auto [a, b, c] = faces_[i].corners;
        path.add({corners[a], corners[b], corners[c]}, true);
      }
      out += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", fill(colour).hex(), path.text());
    }
    const std::string counts = mesh_.tetrahedra.empty() && !mesh_.triangles.empty() ? fmt::format("{} triangles, {} vertices", mesh_.triangles.size(), mesh_.points.size())
                                                        : fmt::format("{} tetrahedra, {} vertices", mesh_.tetrahedra.size(), mesh_.points.size());
    out += fmt::format("</g>\n<text x=\"20\" y=\"{:.0f}\" font-size=\"13\" fill=\"#22303a\">{}</text>\n</svg>\n", frame.height() + 10,
                       escaped(options_.title.empty() ? counts : options_.title));
    return out;
  }
  static std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
      if (c == '<') result += "&lt;";
      else if (c == '&') result += "&amp;";
      else result += c;
    return result;
  }

  const TetrahedralMesh& mesh_;
  const CutSvgOptions& options_;
  const Control& control_;
  std::vector<Point3> points_;  // scaled
  std::vector<Point2> plane_;   // of the picture
  Vector3 normal_, towards_, right_, up_, light_;
  double cut_ = 0;
  std::map<int, std::size_t> ranks_;  // of region labels
  std::vector<Face> faces_;           // from behind to the front
};

}  // namespace detail

/// Draws a mesh that is cut open by a plane. Faces of tetrahedra that the plane would cross are drawn whole: the cut is as rough as
/// the mesh. O(n log n). Requires valid indices and finite coordinates. Throws `OutputError`, and `Interrupted` when the control says
/// stop before it is drawn.
inline void write_cut_svg(const std::filesystem::path& path, const TetrahedralMesh& mesh, const CutSvgOptions& options = {},
                          const Control& control = Control{}) {
  write_file(path, [&](TextSink& out) { out << detail::CutPicture(mesh, options, control).draw(); }, control);
}

}  // namespace delref
