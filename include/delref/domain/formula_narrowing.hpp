// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a formula within a box: where the ranges decide a minimum, a maximum or a condition, the other branch is
// dropped with all that only it needs. A union of hundreds of bodies becomes that of the few nearby. Keeter, "Massively parallel
// rendering of complex closed-form implicit surfaces" (2020), section 3.2.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <delref/domain/bounding_box_3.hpp>
#include <delref/domain/formula.hpp>
#include <delref/domain/formula_builder.hpp>
#include <delref/domain/formula_operations.hpp>
#include <delref/domain/interval.hpp>

namespace delref {

namespace detail {

/// True for the operations whose result is one of their operands.
constexpr bool selects(Operation operation) {
  return operation == Operation::smaller || operation == Operation::larger || operation == Operation::choose;
}

/// The operand that is the result all over the box, when that is certain.
inline std::optional<std::size_t> decided(Operation operation, const Interval& a, const Interval& b) {
  if (operation == Operation::choose) {
    if (a.is_never_zero()) return 1;
    if (a.is_zero()) return 2;
    return std::nullopt;
  }
  if (!selects(operation) || a.may_be_undefined() || b.may_be_undefined()) return std::nullopt;
  const bool smaller_wins = operation == Operation::smaller;
  if (a.high() < b.low()) return smaller_wins ? 0 : 1;
  if (b.high() < a.low()) return smaller_wins ? 1 : 0;
  return std::nullopt;
}

/// For each instruction of the formula the operand that is its result all over the box, when that is certain.
inline std::vector<std::optional<std::size_t>> winners(const Formula& formula, const BoundingBox3& box) {
  std::vector<Interval> ranges(formula.registers());
  ranges[0] = {box.low.x, box.high.x}, ranges[1] = {box.low.y, box.high.y}, ranges[2] = {box.low.z, box.high.z};
  const auto range_of = [&](const Operand& operand) {
    return operand.place == Operand::is_constant ? Interval(operand.constant) : ranges[operand.place];
  };
  std::vector<std::optional<std::size_t>> all;
  all.reserve(formula.instructions().size());
  for (const Instruction& instruction : formula.instructions()) {
    all.push_back(decided(instruction.operation, range_of(instruction.operands[0]), range_of(instruction.operands[1])));
    run_instruction<1>(instruction, ranges.data());
  }
  return all;
}

}  // namespace detail

/// A formula with the same values all over the box and a quarter of the instructions less, or nothing.
inline std::optional<Formula> narrowed(const Formula& formula, const BoundingBox3& box) {
  const auto& instructions = formula.instructions();
  const auto selects = [](const detail::Instruction& instruction) { return detail::selects(instruction.operation); };
  if (std::ranges::none_of(instructions, selects)) return std::nullopt;
  const std::vector<std::optional<std::size_t>> winners = detail::winners(formula, box);
  if (std::ranges::none_of(winners, [](const auto& winner) { return winner.has_value(); })) return std::nullopt;

  FormulaBuilder builder;
  std::vector<FormulaBuilder::Value> values(formula.registers());
  for (std::size_t axis = 0; axis < 3; ++axis) values[axis] = builder.coordinate(static_cast<int>(axis));
  const auto value_of = [&](const detail::Operand& operand) {
    return operand.place == detail::Operand::is_constant ? builder.constant(operand.constant) : values[operand.place];
  };
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const auto& [operation, exponent, result, operands] = instructions[i];
    if (winners[i])
      values[result] = value_of(operands[*winners[i]]);
    else if (operation == detail::Operation::power_of_integer)
      values[result] = builder.integer_power(value_of(operands[0]), exponent);
    else
      values[result] = builder.apply(operation, value_of(operands[0]), value_of(operands[1]), value_of(operands[2]));
  }
  Formula result = builder.finish(value_of(formula.result()));
  if (4 * result.instructions().size() > 3 * instructions.size()) return std::nullopt;
  return result;
}

}  // namespace delref
