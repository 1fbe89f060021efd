// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times CGAL's older Surface_mesher on one smooth surface, as a peer. It makes no tetrahedra.
// Usage: surface_mesher_driver DOMAIN FACET_ANGLE FACET_SIZE FACET_DISTANCE 0 0 OUT [ERROR_BOUND]
// (benchmarks/smooth/surfaces.hpp; ERROR_BOUND is that of the search for the surface, a part of the bounding ball's radius, 0.001
// by default)
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Gray_level_image_3.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>
#include <fmt/format.h>

#include <delref/io/medit.hpp>
#include <delref/mesh/tetrahedral_mesh.hpp>

#include "../processor.hpp"
#include "surfaces.hpp"

namespace {

using Tr = CGAL::Surface_mesh_default_triangulation_3;
using C2t3 = CGAL::Complex_2_in_triangulation_3<Tr>;
using Traits = Tr::Geom_traits;
using Point = Traits::Point_3;
using Function = std::function<double(const Point&)>;
using Surface3 = CGAL::Implicit_surface_3<Traits, Function>;
using benchmark::CommandLine;

delref::TetrahedralMesh indexed(const C2t3& c2t3) {
  delref::TetrahedralMesh result;
  std::map<Tr::Vertex_handle, delref::TetrahedralMesh::Index> number;
  for (auto f = c2t3.facets_begin(); f != c2t3.facets_end(); ++f) {
    auto& corners = result.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto v = f->first->vertex((f->second + 1 + i) % 4);
      const auto [at, is_new] = number.try_emplace(v, static_cast<delref::TetrahedralMesh::Index>(result.points.size()));
      if (is_new) result.points.push_back({v->point().x(), v->point().y(), v->point().z()});
      corners[static_cast<std::size_t>(i)] = at->second;
    }
    result.triangle_markers.push_back(1);
  }
  return result;
}

/// `ball` must have its centre where the function is negative.
void mesh(const Function& function, const Traits::Sphere_3& ball, const CommandLine& line, double error_bound) {
  std::size_t evaluations = 0;
  const Function counted = [&](const Point& q) {
    ++evaluations;
    return function(q);
  };
  const CGAL::Surface_mesh_default_criteria_3<Tr> criteria(line.facet_angle, line.facet_size, line.facet_distance);
  const double start = benchmark::processor_seconds();
  Tr tr;
  C2t3 c2t3(tr);
  CGAL::make_surface_mesh(c2t3, Surface3(counted, ball, error_bound), criteria, CGAL::Non_manifold_tag());
  fmt::print("seconds {:.6f} megabytes {:.1f} ", benchmark::processor_seconds() - start, benchmark::peak_megabytes());
  fmt::print("made_vertices {} evaluations {}\n", tr.number_of_vertices(), evaluations);
  if (line.out != "-") delref::write_medit(line.out, indexed(c2t3));
}

/// A grid point with a value inside the level set: the one nearest to the middle of the image.
Point inside(const CGAL::Image_3& image, float value) {
  Point best;
  double least = -1;
  for (std::size_t k = 0; k != image.zdim(); ++k)
    for (std::size_t j = 0; j != image.ydim(); ++j)
      for (std::size_t i = 0; i != image.xdim(); ++i) {
        const auto from_middle = [](std::size_t a, std::size_t n, double v) {
          return (static_cast<double>(a) - 0.5 * static_cast<double>(n)) * v;
        };
        const double x = from_middle(i, image.xdim(), image.vx()), y = from_middle(j, image.ydim(), image.vy());
        const double z = from_middle(k, image.zdim(), image.vz()), distance = x * x + y * y + z * z;
        if (!(image.value(i, j, k) > value) || (least >= 0 && distance >= least)) continue;
        least = distance;
        best =
            Point(static_cast<double>(i) * image.vx(), static_cast<double>(j) * image.vy(), static_cast<double>(k) * image.vz());
      }
  if (least < 0) throw std::invalid_argument("no value of the image is above the level");
  return best;
}

void run(const CommandLine& line, double error_bound) {
  const bool is_named = benchmark::visit_surface(line.domain, [&]<class Surface>(Surface) {
    constexpr benchmark::Vector c = Surface::inside;
    const double radius = 1.75 * Surface::half_width + std::hypot(c.x, c.y, c.z);
    const auto function = [](const Point& q) { return Surface::value({q.x(), q.y(), q.z()}); };
    mesh(function, {Point(c.x, c.y, c.z), radius * radius}, line, error_bound);
  });
  if (is_named) return;
  const auto [path, value] = benchmark::level_set(line.domain);
  const CGAL::Gray_level_image_3<double, Point> image(path, value);
  const double x = static_cast<double>(image.xdim()) * image.vx(), y = static_cast<double>(image.ydim()) * image.vy();
  const double z = static_cast<double>(image.zdim()) * image.vz();
  mesh(image, {inside(image, value), x * x + y * y + z * z}, line, error_bound);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8 && argc != 9) return 2;
  try {
    run(CommandLine(argv), argc == 9 ? std::atof(argv[8]) : 1e-3);
  } catch (const std::exception& e) {
    fmt::print(stderr, "surface_mesher_driver: {}\n", e.what());
    return 1;
  }
}
