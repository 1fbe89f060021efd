// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times CGAL Mesh_3's refinement of one smooth domain, as a peer: its defaults, without perturbation and exudation of slivers.
// Built a second time with CGAL_MESH_3_USE_LAZY_UNSORTED_REFINEMENT_QUEUE, which CGAL does not document, for a faster queue.
// Usage: mesh_3_driver DOMAIN FACET_ANGLE FACET_SIZE FACET_DISTANCE RADIUS_EDGE CELL_SIZE OUT [ERROR_BOUND]
// (benchmarks/smooth/surfaces.hpp; ERROR_BOUND is that of the search for the surface, a part of the domain's size, 0.001 by
// default)
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <fmt/format.h>

#include <delref/io/medit.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "../processor.hpp"
#include "surfaces.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Tr = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr>;
using Criteria = CGAL::Mesh_criteria_3<Tr>;
using benchmark::CommandLine;
namespace p = CGAL::parameters;

Criteria criteria(const CommandLine& line) {
  if (line.surface_only())
    return Criteria(p::facet_angle = line.facet_angle, p::facet_size = line.facet_size, p::facet_distance = line.facet_distance);
  return Criteria(p::facet_angle = line.facet_angle, p::facet_size = line.facet_size, p::facet_distance = line.facet_distance,
                  p::cell_radius_edge_ratio = line.radius_edge, p::cell_size = line.cell_size);
}

delref::TetrahedralMesh indexed(const C3t3& c3t3) {
  delref::TetrahedralMesh result;
  std::map<Tr::Vertex_handle, delref::TetrahedralMesh::Index> number;
  const auto index = [&](Tr::Vertex_handle v) {
    const auto [at, is_new] = number.try_emplace(v, static_cast<delref::TetrahedralMesh::Index>(result.points.size()));
    if (is_new) result.points.push_back({v->point().x(), v->point().y(), v->point().z()});
    return at->second;
  };
  for (auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f) {
    auto& corners = result.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) corners[static_cast<std::size_t>(i)] = index(f->first->vertex((f->second + 1 + i) % 4));
    result.triangle_markers.push_back(1);
  }
  for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c) {
    auto& corners = result.tetrahedra.emplace_back();
    for (int i = 0; i < 4; ++i) corners[static_cast<std::size_t>(i)] = index(c->vertex(i));
    result.regions.push_back(c3t3.subdomain_index(c));
  }
  if (result.tetrahedra.empty()) result.regions.clear();
  return result;
}

void mesh(const Domain& domain, const CommandLine& line) {
  const Criteria bounds = criteria(line);
  const double start = benchmark::processor_seconds();
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, bounds, p::no_perturb(), p::no_exude());
  fmt::print("seconds {:.6f} megabytes {:.1f} ", benchmark::processor_seconds() - start, benchmark::peak_megabytes());
  fmt::print("made_vertices {}", c3t3.triangulation().number_of_vertices());
  if (line.out == "-") return;
  delref::TetrahedralMesh result = indexed(c3t3);
  if (line.surface_only()) result.tetrahedra.clear(), result.regions.clear();
  delref::write_medit(line.out, result);
}

void run(const CommandLine& line, double error_bound) {
  std::size_t evaluations = 0;
  const bool is_named = benchmark::visit_surface(line.domain, [&]<class Surface>(Surface) {
    const auto function = [&](const Kernel::Point_3& q) {
      ++evaluations;
      return Surface::value({q.x(), q.y(), q.z()});
    };
    const double w = Surface::half_width;
    mesh(Domain::create_implicit_mesh_domain(function, CGAL::Bbox_3(-w, -w, -w, w, w, w), p::relative_error_bound = error_bound),
         line);
    fmt::print(" evaluations {}", evaluations);
  });
  if (!is_named) {
    const auto [path, value] = benchmark::level_set(line.domain);
    CGAL::Image_3 image;
    if (!image.read(path.c_str())) throw std::runtime_error("cannot read " + path);
    mesh(Domain::create_gray_image_mesh_domain(image, p::iso_value = value, p::relative_error_bound = error_bound), line);
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8 && argc != 9) return 2;
  try {
    run(CommandLine(argv), argc == 9 ? std::atof(argv[8]) : 1e-3);
  } catch (const std::exception& e) {
    fmt::print(stderr, "mesh_3_driver: {}\n", e.what());
    return 1;
  }
}
