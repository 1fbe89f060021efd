// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_tables.hpp"

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include <fmt/format.h>

#include <delref/core/carrier.hpp>

#include "words.hpp"

namespace delref::program {
namespace {

struct Tally {
  std::size_t count = 0;
  double measure = 0;
};
using Tallies = std::map<int, Tally>;

/// Rows by label, at most so many that they fit on a screen.
std::string table(const char* title, const char* label, const char* count, const char* measure, const Tallies& tallies) {
  constexpr std::size_t most_rows = 30;
  std::string text = fmt::format("\n{}\n  {:>10} {:>12}", title, label, count);
  if (*measure != '\0') text += fmt::format(" {:>14}", measure);
  text += '\n';
  std::size_t rows = 0;
  for (const auto& [key, tally] : tallies) {
    if (rows++ == most_rows) {
      text += fmt::format("  {:>10}\n", fmt::format("... and {} more", grouped(tallies.size() - most_rows)));
      break;
    }
    text += fmt::format("  {:>10} {:>12}", key, grouped(tally.count));
    if (*measure != '\0') text += fmt::format(" {:>14.6g}", tally.measure);
    text += '\n';
  }
  return text;
}

/// Counts and adds up `measure(i)` by label; label 0 where the mesh carries none.
template <class Measure>
Tallies tallied(std::size_t count, const std::vector<int>& labels, Measure&& measure) {
  Tallies tallies;
  for (std::size_t i = 0; i < count; ++i) {
    Tally& tally = tallies[labels.empty() ? 0 : labels[i]];
    ++tally.count;
    tally.measure += measure(i);
  }
  return tallies;
}

double length(Vector2 v) { return std::hypot(v.x, v.y); }
double length(Vector3 v) { return std::hypot(v.x, v.y, v.z); }

template <class Mesh>
std::string edges_table(const Mesh& mesh) {
  if (mesh.edges.empty()) return "\nThe file carries no subsegments.\n";
  return table("Subsegments (edges on segments of the input):", "marker", "edges", "length",
               tallied(mesh.edges.size(), mesh.edge_markers,
                       [&](std::size_t e) { return length(mesh.points[mesh.edges[e][1]] - mesh.points[mesh.edges[e][0]]); }));
}

std::string triangles_table(const TetrahedralMesh& mesh) {
  if (mesh.triangles.empty()) return "\nThe file carries no triangles on facets or surfaces.\n";
  return table("Triangles on facets or surfaces:", "marker", "triangles", "area",
               tallied(mesh.triangles.size(), mesh.triangle_markers, [&](std::size_t t) {
                 const auto& [a, b, c] = mesh.triangles[t];
                 return 0.5 * length(cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]));
               }));
}

template <class Mesh>
std::string vertices_tables(const Mesh& mesh) {
  std::string text;
  if (!mesh.point_markers.empty())
    text += table("Vertices:", "marker", "vertices", "",
                  tallied(mesh.points.size(), mesh.point_markers, [](std::size_t) { return 0.0; }));
  if (mesh.provenance.empty()) return text;
  std::map<LevelIndex, std::size_t> inserted;
  for (const LevelIndex level : mesh.provenance) ++inserted[level];
  text += "\nWho made the vertices:\n";
  for (const auto& [level, count] : inserted) {
    const std::string name = level < mesh.level_names.size() ? mesh.level_names[level]
                             : level == input_level          ? "input"
                                                             : fmt::format("level {}", level);
    text += fmt::format("  {:>10} {:>12}\n", name, grouped(count));
  }
  return text;
}

}  // namespace

std::string regions_table(const PlanarMesh& mesh) {
  if (mesh.regions.empty()) return "\nThe file carries no regions.\n";
  return table("Regions:", "label", "triangles", "area", tallied(mesh.triangles.size(), mesh.regions, [&](std::size_t t) {
                 const auto& [a, b, c] = mesh.triangles[t];
                 return 0.5 * cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
               }));
}

std::string regions_table(const TetrahedralMesh& mesh) {
  if (mesh.regions.empty()) return "\nThe file carries no regions.\n";
  return table("Regions:", "label", "tetrahedra", "volume", tallied(mesh.tetrahedra.size(), mesh.regions, [&](std::size_t t) {
                 const auto& [a, b, c, d] = mesh.tetrahedra[t];
                 const Point3 p = mesh.points[a];
                 return dot(mesh.points[b] - p, cross(mesh.points[c] - p, mesh.points[d] - p)) / 6;
               }));
}

std::string label_tables(const PlanarMesh& mesh) { return regions_table(mesh) + edges_table(mesh) + vertices_tables(mesh); }
std::string label_tables(const TetrahedralMesh& mesh) {
  return (mesh.tetrahedra.empty() ? "" : regions_table(mesh)) + triangles_table(mesh) + edges_table(mesh) + vertices_tables(mesh);
}

}  // namespace delref::program
