// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is being verified, and the oracle as the checks ask it: at scaled coordinates, and never outside the bounds of the domain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <delref/algorithms/smooth_options.hpp>
#include <delref/core/budget.hpp>
#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/oracle.hpp>
#include <delref/domain/plc.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>
#include <delref/mesh/verify_3/criteria.hpp>
#include <delref/mesh/verify_3/subject.hpp>
#include <delref/mesh/verify_smooth/expectations.hpp>

namespace delref::verification_smooth {

using verification_3::Index;
using verification_3::none;

/// A smooth domain has no input elements.
struct NoInput {
  Plc nothing;
  PolyhedralCriteria no_criteria;
};

struct Subject : private NoInput, verification_3::Subject {
  Subject(const TetrahedralMesh& its_mesh, const SmoothOptions& its_options, const SmoothExpectations& its_expectations,
          const Control& its_control)
      : verification_3::Subject{nothing, its_mesh, no_criteria, its_control}, options(its_options), expected(its_expectations) {
    nothing.first_index = expected.first_index;
  }
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  const SmoothOptions& options;
  const SmoothExpectations& expected;

  using verification_3::Subject::triangle;
  std::string triangle(std::size_t t) const {
    return fmt::format("triangle {} (vertices {}, {}, {}) around {}", number(t), number(mesh.triangles[t][0]), number(mesh.triangles[t][1]),
                       number(mesh.triangles[t][2]), place(original(barycentre(t))));
  }
  std::array<Point3, 3> corners(std::size_t t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return {points[a], points[b], points[c]};
  }
  Point3 barycentre(std::size_t t) const {
    const auto [a, b, c] = corners(t);
    return a + (1.0 / 3) * ((b - a) + (c - a));
  }
};

/// The region of no triangle or tetrahedron: a label that the oracle does not know.
inline constexpr int unknown_region = -2;

template <Oracle O>
class Questions {
 public:
  Questions(const O& oracle, const PowerOfTwoScaling& scaling)
      : oracle_(&oracle), scaling_(&scaling), bounds_(oracle.bounds()), unit_(scaling.original_length(1)) {
    if constexpr (requires { oracle.region_labels(); })
      for (const int label : oracle.region_labels()) labels_.push_back(label);
  }

  /// The number of the region at scaled places; what is out of bounds is outside.
  void regions(std::span<const Point3> places, std::span<int> regions) {
    asked_.clear(), which_.clear();
    for (std::size_t i = 0; i < places.size(); ++i) {
      regions[i] = outside;
      const Point3 p{unit_ * places[i].x, unit_ * places[i].y, unit_ * places[i].z};
      if (!is_in_bounds(p)) continue;
      asked_.push_back(p);
      which_.push_back(i);
    }
    answers_.resize(asked_.size());
    oracle_->label(std::span<const Point3>(asked_), std::span<int>(answers_));
    for (std::size_t i = 0; i < asked_.size(); ++i) regions[which_[i]] = answers_[i];
  }
  int region(Point3 place) {
    int answer = outside;
    regions(std::span<const Point3>(&place, 1), std::span<int>(&answer, 1));
    return answer;
  }

  /// The label of a region in the mesh: the oracle's name for it, or one more than its number.
  int label(int region) const {
    return region >= 0 && static_cast<std::size_t>(region) < labels_.size() ? labels_[static_cast<std::size_t>(region)] : region + 1;
  }
  /// The number of the region of that label.
  int number(int label) const {
    const auto found = std::ranges::find(labels_, label);
    if (found != labels_.end()) return static_cast<int>(found - labels_.begin());
    const int number = label - 1;
    return number < 0 || static_cast<std::size_t>(number) < labels_.size() ? unknown_region : number;
  }
  std::string words(int region) const { return region == outside ? "the outside" : fmt::format("region {}", label(region)); }

  /// The bounds, scaled.
  BoundingBox3 bounds() const { return {(*scaling_)(bounds_.low), (*scaling_)(bounds_.high)}; }
  const O& oracle() const { return *oracle_; }

 private:
  bool is_in_bounds(Point3 p) const {
    const auto& [low, high] = bounds_;
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
  }

  const O* oracle_;
  const PowerOfTwoScaling* scaling_;
  BoundingBox3 bounds_;
  double unit_;  // a power of two
  std::vector<int> labels_;
  std::vector<Point3> asked_;  // scratch, as are these two
  std::vector<std::size_t> which_;
  std::vector<int> answers_;
};

/// The regions on the two sides of a triangle: its normal points to the one in front.
struct Sides {
  int behind = unknown_region, front = unknown_region;
  friend auto operator<=>(const Sides&, const Sides&) = default;
};

}  // namespace delref::verification_smooth
