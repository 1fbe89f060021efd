// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <delref/domain/describe.hpp>
#include <delref/domain/grey_level_image.hpp>
#include <delref/domain/labelled_image.hpp>
#include <delref/images/image_reader.hpp>

#include "smooth_domain.hpp"
#include "words.hpp"

namespace delref::program {
namespace {

std::string grid_words(const ImageGrid& grid) {
  const auto& [nx, ny, nz] = grid.size;
  const auto& [dx, dy, dz] = grid.spacing;
  const std::string voxels = fmt::format("{} x {} x {} voxels", nx, ny, nz);
  return dx == dy && dy == dz ? fmt::format("{} of side {:.6g}", voxels, dx) : fmt::format("{} of {:.6g} x {:.6g} x {:.6g}", voxels, dx, dy, dz);
}

/// Facets that show what is two voxels thick, unless the mesh would become very large by that.
void choose_usual_size(SmoothDomain& domain, const ImageGrid& grid, const Control& control) {
  const double voxel = std::cbrt(grid.spacing[0] * grid.spacing[1] * grid.spacing[2]), extent = domain.oracle.surface_box(control).extent();
  if (1.5 * voxel >= extent / 20) return;
  domain.usual_facet_size = std::max(1.5 * voxel, extent / 100);
  domain.why_usual = 1.5 * voxel >= extent / 100 ? "one and a half voxels" : "a hundredth of the extent of the surface";
}

SmoothDomain grey_levels(AnyImage image, const ReportedSmoothOptions& options, const std::string& grid, const Control& control) {
  const bool below = options.inside == "below";
  const GreyLevelOptions how{.inside_is_below = below, .close_at_border = options.closed_at_border};
  return {AnyOracle(GreyLevelImage(std::move(image), *options.iso, how, control)),
          fmt::format("an image of {}, inside where it is at {} {}", grid, below ? "most" : "least", describe(*options.iso))};
}

SmoothDomain labels(const AnyImage& image, const ReportedSmoothOptions& options, const std::string& grid, const Control& control,
                    std::vector<std::string>& notes) {
  LabelledImage domain(image, {.outside_label = options.background_label, .smoothing = options.label_smoothing}, control);
  if (const std::vector<int> lost = domain.lost_labels(control); !lost.empty())
    notes.push_back(fmt::format("--smooth-labels {} smooths away the {} {}", describe(options.label_smoothing), lost.size() == 1 ? "label" : "labels",
                                list_of(lost)));
  const std::string words = fmt::format("an image of {} with {}", grid, counted(domain.region_labels().size(), "label", "labels"));
  return {AnyOracle(std::move(domain)), words};
}

/// What the library says of an image, under its file's name and with the options called as on the command line.
InvalidInput in_words_of_the_program(const InvalidInput& error, const std::string& path) {
  constexpr std::string_view member = "close_at_border";
  std::vector<Defect> defects = error.defects();
  for (Defect& defect : defects) {
    if (const std::size_t at = defect.message.find(member); at != std::string::npos) defect.message.replace(at, member.size(), "--closed");
    defect.message = fmt::format("{} cannot be meshed: {}", path, defect.message);
  }
  return InvalidInput(std::move(defects));
}

}  // namespace

SmoothDomain image_domain(const std::string& path, const ReportedSmoothOptions& options, const Control& control,
                          std::vector<std::string>& notes) {
  ImageFile file = read_image(path, control);
  for (std::string& note : file.notes) notes.push_back(std::move(note));
  const ImageGrid grid = grid_of(file.image);
  const std::string words = grid_words(grid);
  try {
    SmoothDomain domain =
        options.labels ? labels(file.image, options, words, control, notes) : grey_levels(std::move(file.image), options, words, control);
    choose_usual_size(domain, grid, control);
    return domain;
  } catch (const InvalidInput& error) {
    throw in_words_of_the_program(error, path);
  }
}

}  // namespace delref::program
