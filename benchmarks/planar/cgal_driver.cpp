// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times CGAL Mesh_2's refinement of one planar input, as a peer: its defaults, an angle bound through B, an edge bound through S.
// Usage: cgal_driver IN.poly B EDGE_BOUND(0 for none)
#include <chrono>
#include <cstdlib>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <delref/io/triangle_poly.hpp>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tds = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>, CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Cdt>;

static double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const delref::Pslg input = delref::read_triangle_poly(argv[1]);
  Cdt cdt;
  std::vector<Kernel::Point_2> points;
  for (const delref::Point2 p : input.points) points.emplace_back(p.x, p.y);
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  for (const auto& [a, b] : input.segments) segments.emplace_back(a, b);
  cdt.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
  std::vector<Kernel::Point_2> seeds;
  for (const delref::Point2 p : input.holes) seeds.emplace_back(p.x, p.y);

  const double before = peak_megabytes();
  const std::size_t vertices = cdt.number_of_vertices();
  const auto start = std::chrono::steady_clock::now();
  CGAL::Delaunay_mesher_2<Cdt, Criteria> mesher(cdt, Criteria(std::atof(argv[2]), std::atof(argv[3])));
  mesher.set_seeds(seeds.begin(), seeds.end());
  mesher.refine_mesh();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::size_t triangles = 0;
  for (auto f = cdt.finite_faces_begin(); f != cdt.finite_faces_end(); ++f) triangles += f->is_in_domain() ? 1 : 0;
  fmt::print("seconds {:.6f} vertices_made {} triangles {} megabytes {:.1f} complete true\n", seconds,
             cdt.number_of_vertices() - vertices, triangles, peak_megabytes() - before);
}
