// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a place is on the surface up to a small distance, by the regions around it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <delref/mesh/verify_smooth/subject.hpp>

namespace delref::verification_smooth {

/// Asks for the regions at a place and on three small spheres around it.
template <Oracle O>
class SurfaceProbe {
 public:
  explicit SurfaceProbe(Questions<O>& questions) : questions_(&questions) {
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const int n = x * x + y * y + z * z; n != 0) directions_.push_back((1 / std::sqrt(n)) * Vector3{double(x), double(y), double(z)});
  }
  /// Whether two regions, or one and the outside, are within a distance. `normal` is a direction that is tried besides.
  bool finds_change(Point3 place, Vector3 normal, double distance) {
    ask(place, normal, distance);
    return std::ranges::any_of(regions_, [&](int r) { return r != regions_.front(); });
  }
  /// Whether that region is.
  bool finds_region(Point3 place, double distance, int region) {
    ask(place, {1, 0, 0}, distance);
    return std::ranges::find(regions_, region) != regions_.end();
  }

 private:
  void ask(Point3 place, Vector3 normal, double distance) {
    places_.assign(1, place);
    for (const double part : {1.0, 1.0 / 8, 1.0 / 64}) {
      for (const Vector3 d : directions_) places_.push_back(place + (part * distance) * d);
      places_.push_back(place + (part * distance) * normal);
      places_.push_back(place + (-part * distance) * normal);
    }
    regions_.resize(places_.size());
    questions_->regions(places_, regions_);
  }

  Questions<O>* questions_;
  std::vector<Vector3> directions_;
  std::vector<Point3> places_;
  std::vector<int> regions_;
};

}  // namespace delref::verification_smooth
