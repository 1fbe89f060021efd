// SPDX-License-Identifier: GPL-3.0-or-later
//
// The system of linear equations of a Poisson reconstruction, in the shape in which CGAL fills it in, solved by conjugate gradients
// (Hestenes and Stiefel 1952) with the diagonal as preconditioner. It asks the control as it goes, and throws where CGAL would print.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref::detail {

/// A model of CGAL's `SparseLinearAlgebraTraits_d`, as far as `CGAL::Poisson_reconstruction_function` uses it, for symmetric positive
/// definite systems. The control must outlive it.
class PoissonSystem {
 public:
  using NT = double;

  class Vector {
   public:
    explicit Vector(std::size_t size) : values_(size) {}
    std::size_t size() const { return values_.size(); }
    double& operator[](std::size_t i) { return values_[i]; }
    double operator[](std::size_t i) const { return values_[i]; }

   private:
    std::vector<double> values_;
  };

  /// Rows as they are filled in, one after the other; a row may be left and not taken up again.
  class Matrix {
   public:
    explicit Matrix(std::size_t size) : diagonal_(size), begin_(size), end_(size) {}
    void set_coef(std::size_t row, std::size_t column, double value, bool = true) {
      if (row == column) {
        diagonal_[row] = value;
        return;
      }
      if (end_[row] == begin_[row]) begin_[row] = columns_.size();
      columns_.push_back(static_cast<std::uint32_t>(column));
      values_.push_back(value);
      end_[row] = columns_.size();
    }
    double diagonal(std::size_t row) const { return diagonal_[row]; }
    /// The product of a row with a vector.
    double times(std::size_t row, const Vector& x) const {
      double sum = diagonal_[row] * x[row];
      for (std::size_t i = begin_[row]; i != end_[row]; ++i) sum += values_[i] * x[columns_[i]];
      return sum;
    }

   private:
    std::vector<double> diagonal_, values_;
    std::vector<std::size_t> begin_, end_;
    std::vector<std::uint32_t> columns_;
  };

  explicit PoissonSystem(const Control& control) : control_(&control) {}

  /// Solves `a x = b`. Throws `InvalidInput` when that fails and `Interrupted` when the control says stop.
  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, double& scale) const {
    scale = 1;
    const std::size_t n = b.size();
    Vector residual = b, step(n), product(n);
    double rho = 0;  // the square of the residual, each row weighted by its diagonal: flat tetrahedra give rows of any size
    for (std::size_t i = 0; i != n; ++i) {
      x[i] = 0;
      step[i] = b[i] / a.diagonal(i);
      rho += b[i] * step[i];
    }
    const double enough = 1e-18 * rho, tolerable = 1e-10 * rho;
    for (std::size_t round = 0; rho > enough; ++round) {
      throw_if_stopped(*control_);
      if (round > 2 * n + 1000 && rho <= tolerable) break;
      double curvature = 0;
      for (std::size_t i = 0; i != n; ++i) {
        product[i] = a.times(i, step);
        curvature += step[i] * product[i];
      }
      const double length = rho / curvature;
      if (!std::isfinite(length) || round > 2 * n + 1000)
        throw InvalidInput("the reconstruction of a surface failed: the equations for its function could not be solved; look at the points "
                           "for places where many nearly coincide, and at their normals");
      double next = 0;
      for (std::size_t i = 0; i != n; ++i) {
        x[i] += length * step[i];
        residual[i] -= length * product[i];
        next += residual[i] * residual[i] / a.diagonal(i);
      }
      const double keep = next / rho;
      rho = next;
      for (std::size_t i = 0; i != n; ++i) step[i] = residual[i] / a.diagonal(i) + keep * step[i];
    }
    return true;
  }

 private:
  const Control* control_;
};

}  // namespace delref::detail
