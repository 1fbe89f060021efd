// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include <delref/domain/point_set_domain.hpp>
#include <delref/io/point_set_reader.hpp>

#include "smooth_domain.hpp"
#include "words.hpp"

namespace delref::program {

SmoothDomain point_set_domain(const std::string& path, const ReportedSmoothOptions& options, const Control& control,
                              std::vector<std::string>& notes) {
  const PointSet set = read_point_set(path, control);
  const PointSetOptions how{
      .neighbours = options.neighbours, .outlier_distance = options.outlier_distance, .smoothing_passes = options.point_smoothing};
  try {
    PointSetDomain domain(set, how, control);
    for (const std::string& note : domain.notes()) notes.push_back(note);
    SmoothDomain result;
    result.usual_facet_size = domain.default_facet_size();
    result.usual_facet_distance = domain.default_facet_distance();
    result.why_usual = "which suits the distances of the points";
    result.words = fmt::format("{} {} normals, {:.4g} apart on the average", counted(set.points.size(), "point", "points"),
                               set.normals.empty() ? "without" : "with", domain.average_spacing());
    result.oracle = AnyOracle(std::move(domain));
    return result;
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{} cannot be meshed: {}", path, error.what()));
  }
}

}  // namespace delref::program
