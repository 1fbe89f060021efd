// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds a Formula operation by operation: what is written twice is computed once, what is constant is computed here, small whole
// powers become products, and a register is used again as soon as its value is needed no more.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <delref/domain/formula.hpp>
#include <delref/domain/formula_operations.hpp>

namespace delref {

/// Values are known by numbers, which the functions give and take.
class FormulaBuilder {
 public:
  using Value = std::uint32_t;

  Value constant(double number) { return add({detail::Operation::constant, 0, number, {}}); }
  Value coordinate(int axis) {
    return add({static_cast<detail::Operation>(static_cast<int>(detail::Operation::x) + axis), 0, 0, {}});
  }

  /// The value of an operation with one to three operands.
  Value apply(detail::Operation operation, Value a, Value b = 0, Value c = 0) {
    const int count = detail::operand_count(operation);
    if (is_constant(a) && (count < 2 || is_constant(b)) && (count < 3 || is_constant(c)))
      return constant(computed(operation, 0, a, b, c));
    if (operation == detail::Operation::choose && is_constant(a)) return number(a) != 0 ? b : c;
    if (operation == detail::Operation::power && is_constant(b)) return constant_power(a, number(b));
    if (operation == detail::Operation::multiply && a == b) return integer_power(a, 2);
    return add({operation, 0, 0, {a, count > 1 ? b : 0, count > 2 ? c : 0}});
  }

  /// The value of a whole power, not 0.
  Value integer_power(Value a, int exponent) {
    if (is_constant(a)) return constant(computed(detail::Operation::power_of_integer, exponent, a, a, a));
    return add({detail::Operation::power_of_integer, exponent, 0, {a, 0, 0}});
  }

  /// The formula whose value is `result`.
  Formula finish(Value result) const;

 private:
  struct Node {
    detail::Operation operation;
    int exponent;
    double number;
    std::array<Value, 3> operands;
  };

  Value add(const Node& node) {
    const auto key = std::tuple(node.operation, node.exponent, std::bit_cast<std::uint64_t>(node.number), node.operands);
    const auto [place, is_new] = known_.try_emplace(key, static_cast<Value>(nodes_.size()));
    if (is_new) nodes_.push_back(node);
    return place->second;
  }
  std::vector<Value> order(Value result) const;
  bool is_constant(Value value) const { return nodes_[value].operation == detail::Operation::constant; }
  double number(Value value) const { return nodes_[value].number; }

  double computed(detail::Operation operation, int exponent, Value a, Value b, Value c) const {
    std::array<double, 4> registers{number(a), number(b), number(c), 0};
    detail::run_instruction<1>(detail::Instruction{operation, exponent, 3, {detail::Operand{0, 0}, {1, 0}, {2, 0}}},
                               registers.data());
    return registers[3];
  }
  Value constant_power(Value a, double exponent) {
    if (exponent == 0) return constant(1);
    if (exponent == 1) return a;
    if (exponent == 0.5) return apply(detail::Operation::sqrt, a);
    if (exponent == std::trunc(exponent) && std::abs(exponent) <= 64) return integer_power(a, static_cast<int>(exponent));
    return add({detail::Operation::power, 0, 0, {a, constant(exponent), 0}});
  }

  std::vector<Node> nodes_;
  std::map<std::tuple<detail::Operation, int, std::uint64_t, std::array<Value, 3>>, Value> known_;
};

/// Each value after its operands, and as late as it can be: sums of many terms then need few registers.
inline std::vector<FormulaBuilder::Value> FormulaBuilder::order(Value result) const {
  std::vector<Value> ordered;
  std::vector<bool> is_ordered(nodes_.size(), false);
  std::vector<std::pair<Value, int>> waiting{{result, 0}};
  while (!waiting.empty()) {
    auto& [value, next_operand] = waiting.back();
    if (!is_ordered[value] && next_operand < detail::operand_count(nodes_[value].operation)) {
      const Value operand = nodes_[value].operands[static_cast<std::size_t>(next_operand++)];
      if (!is_ordered[operand]) waiting.push_back({operand, 0});
      continue;
    }
    if (!is_ordered[value]) ordered.push_back(value);
    is_ordered[value] = true;
    waiting.pop_back();
  }
  return ordered;
}

inline Formula FormulaBuilder::finish(Value result) const {
  const std::vector<Value> ordered = order(result);
  const auto operands_of = [&](Value v) {
    return std::span(nodes_[v].operands).first(static_cast<std::size_t>(detail::operand_count(nodes_[v].operation)));
  };
  std::vector<Value> last_user(nodes_.size(), result);
  for (const Value v : ordered)
    for (const Value operand : operands_of(v)) last_user[operand] = v;

  std::vector<detail::Operand> places(nodes_.size());
  std::vector<std::uint32_t> free;
  std::uint32_t registers = 3;
  std::vector<detail::Instruction> instructions;
  for (const Value v : ordered) {
    const Node& node = nodes_[v];
    if (node.operation == detail::Operation::constant) {
      places[v].constant = node.number;
    } else if (operands_of(v).empty()) {
      places[v].place = static_cast<std::uint32_t>(node.operation) - static_cast<std::uint32_t>(detail::Operation::x);
    } else {
      if (free.empty()) free.push_back(registers++);
      places[v].place = free.back();
      free.pop_back();
      auto& instruction = instructions.emplace_back(detail::Instruction{node.operation, node.exponent, places[v].place, {}});
      for (std::size_t k = 0; k < operands_of(v).size(); ++k) instruction.operands[k] = places[node.operands[k]];
      for (const Value operand : operands_of(v))
        if (std::exchange(last_user[operand], result) == v && v != result && operands_of(operand).size() > 0)
          free.push_back(places[operand].place);
    }
  }
  return {std::move(instructions), registers, places[result]};
}

}  // namespace delref
