// SPDX-License-Identifier: MIT
//
// Shows how to read what a run could not do: where, by which criterion, and why.
#include <cstdio>
#include <string>

#include <delref/algorithms/planar.hpp>
#include <delref/io/planar_formats.hpp>

namespace {

/// A triangle with a corner of half a degree: no mesh of it has only angles of 20 degrees and more.
delref::Pslg sliver() {
  delref::Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 0.0087}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 0}};
  return pslg;
}

void print(const delref::Outcome<delref::Point2>& outcome) {
  // Complete: every element was refined or given up. Otherwise `stopped` says what ended the run.
  std::printf("%s\n", outcome.complete() ? "complete" : "stopped before its end");

  // What each level did.
  for (const delref::LevelCounts& level : outcome.levels)
    std::printf("  %-6s inserted %4zu, rejected %4zu, given up %4zu, left in its queue %4zu\n", level.name.c_str(), level.inserted,
                level.rejected, level.rejected_forever, level.queued);

  // What does not meet its criterion, with the place and the reason.
  std::printf("  unmet: %zu\n", outcome.unmet.size());
  for (std::size_t i = 0; i < outcome.unmet.size() && i < 3; ++i) {
    const delref::Unmet<delref::Point2>& u = outcome.unmet[i];
    std::printf("    %s at (%g, %g): %s\n", u.criterion.c_str(), u.place.x, u.place.y,
                std::string(delref::to_string(u.reason)).c_str());
  }
}

}  // namespace

int main() {
  delref::PlanarOptions options;

  // All that is unmet here is excused by the corner: a program may take this for success.
  const auto forced = delref::mesh_planar(sliver(), options);
  print(forced.outcome);
  const bool excused = forced.outcome.unmet_count(delref::Reason::small_input_angle) == forced.outcome.unmet.size();

  // A budget ends the run early. The mesh is valid all the same, and what is left to do is listed.
  options.max_area = 1e-8;
  delref::Budget budget;
  budget.max_vertices = 200;
  const auto cut_short = delref::mesh_planar(sliver(), options, delref::Control(budget));
  print(cut_short.outcome);

  // A picture marks what is unmet.
  delref::SvgOptions picture;
  picture.title = "what a corner of half a degree forces";
  picture.unmet = forced.outcome.unmet;
  delref::write_svg("unmet.svg", forced.mesh, picture);

  return excused && cut_short.outcome.stopped == delref::Stop::vertices ? 0 : 1;
}
