// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures a mesh of a smooth domain as text (.mesh of MEDIT, .off): counts, topology of the surface, shapes, and how far from
// the surface its triangles are. Shares no code with any mesher, delref's included. Usage: measure_smooth MESH DOMAIN
// (benchmarks/smooth/surfaces.hpp)
#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "level_function.hpp"
#include "mesh_topology.hpp"

namespace {

using benchmark::LevelFunction;
using benchmark::Tetrahedron;
using benchmark::Triangle;
using benchmark::Vector;

struct Mesh {
  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<int> regions;
};

template <class Numbers>
void read_corners(std::istream& in, Numbers& corners, std::size_t first) {
  for (std::size_t& i : corners) in >> i, i -= first;
}

void read_medit(std::istream& in, Mesh& mesh) {
  std::string word;
  double skipped = 0;
  while (in >> word && word != "End") {
    if (word == "MeshVersionFormatted" || word == "Dimension") {
      in >> skipped;
      continue;
    }
    std::size_t count = 0;
    in >> count;
    if (word == "Vertices") {
      for (Vector& p : (mesh.points.resize(count), mesh.points)) in >> p.x >> p.y >> p.z >> skipped;
    } else if (word == "Triangles") {
      for (Triangle& t : (mesh.triangles.resize(count), mesh.triangles)) read_corners(in, t, 1), in >> skipped;
    } else if (word == "Tetrahedra") {
      mesh.regions.resize(count);
      mesh.tetrahedra.resize(count);
      for (std::size_t i = 0; i != count; ++i) read_corners(in, mesh.tetrahedra[i], 1), in >> mesh.regions[i];
    } else if (word == "Edges") {
      for (std::size_t i = 0; i != 3 * count; ++i) in >> skipped;
    } else {
      throw std::runtime_error("unexpected word " + word);
    }
  }
}

void read_off(std::istream& in, Mesh& mesh) {
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0;
  in >> word >> points >> faces >> edges;
  for (Vector& p : (mesh.points.resize(points), mesh.points)) in >> p.x >> p.y >> p.z;
  for (Triangle& t : (mesh.triangles.resize(faces), mesh.triangles)) {
    in >> edges;
    if (edges != 3) throw std::runtime_error("a face that is no triangle");
    read_corners(in, t, 0);
  }
}

Mesh read(const std::filesystem::path& path) {
  std::ifstream in(path);
  Mesh mesh;
  path.extension() == ".off" ? read_off(in, mesh) : read_medit(in, mesh);
  if (!in && !in.eof()) throw std::runtime_error("cannot read " + path.string());
  const auto check = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const std::size_t i : cell)
        if (i >= mesh.points.size()) throw std::runtime_error("a corner that is no point");
  };
  check(mesh.triangles);
  check(mesh.tetrahedra);
  return mesh;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

double angle(Vector a, Vector b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

/// Euler characteristic and all that, of the triangles of the file.
void print_topology(const Mesh& mesh) {
  const benchmark::SurfaceTopology of = benchmark::surface_topology(mesh.triangles, mesh.points.size());
  fmt::print("surface_vertices {} open_edges {} branching_edges {} pinched_vertices {} components {} euler {} ", of.vertices,
             of.open_edges, of.branching_edges, of.pinched_vertices, of.components, of.euler);
  if (mesh.tetrahedra.empty()) return;
  std::vector<Triangle> theirs = mesh.triangles, difference;
  for (Triangle& t : theirs) std::sort(t.begin(), t.end());
  std::sort(theirs.begin(), theirs.end());
  const std::vector<Triangle> ours = benchmark::interfaces(mesh.tetrahedra, mesh.regions);
  std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(difference));
  const benchmark::SurfaceTopology cells = benchmark::surface_topology(ours, mesh.points.size());
  fmt::print("unmatched_triangles {} cells_branching_edges {} cells_pinched_vertices {} cells_components {} cells_euler {} ",
             difference.size(), cells.branching_edges, cells.pinched_vertices, cells.components, cells.euler);
}

void print_tetrahedra(const Mesh& mesh) {
  double worst = 0, volume = 0, smallest = 180, largest = 0;
  std::size_t slivers = 0;
  for (const auto& corners : mesh.tetrahedra) {
    std::array<Vector, 4> p{};
    for (std::size_t i = 0; i != 4; ++i) p[i] = mesh.points[corners[i]];
    const Vector a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
    const double six_volumes = dot(a, cross(b, c));
    volume += std::abs(six_volumes) / 6;
    const Vector to_centre = (0.5 / six_volumes) * (dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a) + dot(c, c) * cross(a, b));
    double shortest = benchmark::unreached, least = 180;
    for (std::size_t i = 0; i != 4; ++i)
      for (std::size_t j = i + 1; j != 4; ++j) {
        const std::size_t k = i != 0 ? 0 : j != 1 ? 1 : 2, l = 6 - i - j - k;
        const Vector edge = p[j] - p[i];
        shortest = std::min(shortest, length(edge));
        const double dihedral = angle(cross(edge, p[k] - p[i]), cross(edge, p[l] - p[i]));
        least = std::min(least, dihedral);
        largest = std::max(largest, dihedral);
      }
    worst = std::max(worst, length(to_centre) / shortest);
    smallest = std::min(smallest, least);
    slivers += least < 5;
  }
  fmt::print("worst_radius_edge {:.6g} smallest_dihedral {:.4g} largest_dihedral {:.6g} slivers {} volume {:.9g} ", worst,
             smallest, largest, slivers, volume);
}

/// Distances from the surface of points of triangles, that are told by weights of their corners.
class Errors {
 public:
  Errors(const LevelFunction& f, const Mesh& mesh) : f_(&f), mesh_(&mesh) {}

  template <std::size_t count>
  void add(const Triangle& t, const double (&weights)[count][3]) {
    const auto& p = mesh_->points;
    const Vector a = p[t[0]], b = p[t[1]], c = p[t[2]], normal = cross(b - a, c - a);
    const double reach = std::max({length(b - a), length(c - b), length(a - c)}), area = 0.5 * length(normal);
    for (const auto& w : weights) {
      const double off = distance(*f_, (1 / (w[0] + w[1] + w[2])) * (w[0] * a + w[1] * b + w[2] * c), normal, reach);
      if (off == benchmark::unreached) {
        ++lost_;
        continue;
      }
      largest_ = std::max(largest_, off);
      sum_ += off;
      ++count_;
      sum_by_area_ += area * off;
      area_ += area;
    }
  }
  double largest() const { return largest_; }
  double mean() const { return sum_ / count_; }
  double mean_by_area() const { return sum_by_area_ / area_; }
  std::size_t lost() const { return lost_; }  ///< points from which the surface was not found nearer than the triangle is large

 private:
  const LevelFunction* f_;
  const Mesh* mesh_;
  double largest_ = 0, sum_ = 0, count_ = 0, sum_by_area_ = 0, area_ = 0;
  std::size_t lost_ = 0;
};

/// `mean_error` is the mean over the surface, from points inside the triangles; `lattice_error` that of the ten points that cut
/// sides into three, corners included, which is two thirds of it where the corners are on the surface.
void print_errors(const Mesh& mesh, const LevelFunction& f) {
  constexpr double corners[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr double on_sides[][3] = {{2, 1, 0}, {1, 2, 0}, {0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {1, 1, 1}};
  constexpr double inside[][3] = {{1, 1, 1}, {4, 1, 1}, {1, 4, 1}, {1, 1, 4}, {1, 5, 5},
                                  {5, 1, 5}, {5, 5, 1}, {1, 2, 3}, {3, 1, 2}, {2, 3, 1}};
  Errors of_corners(f, mesh), of_sides(f, mesh), of_inside(f, mesh);
  for (const auto& t : mesh.triangles) of_corners.add(t, corners), of_sides.add(t, on_sides), of_inside.add(t, inside);
  fmt::print("mean_error {:.4g} lattice_error {:.4g} largest_error {:.4g} vertex_error {:.3g} lost_samples {}\n",
             of_inside.mean_by_area(), 0.3 * of_corners.mean() + 0.7 * of_sides.mean(),
             std::max(of_sides.largest(), of_inside.largest()), of_corners.largest(),
             of_corners.lost() + of_sides.lost() + of_inside.lost());
}

void print_angles(const Mesh& mesh) {
  double smallest = 180;
  std::size_t sharp = 0;
  for (const auto& t : mesh.triangles) {
    double least = 180;
    for (std::size_t i = 0; i != 3; ++i) {
      const Vector corner = mesh.points[t[i]];
      least = std::min(least, angle(mesh.points[t[(i + 1) % 3]] - corner, mesh.points[t[(i + 2) % 3]] - corner));
    }
    smallest = std::min(smallest, least);
    sharp += least < 30 * (1 - 1e-9);
  }
  fmt::print("smallest_angle {:.4f} angles_under_30 {} ", smallest, sharp);
}

void run(char** a) {
  const Mesh mesh = read(a[1]);
  std::vector<char> used(mesh.points.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const std::size_t i : t) used[i] = 1;
  for (const auto& t : mesh.tetrahedra)
    for (const std::size_t i : t) used[i] = 1;
  fmt::print("vertices {} tetrahedra {} triangles {} ", std::count(used.begin(), used.end(), 1), mesh.tetrahedra.size(),
             mesh.triangles.size());
  print_topology(mesh);
  if (!mesh.tetrahedra.empty()) print_tetrahedra(mesh);
  print_angles(mesh);
  print_errors(mesh, benchmark::level_function(a[2]));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    run(argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "measure_smooth: {}\n", e.what());
    return 1;
  }
}
