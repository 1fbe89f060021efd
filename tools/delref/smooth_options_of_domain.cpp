// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include <delref/domain/invalid_input.hpp>

#include "smooth_run.hpp"
#include "words.hpp"

namespace delref::program {
namespace {

/// The sizes by label as sizes by region number, 0 for none. Oracles that do not name their regions (`labels` is empty) have the labels
/// 1, 2, ...
std::vector<double> sizes_by_region(const std::vector<std::pair<int, double>>& by_label, const std::vector<int>& labels) {
  std::vector<double> sizes;
  for (const auto& [label, size] : by_label) {
    std::size_t region = 0;
    if (labels.empty()) {
      if (label < 1 || label > 65535) throw InvalidInput(fmt::format("--region-cell-size: there is no region {}; regions are numbered from 1", label));
      region = static_cast<std::size_t>(label - 1);
    } else {
      const auto found = std::ranges::find(labels, label);
      if (found == labels.end())
        throw InvalidInput(fmt::format("--region-cell-size: there is no region {}; there are {}", label, list_of(labels)));
      region = static_cast<std::size_t>(found - labels.begin());
    }
    if (region >= sizes.size()) sizes.resize(region + 1, 0);
    sizes[region] = size;
  }
  return sizes;
}

}  // namespace

SmoothOptions options_for(const SmoothDomain& domain, const SmoothRunOptions& options) {
  SmoothOptions result = options.mesher;
  result.region_cell_sizes = sizes_by_region(options.region_cell_sizes, domain.oracle.region_labels());
  if (std::isfinite(result.facet_size) || std::isfinite(result.facet_distance) || result.facet_size_field) return result;
  if (domain.usual_facet_size) result.facet_size = *domain.usual_facet_size;
  if (domain.usual_facet_distance) result.facet_distance = *domain.usual_facet_distance;
  return result;
}

}  // namespace delref::program
