// SPDX-License-Identifier: GPL-3.0-or-later
//
// A formula in x, y and z as a list of instructions over registers, which many points run through at a time, each instruction
// once for a block of them, or an interval for each coordinate. Constant once made: any number of threads may ask it. The scheme
// is that of tapes: Keeter, "Massively parallel rendering of complex closed-form implicit surfaces" (2020), section 3.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <delref/core/point.hpp>
#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/formula_operations.hpp>
#include <delref/domain/implicit_function.hpp>
#include <delref/domain/interval.hpp>
#include <delref/domain/interval_slope.hpp>

namespace delref {

namespace detail {

/// Where an instruction finds an operand: in a register, or in itself.
struct Operand {
  static constexpr std::uint32_t is_constant = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t place = is_constant;
  double constant = 0;
};

struct Instruction {
  Operation operation;
  int exponent = 0;
  /// The register of the result: none of the operands'.
  std::uint32_t result = 0;
  std::array<Operand, 3> operands;
};

/// Runs one instruction for `width` points. A register is `width` numbers in a row.
template <std::size_t width, class Number>
void run_instruction(const Instruction& instruction, Number* registers) {
  Number* __restrict const out = registers + instruction.result * width;
  const auto at = [&](int k) -> const Number* {
    return registers + instruction.operands[static_cast<std::size_t>(k)].place * width;
  };
  const auto constant = [&](int k) { return Number(instruction.operands[static_cast<std::size_t>(k)].constant); };
  const auto is_constant = [&](int k) { return instruction.operands[static_cast<std::size_t>(k)].place == Operand::is_constant; };
  with_operation(instruction.operation, instruction.exponent, [&](const auto& function) {
    using Function = decltype(function);
    if constexpr (std::is_invocable_v<Function, Number>) {
      const Number* __restrict const a = at(0);
      for (std::size_t i = 0; i < width; ++i) out[i] = function(a[i]);
    } else if constexpr (std::is_invocable_v<Function, Number, Number>) {
      if (is_constant(1)) {
        const Number* __restrict const a = at(0);
        const Number b = constant(1);
        for (std::size_t i = 0; i < width; ++i) out[i] = function(a[i], b);
      } else if (is_constant(0)) {
        const Number a = constant(0);
        const Number* __restrict const b = at(1);
        for (std::size_t i = 0; i < width; ++i) out[i] = function(a, b[i]);
      } else {
        const Number* __restrict const a = at(0);
        const Number* __restrict const b = at(1);
        for (std::size_t i = 0; i < width; ++i) out[i] = function(a[i], b[i]);
      }
    } else {
      for (std::size_t i = 0; i < width; ++i) {
        const auto operand = [&](int k) { return is_constant(k) ? constant(k) : at(k)[i]; };
        out[i] = function(operand(0), operand(1), operand(2));
      }
    }
  });
}

/// Calls `use` with so many registers. Most formulas need a few, for which nothing is allocated.
template <std::size_t width, class Number, std::size_t few = 8, class Use>
auto with_registers(std::size_t count, const Use& use) {
  if (count <= few) {
    std::array<Number, few * width> registers;
    return use(registers.data());
  }
  if constexpr (few < 24) {
    return with_registers<width, Number, 24>(count, use);
  } else {
    const auto registers = std::make_unique_for_overwrite<Number[]>(count * width);
    return use(registers.get());
  }
}

}  // namespace detail

/// A function of x, y and z that a `FormulaBuilder` made. Models `PointFunction`, `BatchFunction` and `RangedFunction`.
class Formula {
 public:
  /// A list of instructions whose operands in registers 0, 1 and 2 are x, y and z.
  Formula(std::vector<detail::Instruction> instructions, std::uint32_t registers, detail::Operand result)
      : instructions_(std::move(instructions)), registers_(registers), result_(result) {}

  const std::vector<detail::Instruction>& instructions() const { return instructions_; }
  std::uint32_t registers() const { return registers_; }
  detail::Operand result() const { return result_; }

  double operator()(Point3 p) const { return over<double>({p.x, p.y, p.z}); }

  void operator()(std::span<const Point3> points, std::span<double> values) const {
    if (points.size() < 3) {
      for (std::size_t i = 0; i < points.size(); ++i) values[i] = (*this)(points[i]);
      return;
    }
    detail::with_registers<block, double>(registers_, [&](double* registers) {
      for (std::size_t from = 0; from < points.size(); from += block) {
        const std::size_t count = std::min(block, points.size() - from);
        for (std::size_t i = 0; i < block; ++i) {
          const Point3 p = points[from + std::min(i, count - 1)];
          registers[i] = p.x, registers[block + i] = p.y, registers[2 * block + i] = p.z;
        }
        run<block>(registers);
        for (std::size_t i = 0; i < count; ++i) values[from + i] = result_of<block>(registers, i);
      }
    });
  }

  /// See `RangedFunction`: by interval arithmetic, and where that leaves the sign open also from the value at the centre and the
  /// gradient (the mean value form), whose surplus falls with the square of the box's size.
  ValueRange range(const BoundingBox3& box) const {
    Interval value =
        over<Interval>({Interval(box.low.x, box.high.x), Interval(box.low.y, box.high.y), Interval(box.low.z, box.high.z)});
    if (value.low() < 0 && value.high() >= 0 && !value.may_be_undefined()) value = common(value, mean_value_form(box));
    return {value.low(), value.high(), value.may_be_undefined()};
  }

  /// The value and the gradient over a box.
  IntervalSlope slope(const BoundingBox3& box) const {
    return over<IntervalSlope>({IntervalSlope({box.low.x, box.high.x}, 0), IntervalSlope({box.low.y, box.high.y}, 1),
                                IntervalSlope({box.low.z, box.high.z}, 2)});
  }

  /// True when the function is smooth in the box and any two of its gradients there, also those that only intervals allow, are
  /// less than a right angle apart: condition C1 of Plantinga and Vegter (2007).
  bool is_regular(const BoundingBox3& box) const {
    const IntervalSlope over_box = slope(box);
    Interval product = 0;
    for (const Interval& part : over_box.gradient()) product = product + part * part;
    return product.low() > 0 && !product.may_be_undefined() && !over_box.value().may_be_undefined();
  }

 private:
  /// As many points as one run of the instructions takes.
  static constexpr std::size_t block = 16;

  template <class Number>
  Number over(const std::array<Number, 3>& coordinates) const {
    return detail::with_registers<1, Number>(registers_, [&](Number* registers) {
      std::ranges::copy(coordinates, registers);
      run<1>(registers);
      return result_of<1>(registers, 0);
    });
  }
  Interval mean_value_form(const BoundingBox3& box) const {
    const Point3 c = midpoint(box.low, box.high);
    const auto [x, y, z] = slope(box).gradient();
    return over<Interval>({c.x, c.y, c.z}) + x * (Interval(box.low.x, box.high.x) - c.x) +
           y * (Interval(box.low.y, box.high.y) - c.y) + z * (Interval(box.low.z, box.high.z) - c.z);
  }

  template <std::size_t width, class Number>
  void run(Number* registers) const {
    for (const detail::Instruction& instruction : instructions_) detail::run_instruction<width>(instruction, registers);
  }
  template <std::size_t width, class Number>
  Number result_of(const Number* registers, std::size_t i) const {
    return result_.place == detail::Operand::is_constant ? Number(result_.constant) : registers[result_.place * width + i];
  }

  std::vector<detail::Instruction> instructions_;
  std::uint32_t registers_;
  detail::Operand result_;
};

}  // namespace delref
