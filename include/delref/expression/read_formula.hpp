// SPDX-License-Identifier: GPL-3.0-or-later
//
// Has muParser evaluate a text once with numbers that stand for values of a FormulaBuilder: each operator and function is ours
// and notes down its operands. A value that is not a constant travels through muParser as a NaN that holds its number.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <muParser.h>

#include <delref/domain/formula.hpp>
#include <delref/domain/formula_builder.hpp>
#include <delref/domain/invalid_input.hpp>

namespace delref::detail {

/// The builder of the text that this thread is reading: muParser hands nothing of ours to operators.
inline thread_local FormulaBuilder* reading = nullptr;

inline constexpr std::uint64_t stands_for_value = 0x7FF8'0000'0000'0000U;

inline mu::value_type handle_of(FormulaBuilder::Value value) {
  return std::bit_cast<double>(stands_for_value | (std::uint64_t{value} + 1));
}
inline FormulaBuilder::Value value_of(mu::value_type handle) {
  const auto bits = std::bit_cast<std::uint64_t>(handle);
  if (std::isnan(handle) && (bits & 0xFFFF'FFFFU) != 0) return static_cast<FormulaBuilder::Value>((bits & 0xFFFF'FFFFU) - 1);
  return reading->constant(handle);
}

template <Operation operation>
mu::value_type note1(mu::value_type a) {
  return handle_of(reading->apply(operation, value_of(a)));
}
template <Operation operation>
mu::value_type note2(mu::value_type a, mu::value_type b) {
  return handle_of(reading->apply(operation, value_of(a), value_of(b)));
}
template <Operation operation>
mu::value_type note2_swapped(mu::value_type a, mu::value_type b) {
  return note2<operation>(b, a);
}
template <Operation operation>
mu::value_type note_many(const mu::value_type* values, int count) {
  FormulaBuilder::Value result = value_of(values[0]);
  for (int i = 1; i < count; ++i) result = reading->apply(operation, result, value_of(values[i]));
  return handle_of(result);
}
inline mu::value_type note_average(const mu::value_type* values, int count) {
  return note2<Operation::divide>(note_many<Operation::add>(values, count), count);
}
inline mu::value_type note_cube_root(mu::value_type a) {
  return note2<Operation::multiply>(note1<Operation::sign>(a), note2<Operation::power>(note1<Operation::abs>(a), 1.0 / 3));
}
inline mu::value_type note_itself(mu::value_type a) { return a; }
inline mu::value_type note_unequal(mu::value_type a, mu::value_type b) {
  return note2<Operation::subtract>(1, note2<Operation::equal>(a, b));
}
inline mu::value_type note_choice(mu::value_type condition, mu::value_type a, mu::value_type b) {
  return handle_of(reading->apply(Operation::choose, value_of(condition), value_of(a), value_of(b)));
}

inline void define_operators(mu::Parser& parser) {
  parser.ClearInfixOprt();
  parser.ClearPostfixOprt();
  parser.ClearOprt();
  parser.EnableBuiltInOprt(false);
  parser.DefineInfixOprt("-", note1<Operation::negate>, mu::prINFIX, false);
  parser.DefineInfixOprt("+", note_itself, mu::prINFIX, false);
  parser.DefineOprt("+", note2<Operation::add>, mu::prADD_SUB, mu::oaLEFT);
  parser.DefineOprt("-", note2<Operation::subtract>, mu::prADD_SUB, mu::oaLEFT);
  parser.DefineOprt("*", note2<Operation::multiply>, mu::prMUL_DIV, mu::oaLEFT);
  parser.DefineOprt("/", note2<Operation::divide>, mu::prMUL_DIV, mu::oaLEFT);
  parser.DefineOprt("^", note2<Operation::power>, mu::prPOW, mu::oaRIGHT);
  parser.DefineOprt("<", note2<Operation::less>, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt("<=", note2<Operation::not_greater>, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt(">", note2_swapped<Operation::less>, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt(">=", note2_swapped<Operation::not_greater>, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt("==", note2<Operation::equal>, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt("!=", note_unequal, mu::prCMP, mu::oaLEFT);
  parser.DefineOprt("&&", note2<Operation::both>, mu::prLAND, mu::oaLEFT);
  parser.DefineOprt("||", note2<Operation::either>, mu::prLOR, mu::oaLEFT);
}

inline void define_functions(mu::Parser& parser) {
  parser.ClearFun();
  const auto define = [&parser](const char* name, auto* function) { parser.DefineFun(name, function, false); };
  define("abs", note1<Operation::abs>);
  define("sqrt", note1<Operation::sqrt>);
  define("cbrt", note_cube_root);
  define("exp", note1<Operation::exp>);
  define("ln", note1<Operation::log>);
  define("log", note1<Operation::log>);
  define("log2", note1<Operation::log2>);
  define("log10", note1<Operation::log10>);
  define("sin", note1<Operation::sin>);
  define("cos", note1<Operation::cos>);
  define("tan", note1<Operation::tan>);
  define("asin", note1<Operation::asin>);
  define("acos", note1<Operation::acos>);
  define("atan", note1<Operation::atan>);
  define("sinh", note1<Operation::sinh>);
  define("cosh", note1<Operation::cosh>);
  define("tanh", note1<Operation::tanh>);
  define("asinh", note1<Operation::asinh>);
  define("acosh", note1<Operation::acosh>);
  define("atanh", note1<Operation::atanh>);
  define("floor", note1<Operation::floor>);
  define("ceil", note1<Operation::ceil>);
  define("rint", note1<Operation::rint>);
  define("sign", note1<Operation::sign>);
  define("pow", note2<Operation::power>);
  define("atan2", note2<Operation::atan2>);
  define("if", note_choice);
  define("min", note_many<Operation::smaller>);
  define("max", note_many<Operation::larger>);
  define("sum", note_many<Operation::add>);
  define("avg", note_average);
}

[[noreturn]] inline void refuse_expression(const std::string& text, std::size_t position, const std::string& reason,
                                           std::string_view language) {
  std::string message = "the expression cannot be read: " + reason;
  if (position < text.size())
    message += " (at character " + std::to_string(position + 1) + ", before '" + text.substr(position, 20) + "')";
  throw InvalidInput(message + "; allowed are " + std::string(language));
}

/// Characters that muParser would take for something else than it means here: conditions with ?, strings, assignments.
inline void refuse_foreign_characters(const std::string& text, std::string_view language) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-*/^(),<>=!&| ";
  const std::size_t foreign = text.find_first_not_of(allowed);
  if (foreign == std::string::npos) return;
  const bool is_choice = text[foreign] == '?' || text[foreign] == ':';
  refuse_expression(text, foreign,
                    is_choice ? "conditions are written if(condition, then, otherwise)" : "a character has no meaning there",
                    language);
}

/// The formula that the text means. Throws `InvalidInput`.
inline Formula read_formula(std::string text, std::string_view language) {
  for (char& c : text)
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  refuse_foreign_characters(text, language);
  FormulaBuilder builder;
  std::array<mu::value_type, 3> coordinates;
  for (int axis = 0; axis < 3; ++axis) coordinates[static_cast<std::size_t>(axis)] = handle_of(builder.coordinate(axis));
  FormulaBuilder* const before = std::exchange(reading, &builder);
  try {
    mu::Parser parser;
    define_operators(parser);
    define_functions(parser);
    parser.ClearConst();
    parser.DefineConst("pi", 3.141592653589793);
    parser.DefineConst("e", 2.718281828459045);
    parser.DefineVar("x", &coordinates[0]);
    parser.DefineVar("y", &coordinates[1]);
    parser.DefineVar("z", &coordinates[2]);
    parser.EnableOptimizer(false);
    parser.SetExpr(text);
    const FormulaBuilder::Value result = value_of(parser.Eval());
    if (parser.GetNumResults() != 1) refuse_expression(text, text.size(), "it gives more than one value", language);
    reading = before;
    return builder.finish(result);
  } catch (const mu::ParserError& error) {
    reading = before;
    const auto position = error.GetPos() < 0 ? text.size() : static_cast<std::size_t>(error.GetPos());
    refuse_expression(text, position, error.GetMsg(), language);
  } catch (...) {
    reading = before;
    throw;
  }
}

}  // namespace delref::detail
