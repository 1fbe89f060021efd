// SPDX-License-Identifier: GPL-3.0-or-later
//
// A function of x, y and z written as text. muParser reads the text; its operators and functions are replaced by ones that take
// down what is computed instead of computing it, so that the result is a Formula, which is faster for many points, bounds its
// values over boxes, and may be asked by several threads, which muParser's own evaluation may not.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/formula.hpp>
#include <delref/domain/formula_narrowing.hpp>
#include <delref/domain/implicit_function.hpp>
#include <delref/expression/read_formula.hpp>

namespace delref {

/// What an expression may hold, for help texts and messages.
inline constexpr std::string_view expression_language =
    "variables x y z; numbers, pi and e; + - * / ^ ( ); < <= > >= == != && ||; functions abs sqrt cbrt exp ln log log2 log10 pow "
    "sin cos "
    "tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh floor ceil rint sign, min max sum avg of any number of values, "
    "and "
    "if(condition, then, otherwise)";

/// A function of three coordinates, such as `Expression("x^2 + y^2 + z^2 - 1")`. `log` and `ln` are the natural logarithm; -x^2
/// is
/// -(x^2), and a^b^c is a^(b^c). Whole powers up to 64 are products. Models `PointFunction`, `BatchFunction` and
/// `RangedFunction`; may be copied and asked by several threads.
class Expression {
 public:
  /// Throws `InvalidInput` that says where in the text what is wrong, and what is allowed. At most 20,000 characters.
  explicit Expression(std::string text) : text_(std::move(text)), formula_(detail::read_formula(text_, expression_language)) {}

  const std::string& text() const { return text_; }
  const Formula& formula() const { return formula_; }

  double operator()(Point3 p) const { return formula_(p); }
  void operator()(std::span<const Point3> points, std::span<double> values) const { formula_(points, values); }
  ValueRange range(const BoundingBox3& box) const { return formula_.range(box); }
  bool is_regular(const BoundingBox3& box) const { return formula_.is_regular(box); }
  /// What is left of it within a box, when that is much less.
  std::optional<Expression> narrowed(const BoundingBox3& box) const {
    std::optional<Formula> shorter = delref::narrowed(formula_, box);
    if (!shorter) return std::nullopt;
    return Expression(text_, *std::move(shorter));
  }

 private:
  Expression(std::string text, Formula formula) : text_(std::move(text)), formula_(std::move(formula)) {}

  std::string text_;
  Formula formula_;
};

}  // namespace delref
