// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary surfaces of the regions of a labelled image, from its voxels. A region is connected where its voxels share faces; each
// connected part of it has one outer boundary and one for each cavity, which are closed surfaces made of faces of voxels. They are
// followed from face to face around the region's own voxels (Artzy, Frieder, Herman, "The theory, design, implementation and
// evaluation of a three-dimensional surface detection algorithm", 1981), but with union-find, so that the order does not matter.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/disjoint_sets.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/voxel_labels.hpp>

namespace delref::detail {

/// One side of a face between voxels of different labels: the voxel that it belongs to, and the direction of the face from its centre
/// (x, y, z: 0, 1, 2; and 3 more towards lower indices).
struct VoxelSide {
  std::array<int, 3> voxel{};
  int direction = 0;

  std::array<int, 3> beyond() const { return stepped(voxel, direction); }
  static std::array<int, 3> stepped(std::array<int, 3> voxel, int direction) {
    voxel[static_cast<std::size_t>(direction % 3)] += direction < 3 ? 1 : -1;
    return voxel;
  }
};

/// All sides of faces of the regions, which belong together where their boundary surfaces do.
class LabelBoundaries {
 public:
  LabelBoundaries(const VoxelLabels& labels, const Control& control) : labels_(labels) {
    list(control);
    sets_ = DisjointSets(sides_.size());
    StopCheck stop(control);
    for (std::uint32_t i = 0; i != sides_.size(); ++i) {
      stop();
      const VoxelSide side = sides_[i];
      for (int along = 0; along != 6; ++along) {
        if (along % 3 != side.direction % 3) sets_.unite(i, find(around_edge(side, along)));
      }
    }
  }

  /// The sides of each boundary surface. Where a surface is the boundary of two regions, all of it of both, it is given once.
  template <class Visit>
  void for_each_surface(Visit&& visit) {
    const DisjointSets::Groups groups = sets_.groups();
    std::vector<VoxelSide> surface;
    for (std::size_t i = 0; i + 1 < groups.begin.size(); ++i) {
      const std::span members(groups.members.data() + groups.begin[i], groups.begin[i + 1] - groups.begin[i]);
      if (is_told_by_other_side(members, groups)) continue;
      surface.clear();
      for (const std::uint32_t m : members) surface.push_back(sides_[m]);
      visit(std::span<const VoxelSide>(surface));
    }
  }

 private:
  int label(std::array<int, 3> v) const { return labels_(v[0], v[1], v[2]); }

  void list(const Control& control) {
    const auto [nx, ny, nz] = labels_.size();
    first_of_row_.reserve(static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) + 1);
    for (int z = 0; z != nz; ++z) {
      throw_if_stopped(control);
      for (int y = 0; y != ny; ++y) {
        first_of_row_.push_back(static_cast<std::uint32_t>(sides_.size()));
        for (int x = 0; x != nx; ++x) list_voxel({x, y, z});
        if (sides_.size() > std::numeric_limits<std::uint32_t>::max() - 1) {
          throw InvalidInput("the regions of the image have more than 4 billion faces of voxels; smooth or cut the image");
        }
      }
    }
    first_of_row_.push_back(static_cast<std::uint32_t>(sides_.size()));
  }
  void list_voxel(std::array<int, 3> voxel) {
    const int own = label(voxel);
    if (own == outside) return;
    for (int direction = 0; direction != 6; ++direction) {
      if (label(VoxelSide::stepped(voxel, direction)) != own) sides_.push_back({voxel, direction});
    }
  }

  std::uint32_t find(const VoxelSide& side) const {
    const std::size_t row = static_cast<std::size_t>(side.voxel[2]) * static_cast<std::size_t>(labels_.size()[1]) +
                            static_cast<std::size_t>(side.voxel[1]);
    const auto first = sides_.begin() + first_of_row_[row], last = sides_.begin() + first_of_row_[row + 1];
    const auto before = [](const VoxelSide& a, const VoxelSide& b) {
      return a.voxel[0] != b.voxel[0] ? a.voxel[0] < b.voxel[0] : a.direction < b.direction;
    };
    return static_cast<std::uint32_t>(std::lower_bound(first, last, side, before) - sides_.begin());
  }

  /// The side across the edge in direction `along`: around a convex edge, across a flat one, or into a concave one.
  VoxelSide around_edge(const VoxelSide& side, int along) const {
    const int own = label(side.voxel);
    const std::array<int, 3> beside = VoxelSide::stepped(side.voxel, along);
    if (label(beside) != own) return {side.voxel, along};
    const std::array<int, 3> above = VoxelSide::stepped(beside, side.direction);
    if (label(above) != own) return {beside, side.direction};
    return {above, (along + 3) % 6};
  }

  bool is_told_by_other_side(std::span<const std::uint32_t> members, const DisjointSets::Groups& groups) {
    std::uint32_t other = 0;
    for (std::size_t i = 0; i != members.size(); ++i) {
      const VoxelSide& side = sides_[members[i]];
      const std::array<int, 3> voxel = side.beyond();
      if (label(voxel) == outside) return false;
      const std::uint32_t root = sets_.find(find({voxel, (side.direction + 3) % 6}));
      if (i > 0 && root != other) return false;
      other = root;
    }
    if (other > members[0]) return false;  // the other one is told because of this one, if at all
    // `other` begins a set that is as large only if it is the same surface.
    // Sets are in the order of their smallest members.
    const auto begin = std::lower_bound(groups.begin.begin(), groups.begin.end() - 1, other,
                                        [&](std::size_t b, std::uint32_t wanted) { return groups.members[b] < wanted; });
    return *(begin + 1) - *begin == members.size();
  }

  const VoxelLabels& labels_;
  std::vector<VoxelSide> sides_;             // by z, y, x, direction
  std::vector<std::uint32_t> first_of_row_;  // of the row of voxels y, z
  DisjointSets sets_;
};

}  // namespace delref::detail
