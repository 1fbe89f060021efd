// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times CGAL Mesh_3's refinement of one polyhedral input, as a peer: facet angle 25, one size for edges, facets and cells, features
// at 60 degrees. An input with region seeds is meshed as a complex of one patch per facet; each seed must then be the nearest one to
// everything in its region, as it is in a lattice of boxes.
// Usage: cgal_driver IN RADIUS_EDGE SIZE
#include <cstdlib>
#include <exception>
#include <map>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedral_complex_mesh_domain_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/refine_mesh_3.h>
#include <fmt/format.h>

#include <delref/domain/plc.hpp>
#include <delref/io/polyhedral_formats.hpp>

#include "figures.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Mesh_polyhedron_3<Kernel>::type;
using Solid = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel, Polyhedron>;
using Complex = CGAL::Polyhedral_complex_mesh_domain_3<Kernel, Polyhedron>;
using delref::Plc;
using delref::Point3;

/// The polygons of some facets, fans of triangles, as one surface.
Polyhedron surface(const Plc& plc, std::size_t first, std::size_t end) {
  std::vector<Kernel::Point_3> points;
  std::map<Plc::Index, std::size_t> number;
  std::vector<std::vector<std::size_t>> triangles;
  const auto point = [&](Plc::Index i) {
    const auto [at, is_new] = number.try_emplace(i, points.size());
    if (is_new) points.emplace_back(plc.points[i].x, plc.points[i].y, plc.points[i].z);
    return at->second;
  };
  for (std::size_t f = first; f < end; ++f)
    for (const auto& p : plc.facets[f].polygons)
      for (std::size_t i = 2; i < p.size(); ++i) triangles.push_back({point(p[0]), point(p[i - 1]), point(p[i])});
  namespace processing = CGAL::Polygon_mesh_processing;
  processing::orient_polygon_soup(points, triangles);
  Polyhedron result;
  processing::polygon_soup_to_polygon_mesh(points, triangles, result);
  return result;
}

/// The region that a point is in: 0 outside the bounding box of the complex, else one more than the nearest seed's number.
int region_at(const Plc& plc, Point3 p) {
  Point3 low = plc.points[0], high = low;
  for (const Point3 q : plc.points)
    for (double Point3::*k : {&Point3::x, &Point3::y, &Point3::z}) low.*k = std::min(low.*k, q.*k), high.*k = std::max(high.*k, q.*k);
  for (double Point3::*k : {&Point3::x, &Point3::y, &Point3::z})
    if (p.*k < low.*k || p.*k > high.*k) return 0;
  std::size_t nearest = 0;
  for (std::size_t r = 1; r < plc.regions.size(); ++r)
    if (squared_distance(p, plc.regions[r].seed) < squared_distance(p, plc.regions[nearest].seed)) nearest = r;
  return static_cast<int>(nearest) + 1;
}

/// The regions in front of a facet and behind it, as its first three corners turn.
std::pair<int, int> sides(const Plc& plc, const Plc::Facet& facet) {
  const auto& p = facet.polygons[0];
  const Point3 a = plc.points[p[0]], b = plc.points[p[1]], c = plc.points[p[2]];
  const Point3 middle = a + (1.0 / 3) * ((b - a) + (c - a));
  const delref::Vector3 step = (0.1 / std::sqrt(squared_distance(a, b))) * cross(b - a, c - a);
  return {region_at(plc, middle + step), region_at(plc, middle + -1.0 * step)};
}

template <class Domain>
void mesh(const Domain& domain, double radius_edge, double size) {
  using Tr = typename CGAL::Mesh_triangulation_3<Domain>::type;
  using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Tr, typename Domain::Corner_index, typename Domain::Curve_index>;
  namespace p = CGAL::parameters;
  const CGAL::Mesh_criteria_3<Tr> criteria(p::edge_size = size, p::facet_angle = 25, p::facet_size = size,
                                           p::cell_radius_edge_ratio = radius_edge, p::cell_size = size);
  const double start = benchmark::processor_seconds();
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, p::no_perturb(), p::no_exude());
  fmt::print("seconds {:.6f} megabytes {:.1f} ", benchmark::processor_seconds() - start, benchmark::peak_megabytes());

  delref::TetrahedralMesh result;
  std::map<typename Tr::Vertex_handle, delref::TetrahedralMesh::Index> number;
  for (auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c) {
    auto& corners = result.tetrahedra.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const auto v = c->vertex(i);
      const auto [at, is_new] = number.try_emplace(v, static_cast<delref::TetrahedralMesh::Index>(result.points.size()));
      if (is_new) result.points.push_back({v->point().x(), v->point().y(), v->point().z()});
      corners[static_cast<std::size_t>(i)] = at->second;
    }
  }
  benchmark::print_figures(result, radius_edge);
}

void run(char** a) {
  const Plc plc = delref::read_plc(a[1]).plc;
  const double radius_edge = std::atof(a[2]), size = std::atof(a[3]);
  if (plc.regions.empty()) {
    Polyhedron boundary = surface(plc, 0, plc.facets.size());
    Solid domain(boundary);
    domain.detect_features(60);
    return mesh(domain, radius_edge, size);
  }
  std::vector<Polyhedron> patches;
  std::vector<std::pair<int, int>> regions;
  for (std::size_t f = 0; f < plc.facets.size(); ++f) {
    patches.push_back(surface(plc, f, f + 1));
    regions.push_back(sides(plc, plc.facets[f]));
  }
  Complex domain(patches.begin(), patches.end(), regions.begin(), regions.end());
  domain.detect_features(60);
  mesh(domain, radius_edge, size);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    run(argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "cgal_driver: {}\n", e.what());
    return 1;
  }
}
