// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a verification says: one finding per check, with the number of things that fail it and where the first of them are, in
// words that a person can act on.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace delref {

enum class CheckStatus : unsigned char {
  passed,
  failed,
  not_run  ///< not asked for, not carried by the mesh, or impossible because of an earlier failure; the note says which
};

/// The result of one check.
struct Finding {
  static constexpr std::size_t most_places = 5;

  /// A short sentence that is true when the check passes.
  std::string name;
  CheckStatus status = CheckStatus::not_run;
  /// How many things were looked at, and how many of them fail.
  std::size_t examined = 0, failures = 0;
  /// The first failures in words, at most `most_places`.
  std::vector<std::string> places;
  /// Anything else that is to be known: why it was not run, what was excused.
  std::string note;

  /// Counts a failure; `words()` is called only for the first few.
  template <class Words>
  void fail(Words&& words) {
    status = CheckStatus::failed;
    if (failures++ < most_places) places.push_back(std::forward<Words>(words)());
  }
};

/// A connected piece of the surface that bounds a region of a smooth domain.
struct SurfacePiece {
  int region = 0;  ///< its label
  std::size_t vertices = 0, edges = 0, triangles = 0;
  /// The volume that it encloses, negative around a cavity.
  double volume = 0;
  /// 2 for a sphere, 0 for a torus, 2 less for every further hole.
  long euler_characteristic() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles); }
};

/// The result of `verify_planar`, `verify_polyhedral` and `verify_smooth`.
struct VerifyReport {
  /// In the order in which they were made.
  std::vector<Finding> findings;

  /// Elements over the bound on their shape that a small input angle forces, ...
  std::size_t excused_angles = 0;
  /// ... elements that miss a criterion and are in the given list of unmet ones, ...
  std::size_t listed_unmet = 0;
  /// ... and those that are not, in a run that is known not to be complete.
  std::size_t unfinished = 0;
  /// In degrees; the second is over the triangles that are neither excused, listed nor unfinished. 180 when there are none.
  double smallest_angle = 180, smallest_angle_in_force = 180;
  /// The same for the circumradius over the shortest edge of the tetrahedra. 0 when there are none.
  double worst_radius_edge = 0, worst_radius_edge_in_force = 0;
  /// Of smooth domains: the closed surfaces around their regions, by the label of the region and then by size, greatest first.
  std::vector<SurfacePiece> surfaces;

  /// No check failed. Excused, listed and unfinished elements are no failures.
  bool ok() const { return std::ranges::none_of(findings, failed, &Finding::status); }
  /// The finding of that name, or none.
  const Finding* find(std::string_view name) const {
    const auto found = std::ranges::find(findings, name, &Finding::name);
    return found == findings.end() ? nullptr : &*found;
  }

 private:
  static bool failed(CheckStatus s) { return s == CheckStatus::failed; }
};

namespace verification {

/// The surfaces around the regions, a line each for the first of them.
inline std::string surfaces_text(const std::vector<SurfacePiece>& surfaces) {
  constexpr std::size_t told = 12;
  std::string text;
  for (const SurfacePiece& s : std::span(surfaces).first(std::min(told, surfaces.size())))
    text += fmt::format("surface around region {}: {} triangles, Euler characteristic {}, volume {:.10g}\n", s.region, s.triangles,
                        s.euler_characteristic(), s.volume);
  if (surfaces.size() > told) {
    long rest = 0;
    for (const SurfacePiece& s : std::span(surfaces).subspan(told)) rest += s.euler_characteristic();
    text += fmt::format("and {} more, their Euler characteristics adding up to {}\n", surfaces.size() - told, rest);
  }
  return text;
}

}  // namespace verification

/// The report as a table of lines, each failed check followed by its first places; the last line is the verdict.
inline std::string verify_table(const VerifyReport& report) {
  std::string text;
  for (const Finding& f : report.findings) {
    const std::string_view word = f.status == CheckStatus::passed ? "ok" : f.status == CheckStatus::failed ? "FAILED" : "-";
    text += fmt::format("{:<7} {}", word, f.name);
    if (f.status == CheckStatus::failed) text += fmt::format(": {} of {}", f.failures, f.examined);
    if (!f.note.empty()) text += fmt::format(" ({})", f.note);
    text += '\n';
    for (const std::string& place : f.places) text += fmt::format("          {}\n", place);
    if (f.failures > f.places.size()) text += fmt::format("          and {} more\n", f.failures - f.places.size());
  }
  text += verification::surfaces_text(report.surfaces);
  if (report.smallest_angle < 180) text += fmt::format("smallest angle {:.6g} degrees", report.smallest_angle);
  if (report.smallest_angle_in_force < 180 && report.smallest_angle_in_force != report.smallest_angle)
    text += fmt::format("; {:.6g} where the bound is in force", report.smallest_angle_in_force);
  if (report.smallest_angle < 180) text += '\n';
  if (report.worst_radius_edge > 0) text += fmt::format("worst radius-edge ratio {:.6g}", report.worst_radius_edge);
  if (report.worst_radius_edge_in_force > 0 && report.worst_radius_edge_in_force != report.worst_radius_edge)
    text += fmt::format("; {:.6g} where the bound is in force", report.worst_radius_edge_in_force);
  if (report.worst_radius_edge > 0) text += '\n';
  text += fmt::format("excused by small input angles {}, unmet and listed {}, unfinished {}\n", report.excused_angles,
                      report.listed_unmet, report.unfinished);
  return text + (report.ok() ? "The mesh is what was promised.\n" : "The mesh is NOT what was promised.\n");
}

}  // namespace delref
