// SPDX-License-Identifier: GPL-3.0-or-later
//
// Puts a planar straight line graph into a triangulation: vertices, segments, regions, sharp corners.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/domain/insert_planar_graph.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/label_planar_domain.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>
#include <delref/domain/pslg_crossings.hpp>
#include <delref/domain/pslg_scale.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

namespace delref {

/// Says which segments cross or overlap, or that they do so by rounding alone.
[[noreturn]] inline void refuse_crossings(const CheckedPslg& checked, const Control& control) {
  std::vector<Defect> defects = find_crossings(checked, control);
  if (defects.empty())
    defects.push_back({"segments lie so close to each other that they cross in the vertices that rounding puts on them; move them "
                       "apart, or merge near vertices (merge_tolerance, --merge-tolerance)",
                       {}});
  throw InvalidInput(std::move(defects));
}

/// Builds a triangulation and the domain of a checked PSLG (`check_pslg`), scaled by a power of two where its coordinates are
/// extreme. Use once: the constructor does the work.
///
/// Four vertices of a box around the input (`insert_planar_points`) belong to no domain. Throws `InvalidInput` when segments cross
/// or overlap, or when there is no bounded region; `Interrupted`.
template <class Tr>
class PlanarDomainBuilder {
  using Vertex = typename Tr::Vertex;

 public:
  PlanarDomainBuilder(Tr& tr, const CheckedPslg& checked, const Control& control) : tr_(tr), checked_(checked), control_(control) {
    domain_.scale = scale_exponent(checked.pslg);
    domain_.pslg = scaled(checked.pslg, domain_.scale);
    vertices_ = insert_planar_points(tr_, std::span<const Point2>(domain_.pslg.points), domain_.pslg.points.size(), control_);
    insert_segments();
    notes_ = PlanarDomainLabeller<Tr>(tr_, domain_, checked_, vertices_, control_).notes();
  }

  /// The domain; the builder is then empty.
  PlanarDomain domain() && { return std::move(domain_); }
  /// Things that are no errors and that a user may want to know.
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  std::array<Vertex, 2> ends(std::size_t s) const {
    return {vertices_[domain_.pslg.segments[s][0]], vertices_[domain_.pslg.segments[s][1]]};
  }

  void insert_segments() {
    const std::size_t count = domain_.pslg.segments.size();
    try {
      for (std::size_t s = 0; s < count; ++s) {
        if (s % 4096 == 0) throw_if_stopped(control_);
        insert_planar_chain<Tr>(tr_, ends(s));
      }
    } catch (const typename Tr::Cgal::Intersection_of_constraints_exception&) {
      refuse_crossings(checked_, control_);
    }
    for (std::size_t s = 0; s < count; ++s)
      if (!name_planar_chain<Tr>(tr_, domain_, ends(s), static_cast<Pslg::Index>(s))) refuse_crossings(checked_, control_);
    domain_.index_segments();
  }

  Tr& tr_;
  const CheckedPslg& checked_;
  const Control& control_;
  PlanarDomain domain_;
  std::vector<Vertex> vertices_;
  std::vector<std::string> notes_;
};

}  // namespace delref
