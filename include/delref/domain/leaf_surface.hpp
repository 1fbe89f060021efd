// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface in some cells of a regular grid, those that are known to hold all of it: which grid edges it crosses, which
// crossings belong to one component, and which connected cells it does not show in. The sparse sister of sampled_components.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/disjoint_sets.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/surface_edges.hpp>

namespace delref::detail {

/// A cell, or a node, of a grid, in the order of layers.
struct GridCell {
  std::uint32_t x = 0, y = 0, z = 0;
  friend bool operator==(const GridCell&, const GridCell&) = default;
  friend auto operator<=>(const GridCell& a, const GridCell& b) {
    if (const auto order = a.z <=> b.z; order != 0) return order;
    if (const auto order = a.y <=> b.y; order != 0) return order;
    return a.x <=> b.x;
  }
};

/// A box cut into equal cells.
struct CellGrid {
  BoundingBox3 box;
  GridCell count;

  Point3 node(GridCell at) const {
    const auto place = [](double low, double high, std::uint32_t i, std::uint32_t n) {
      return i == n ? high : low + i * ((high - low) / n);
    };
    return {place(box.low.x, box.high.x, at.x, count.x), place(box.low.y, box.high.y, at.y, count.y),
            place(box.low.z, box.high.z, at.z, count.z)};
  }
};

/// Cells are numbered from 1 here, so that there is a layer 0, and one after the last, for what is beyond the box.
template <Oracle O>
class LeafSurface {
 public:
  LeafSurface(const O& oracle, const CellGrid& grid, std::vector<GridCell> cells)
      : oracle_(oracle), grid_(grid), cells_(std::move(cells)), surface_(oracle) {
    for (GridCell& cell : cells_) ++cell.x, ++cell.y, ++cell.z;
    add_cells_beyond();
    std::ranges::sort(cells_);
    cells_.erase(std::ranges::unique(cells_).begin(), cells_.end());
  }

  SurfaceComponents components(double size, const Control& control) {
    number_corners();
    throw_if_stopped(control);
    ask(control);
    edge_.assign(3 * nodes_.size(), SurfaceEdges<O>::none);
    StopCheck check(control);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) find_edges(cell), check();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) join_faces(cell), check();
    SurfaceComponents found;
    found.components = surface_.seeds(1e-6 * size, control);
    found.method = "by interval arithmetic down to boxes of size " + describe(size);
    if (const std::size_t hidden = clusters_without_surface(); hidden > 0)
      found.method += ", where " + count_of(hidden, "group of boxes", "groups of boxes") + " may hold a component smaller than " +
                      describe(size);
    return found;
  }

 private:
  /// Corner c of a cell is displaced by the bits of c.
  using Corners = std::array<std::uint32_t, 8>;

  /// Each cell at the bounds has neighbours beyond them, which are outside.
  void add_cells_beyond() {
    const std::size_t count = cells_.size();
    const auto shifts = [](std::uint32_t i, std::uint32_t n) {
      return std::pair<std::uint32_t, std::uint32_t>{i == 1 ? 0 : i, i == n ? n + 1 : i};
    };
    for (std::size_t i = 0; i < count; ++i) {
      const GridCell cell = cells_[i];
      const auto [x0, x1] = shifts(cell.x, grid_.count.x);
      const auto [y0, y1] = shifts(cell.y, grid_.count.y);
      const auto [z0, z1] = shifts(cell.z, grid_.count.z);
      for (std::uint32_t z = z0; z <= z1; ++z)
        for (std::uint32_t y = y0; y <= y1; ++y)
          for (std::uint32_t x = x0; x <= x1; ++x)
            if (const GridCell beyond{x, y, z}; beyond != cell) cells_.push_back(beyond);
    }
  }

  /// Walks the cells layer by layer with a table of the nodes below and one of the nodes above the layer.
  void number_corners() {
    const std::size_t row = grid_.count.x + 3;
    std::vector<std::uint32_t> below, above;
    const auto clear = [&](auto& table) { table.assign(row * (grid_.count.y + 3), SurfaceEdges<O>::none); };
    clear(below), clear(above);
    std::uint32_t layer = 0;
    corners_.resize(cells_.size());
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const GridCell cell = cells_[i];
      if (cell.z != layer) {
        if (cell.z == layer + 1)
          std::swap(below, above);
        else
          clear(below);
        clear(above);
        layer = cell.z;
      }
      for (std::uint32_t c = 0; c < 8; ++c) {
        const GridCell node{cell.x + (c & 1), cell.y + (c >> 1 & 1), cell.z + (c >> 2)};
        std::uint32_t& number = (c < 4 ? below : above)[node.y * row + node.x];
        if (number == SurfaceEdges<O>::none) {
          number = static_cast<std::uint32_t>(nodes_.size());
          nodes_.push_back(node);
        }
        corners_[i][c] = number;
      }
    }
  }

  bool is_beyond(GridCell node) const {
    const auto beyond = [](std::uint32_t i, std::uint32_t n) { return i == 0 || i == n + 2; };
    return beyond(node.x, grid_.count.x) || beyond(node.y, grid_.count.y) || beyond(node.z, grid_.count.z);
  }
  Point3 place(GridCell node) const {
    const auto inside = [](std::uint32_t i, std::uint32_t n) { return std::clamp(i, 1U, n + 1) - 1; };
    return grid_.node({inside(node.x, grid_.count.x), inside(node.y, grid_.count.y), inside(node.z, grid_.count.z)});
  }

  void ask(const Control& control) {
    labels_.assign(nodes_.size(), outside);
    std::vector<Point3> points(std::min<std::size_t>(nodes_.size(), 4096));
    for (std::size_t from = 0; from < nodes_.size(); from += points.size()) {
      const std::size_t count = std::min(points.size(), nodes_.size() - from);
      for (std::size_t i = 0; i < count; ++i) points[i] = place(nodes_[from + i]);
      oracle_.label(std::span<const Point3>(points).first(count), std::span(labels_).subspan(from, count));
      throw_if_stopped(control);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (is_beyond(nodes_[i])) labels_[i] = outside;
  }

  void find_edges(std::size_t cell) {
    for (std::uint32_t c = 0; c < 8; ++c)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if (c >> axis & 1) continue;
        const std::uint32_t from = corners_[cell][c], to = corners_[cell][c | 1U << axis];
        std::uint32_t& edge = edge_[3 * from + axis];
        if (labels_[from] != labels_[to] && edge == SurfaceEdges<O>::none)
          edge = surface_.add(place(nodes_[from]), place(nodes_[to]), labels_[from]);
      }
  }

  void join_faces(std::size_t cell) {
    const Corners& corners = corners_[cell];
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::uint32_t side = 0; side < 2; ++side) {
        const std::uint32_t c = side << axis;
        const std::array<std::uint32_t, 4> nodes{corners[c], corners[c | 1U << u], corners[c | 1U << u | 1U << v],
                                                 corners[c | 1U << v]};
        surface_.join_face({edge_[3 * nodes[0] + u], edge_[3 * nodes[1] + v], edge_[3 * nodes[3] + u], edge_[3 * nodes[0] + v]},
                           {labels_[nodes[0]], labels_[nodes[1]], labels_[nodes[2]], labels_[nodes[3]]}, place(nodes_[nodes[0]]),
                           place(nodes_[nodes[2]]));
      }
    }
  }

  /// How many sets of cells that touch have corners of one label only.
  std::size_t clusters_without_surface() const {
    DisjointSets sets;
    std::vector<std::uint32_t> first_cell(nodes_.size(), SurfaceEdges<O>::none);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      const std::uint32_t number = sets.add();
      for (const std::uint32_t node : corners_[cell]) {
        if (first_cell[node] == SurfaceEdges<O>::none) first_cell[node] = number;
        sets.unite(first_cell[node], number);
      }
    }
    std::vector<bool> shows(cells_.size(), false);
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
      if (std::ranges::any_of(corners_[cell], [&](std::uint32_t node) { return labels_[node] != labels_[corners_[cell][0]]; }))
        shows[sets.find(cell)] = true;
    std::size_t count = 0;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell)
      if (sets.find(cell) == cell && !shows[cell]) ++count;
    return count;
  }

  const O& oracle_;
  CellGrid grid_;
  std::vector<GridCell> cells_, nodes_;
  std::vector<Corners> corners_;
  std::vector<int> labels_;
  std::vector<std::uint32_t> edge_;
  SurfaceEdges<O> surface_;
};

}  // namespace delref::detail
