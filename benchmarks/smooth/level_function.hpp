// SPDX-License-Identifier: GPL-3.0-or-later
//
// A function that is negative inside and its gradient, from a name or an image, and the way from a point to its nearest zero. For
// measuring: slow, careful, and no code of a mesher.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include <CGAL/Image_3.h>

#include "surfaces.hpp"

namespace benchmark {

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vector a) { return std::sqrt(dot(a, a)); }

struct LevelFunction {
  std::function<double(Vector)> value;
  std::function<Vector(Vector)> gradient;
};

/// The trilinear function through the values at the points of an image's grid; 0 outside the grid, as CGAL has it.
class Trilinear {
 public:
  explicit Trilinear(const CGAL::Image_3& image)
      : size_{image.xdim(), image.ydim(), image.zdim()},
        spacing_{image.vx(), image.vy(), image.vz()},
        origin_{image.tx(), image.ty(), image.tz()} {
    for (std::size_t k = 0; k != size_[2]; ++k)
      for (std::size_t j = 0; j != size_[1]; ++j)
        for (std::size_t i = 0; i != size_[0]; ++i) values_.push_back(static_cast<double>(image.value(i, j, k)));
  }

  double value(Vector p) const { return at(p).value; }
  Vector gradient(Vector p) const { return at(p).gradient; }

 private:
  struct Place {
    double value = 0;
    Vector gradient;
  };

  Place at(Vector p) const {
    const std::array<double, 3> x{(p.x - origin_.x) / spacing_.x, (p.y - origin_.y) / spacing_.y, (p.z - origin_.z) / spacing_.z};
    std::array<std::size_t, 3> cell{};
    std::array<std::array<double, 2>, 3> weight{};
    for (std::size_t axis = 0; axis != 3; ++axis) {
      if (!(x[axis] >= 0 && x[axis] <= static_cast<double>(size_[axis] - 1))) return {};
      cell[axis] = std::min(static_cast<std::size_t>(x[axis]), size_[axis] - 2);
      const double t = x[axis] - static_cast<double>(cell[axis]);
      weight[axis] = {1 - t, t};
    }
    Place result;
    for (std::size_t corner = 0; corner != 8; ++corner) {
      const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      const double v = values_[((cell[2] + k) * size_[1] + cell[1] + j) * size_[0] + cell[0] + i];
      const double a = weight[0][i], b = weight[1][j], c = weight[2][k];
      result.value += a * b * c * v;
      const Vector slope{(i ? b * c : -b * c) / spacing_.x, (j ? a * c : -a * c) / spacing_.y, (k ? a * b : -a * b) / spacing_.z};
      result.gradient = result.gradient + v * slope;
    }
    return result;
  }

  std::array<std::size_t, 3> size_;
  Vector spacing_, origin_;
  std::vector<double> values_;
};

/// The function of a driver's DOMAIN.
inline LevelFunction level_function(std::string_view domain) {
  LevelFunction result;
  const bool is_named = visit_surface(domain, [&]<class Surface>(Surface) { result = {&Surface::value, &Surface::gradient}; });
  if (is_named) return result;
  const LevelSet set = level_set(domain);
  CGAL::Image_3 image;
  if (!image.read(set.image.c_str())) throw std::runtime_error("cannot read " + set.image);
  const auto trilinear = std::make_shared<const Trilinear>(image);
  const double level = static_cast<double>(set.value);
  return {[=](Vector p) { return level - trilinear->value(p); }, [=](Vector p) { return -1.0 * trilinear->gradient(p); }};
}

inline constexpr double unreached = std::numeric_limits<double>::infinity();

/// The parameter, of least size as far as steps that double can tell, at which a line from p along a unit vector meets the
/// surface; `unreached` when it does not within `reach`. `first` is the length of the first step.
inline double meet(const LevelFunction& f, Vector p, Vector along, double first, double reach) {
  const double at_p = f.value(p);
  if (at_p == 0) return 0;
  double best = unreached;
  for (const double way : {1.0, -1.0}) {
    double near = 0, f_near = at_p;
    for (double far = std::min(first, reach); near < std::min(reach, std::abs(best)); far = std::min(2 * far, reach)) {
      const double f_far = f.value(p + way * far * along);
      if ((f_far < 0) != (at_p < 0)) {
        double low = near, high = far, f_low = f_near, f_high = f_far;
        for (int i = 0; i != 100 && high - low > 1e-13 * reach; ++i) {  // the Illinois method, with a bisection each third step
          double middle = i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * (f_low / (f_low - f_high));
          if (!(middle > low && middle < high)) middle = 0.5 * (low + high);
          const double f_middle = f.value(p + way * middle * along);
          if ((f_middle < 0) == (at_p < 0))
            low = middle, f_low = f_middle, f_high *= 0.5;
          else
            high = middle, f_high = f_middle, f_low *= 0.5;
        }
        if (high < std::abs(best)) best = way * high;
        break;
      }
      near = far, f_near = f_far;
    }
  }
  return best;
}

/// The distance from p to the surface: the least found along the gradient at p and along `normal`, then again along the gradient
/// where that met the surface, which ends where the way is at right angles to the surface. `unreached` when nothing is met within
/// `reach`.
inline double distance(const LevelFunction& f, Vector p, Vector normal, double reach) {
  const Vector slope = f.gradient(p);
  const double steepness = length(slope);
  const double first = steepness > 0 ? std::max(1.1 * std::abs(f.value(p)) / steepness, 1e-6 * reach) : 1e-3 * reach;
  double best = unreached;
  for (Vector way : {slope, normal}) {
    double last = unreached;
    for (int i = 0; i != 6; ++i) {
      const double size = length(way);
      if (!(size > 0)) break;
      way = (1 / size) * way;
      const double t = meet(f, p, way, first, reach);
      best = std::min(best, std::abs(t));
      if (!(std::abs(t) < last * (1 - 1e-6))) break;
      last = std::abs(t);
      way = f.gradient(p + t * way);
    }
  }
  return best;
}

}  // namespace benchmark
