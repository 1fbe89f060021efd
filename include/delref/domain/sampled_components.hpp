// SPDX-License-Identifier: GPL-3.0-or-later
//
// The connected components of the surfaces of any oracle, as far as labels on a regular grid tell: the surface crosses the edges
// of the grid whose ends differ.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/surface_edges.hpp>

namespace delref {

namespace detail {

/// The coordinates of grid nodes along one axis: from the low side of the box to the high one, and one more at each end, at the
/// same place, that stands for what is beyond the box.
inline std::vector<double> grid_coordinates(double low, double high, double distance) {
  const double cells = std::max(1.0, std::ceil((high - low) / distance * (1 - 1e-9)));
  if (!(cells < 1 << 16))
    throw InvalidInput("the sampling distance " + describe(distance) + " is too small: the bounds are " + describe(cells) +
                       " times as long");
  const auto count = static_cast<std::size_t>(cells);
  std::vector<double> coordinates{low};
  for (std::size_t i = 0; i < count; ++i) coordinates.push_back(low + static_cast<double>(i) * ((high - low) / cells));
  coordinates.insert(coordinates.end(), {high, high});
  return coordinates;
}

/// Walks the grid layer by layer, keeping two layers of labels and every edge that the surface crosses.
template <Oracle O>
class GridSampler {
  static constexpr std::uint32_t none = SurfaceEdges<O>::none;
  struct Layer {
    std::vector<int> labels;
    /// The crossed edge from each node to the next one in x, in y, and down to the layer before; or `none`.
    std::array<std::vector<std::uint32_t>, 3> edges;
  };

 public:
  GridSampler(const O& oracle, double distance) : oracle_(oracle), distance_(distance), surface_(oracle) {
    const BoundingBox3 box = oracle.bounds();
    x_ = grid_coordinates(box.low.x, box.high.x, distance);
    y_ = grid_coordinates(box.low.y, box.high.y, distance);
    z_ = grid_coordinates(box.low.z, box.high.z, distance);
  }

  SurfaceComponents run(const Control& control) {
    Layer below, layer = empty_layer();
    for (std::size_t k = 1; k < z_.size(); ++k) {
      below = std::exchange(layer, empty_layer());
      if (k + 1 < z_.size()) ask(k, layer, control);
      find_edges(k, below, layer);
      join_faces(k, below, layer);
      throw_if_stopped(control);
    }
    return {surface_.seeds(1e-6 * distance_, control), "by samples " + describe(distance_) + " apart", false};
  }

 private:
  std::size_t node(std::size_t i, std::size_t j) const { return j * x_.size() + i; }
  Point3 point(std::size_t i, std::size_t j, std::size_t k) const { return {x_[i], y_[j], z_[k]}; }

  Layer empty_layer() const {
    Layer layer;
    layer.labels.assign(x_.size() * y_.size(), outside);
    for (auto& edges : layer.edges) edges.assign(layer.labels.size(), none);
    return layer;
  }

  void ask(std::size_t k, Layer& layer, const Control& control) const {
    std::vector<Point3> row(x_.size() - 2);
    for (std::size_t j = 1; j + 1 < y_.size(); ++j) {
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = point(i + 1, j, k);
      oracle_.label(std::span<const Point3>(row), std::span(layer.labels).subspan(node(1, j), row.size()));
      throw_if_stopped(control);
    }
  }

  void find_edges(std::size_t k, const Layer& below, Layer& layer) {
    const auto cross = [&](std::uint32_t& edge, int label_a, int label_b, Point3 a, Point3 b) {
      if (label_a != label_b) edge = surface_.add(a, b, label_a);
    };
    for (std::size_t j = 0; j < y_.size(); ++j)
      for (std::size_t i = 0; i < x_.size(); ++i) {
        const std::size_t n = node(i, j);
        const int label = layer.labels[n];
        if (i + 1 < x_.size()) cross(layer.edges[0][n], label, layer.labels[n + 1], point(i, j, k), point(i + 1, j, k));
        if (j + 1 < y_.size()) cross(layer.edges[1][n], label, layer.labels[n + x_.size()], point(i, j, k), point(i, j + 1, k));
        cross(layer.edges[2][n], label, below.labels[n], point(i, j, k), point(i, j, k - 1));
      }
  }

  void join_faces(std::size_t k, const Layer& below, const Layer& layer) {
    for (std::size_t j = 0; j < y_.size(); ++j)
      for (std::size_t i = 0; i < x_.size(); ++i) {
        const std::size_t n = node(i, j), nx = n + 1, ny = n + x_.size();
        const bool has_x = i + 1 < x_.size(), has_y = j + 1 < y_.size();
        const auto& [ex, ey, ez] = layer.edges;
        if (has_x && has_y)
          surface_.join_face({ex[n], ey[nx], ex[ny], ey[n]},
                             {layer.labels[n], layer.labels[nx], layer.labels[ny + 1], layer.labels[ny]}, point(i, j, k),
                             point(i + 1, j + 1, k));
        if (has_x)
          surface_.join_face({ex[n], ez[nx], below.edges[0][n], ez[n]},
                             {layer.labels[n], layer.labels[nx], below.labels[nx], below.labels[n]}, point(i, j, k),
                             point(i + 1, j, k - 1));
        if (has_y)
          surface_.join_face({ey[n], ez[ny], below.edges[1][n], ez[n]},
                             {layer.labels[n], layer.labels[ny], below.labels[ny], below.labels[n]}, point(i, j, k),
                             point(i, j + 1, k - 1));
      }
  }

  const O& oracle_;
  double distance_;
  std::vector<double> x_, y_, z_;
  SurfaceEdges<O> surface_;
};

}  // namespace detail

/// The components of the surfaces that labels at the nodes of a grid tell of: each with up to `most_seeds` points of the surface.
/// What is beyond the bounds of the oracle counts as outside. A component that no edge of the grid crosses is missed, and two
/// that come closer than the distance may be taken for one. Asks for some (extent / distance)^3 labels, in batches; keeps only
/// the edges that cross the surface. Throws `InvalidInput` when the distance is not positive or the bounds are more than 65,000
/// times as long, `Interrupted` when the control says stop.
template <Oracle O>
SurfaceComponents sample_components(const O& oracle, double distance, const Control& control) {
  if (!(distance > 0)) throw InvalidInput("the sampling distance " + describe(distance) + " is no positive length");
  return detail::GridSampler<O>(oracle, distance).run(control);
}

}  // namespace delref
