// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/domain/box_questions.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/implicit_domain.hpp>
#include <delref/domain/multi_material_domain.hpp>
#include <delref/expression/expression.hpp>

#include "smooth_domain.hpp"

namespace delref::program {
namespace {

/// A text that is not too long for a line.
std::string shown(const std::string& text) {
  constexpr std::size_t most = 60;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

/// The expressions read; what is wrong with one is told with its number when there are several.
std::vector<Expression> read_expressions(const std::vector<std::string>& texts) {
  std::vector<Expression> expressions;
  for (std::size_t i = 0; i < texts.size(); ++i) try {
      expressions.emplace_back(texts[i]);
    } catch (const InvalidInput& error) {
      const std::string which = texts.size() > 1 ? fmt::format("--implicit number {}: ", i + 1) : "--implicit: ";
      throw InvalidInput(which + error.what());
    }
  return expressions;
}

/// The domain of several functions ends at its bounds without a word.
void note_closing_at_bounds(const MultiMaterialDomain<Expression>& domain, std::vector<std::string>& notes) {
  const std::vector<Point3> faces = box_face_samples(domain.bounds(), 32);
  std::vector<int> labels(faces.size());
  domain.label(faces, labels);
  const auto inside = std::ranges::find_if(labels, [](int label) { return label != outside; });
  if (inside == labels.end()) return;
  notes.push_back(fmt::format("the domain reaches its bounds, as at the point {}; it is closed there by the faces of the box",
                              describe(faces[static_cast<std::size_t>(inside - labels.begin())])));
}

}  // namespace

SmoothDomain function_domain(const ReportedSmoothOptions& options, const Control&, std::vector<std::string>& notes) {
  std::vector<Expression> functions = read_expressions(options.expressions);
  const std::vector<double>& b = options.bounds;
  const BoundingBox3 box{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  const std::string place = fmt::format("in the box from {} to {}", describe(box.low), describe(box.high));
  if (functions.size() > 1) {
    notes.push_back("a tetrahedron has the label 1 where only the first function is below 0, 2 where only the second one is, and the sum of "
                    "1, 2, 4, ... where several are");
    const std::size_t count = functions.size();
    MultiMaterialDomain<Expression> domain(std::move(functions), box, {}, options.sampling);
    note_closing_at_bounds(domain, notes);
    return {AnyOracle(std::move(domain)), fmt::format("{} functions {}", count, place)};
  }
  const std::string words = fmt::format("the function {} {}", shown(options.expressions.front()), place);
  ImplicitDomain<Expression> domain(std::move(functions.front()), box, {.sampling_distance = options.sampling});
  for (std::string& note : domain.notes()) notes.push_back(std::move(note));
  return {AnyOracle(std::move(domain)), words};
}

}  // namespace delref::program
