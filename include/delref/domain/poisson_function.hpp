// SPDX-License-Identifier: GPL-3.0-or-later
//
// The function of a Poisson reconstruction (Kazhdan, Bolitho, Hoppe 2006) in CGAL's variant, which is linear on the tetrahedra of a
// Delaunay triangulation of the samples and Steiner points, copied into a form that is fast to ask and that threads may share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include <CGAL/Poisson_reconstruction_function.h>

#include <delref/core/budget.hpp>
#include <delref/domain/piecewise_linear_function.hpp>
#include <delref/domain/poisson_system.hpp>
#include <delref/domain/prepare_point_set.hpp>

namespace delref::detail {

/// Called by CGAL before each sample is inserted; copies share the count.
struct PoissonVisitor {
  StopCheck* check;
  void before_insertion() const { (*check)(); }
};

/// A copy of the function on CGAL's triangulation. Changes the numbers that CGAL keeps in it.
template <class Tr>
PiecewiseLinearFunction copy_linear_function(const Tr& tr) {
  std::vector<PiecewiseLinearFunction::Corner> corners{{{}, std::numeric_limits<double>::infinity()}};
  tr.infinite_vertex()->index() = PiecewiseLinearFunction::infinite_corner;
  for (const auto v : tr.finite_vertex_handles()) {
    v->index() = static_cast<unsigned>(corners.size());
    corners.push_back({{v->point().x(), v->point().y(), v->point().z()}, v->f()});
  }
  int count = 0;
  for (const auto c : tr.all_cell_handles()) c->info() = count++;
  std::vector<LinearCell> cells;
  cells.reserve(static_cast<std::size_t>(count));
  for (const auto c : tr.all_cell_handles()) {
    LinearCell& cell = cells.emplace_back();
    for (int i = 0; i != 4; ++i) {
      cell.corner[static_cast<std::size_t>(i)] = c->vertex(i)->index();
      cell.neighbour[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(c->neighbor(i)->info());
    }
  }
  return {std::move(corners), std::move(cells)};
}

/// CGAL fixes the value of one vertex far outside, for the equations to have one solution; what it fixed says nothing of the surface, and
/// could make a bubble there. It becomes the mean of the values around it.
template <class Tr>
void forget_fixed_value(const Tr& tr, PiecewiseLinearFunction& function) {
  for (const auto v : tr.finite_vertex_handles()) {
    if (!tr.is_constrained(v)) continue;
    std::vector<typename Tr::Vertex_handle> around;
    tr.finite_adjacent_vertices(v, std::back_inserter(around));
    double sum = 0;
    for (const auto w : around) sum += function.corners()[w->index()].value;
    function.set_value(v->index(), sum / static_cast<double>(around.size()));
  }
}

/// The function through samples: negative inside. Throws `InvalidInput` when its equations cannot be solved, `Interrupted` when the control
/// says stop.
inline PiecewiseLinearFunction poisson_function(const std::vector<Sample>& samples, const Control& control) {
  StopCheck check(control);
  const PoissonVisitor visitor{&check};
  CGAL::Poisson_reconstruction_function<SpatialKernel> reconstruction(samples.begin(), samples.end(), CGAL::Nth_of_tuple_property_map<0, Sample>(),
                                                                      CGAL::Nth_of_tuple_property_map<1, Sample>(), visitor);
  reconstruction.compute_implicit_function(PoissonSystem(control), visitor);
  throw_if_stopped(control);
  PiecewiseLinearFunction function = copy_linear_function(reconstruction.tr());
  forget_fixed_value(reconstruction.tr(), function);
  return function;
}

}  // namespace delref::detail
