// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions on the two sides of facets: which new cells are unsure of theirs, and flat cells of cocircular points, which rounding
// may have put on the wrong side of a facet on the border of the domain.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <delref/core/proposal.hpp>
#include <delref/levels/region_repair.hpp>
#include <delref/levels/subfacet_set.hpp>
#include <delref/triangulation/spatial_concept.hpp>

namespace delref {

/// Keeps the regions of cells right beside the facets of a labelled domain. `repair` must outlive it.
template <SpatialTriangulation Tr, class Queue>
class FacetSides {
  using Set = SubfacetSet<Tr, Queue>;
  using Complex = typename Set::Complex;
  using Id = typename Set::Id;
  using Cell = typename Tr::Cell;
  using Facet = typename Tr::Facet;

 public:
  explicit FacetSides(RegionRepair<Tr>& repair) : repair_(&repair) {}

  /// To be called when every facet is whole and the cells have their regions. Until then nothing is done.
  void domain_is_labelled(Tr& tr, Set& subfacets) {
    is_labelled_ = true;
    note_regions(tr, subfacets.complex());
    for (const Cell c : tr.finite_cells()) push_out(tr, subfacets, c);
  }

  void before_insertion(Tr& tr, std::span<const Cell> dying) {
    is_unsure_ = repair_->remove(tr, dying);
    repair_->forget();
  }
  /// `tore`: the insertion left a facet with a gap.
  void after_insertion(Tr& tr, Set& subfacets, const Proposal<Tr>& proposal, bool tore) {
    if (!is_labelled_) return;
    const auto& changed = subfacets.changed();
    if (tore || is_unsure_ || !changed.empty() || (proposal.carrier.dimension < 3 && !are_consistent(tr, proposal.zone->new_cells())))
      for (const Cell c : proposal.zone->new_cells()) repair_->add(tr, c);
    for (const Facet& f : changed)
      for (const Facet& side : {f, tr.mirror(f)})
        if (repair_->is_flat(tr, tr.cell(side))) repair_->add(tr, tr.cell(side));
    if (subfacets.missing() > 0 || repair_->empty()) return;
    repair_->settle(tr, [&](const Facet& f) { return region_beside(tr, subfacets.complex(), f); });
    const std::vector<Cell> settled = repair_->settled();
    for (const Cell c : settled) push_out(tr, subfacets, c);
  }

 private:
  /// Whether the cell of a subfacet is in front of it, whence its corners are counterclockwise.
  static bool is_in_front(const Tr& tr, const Complex& complex, const Facet& f, Id e) {
    const auto v = tr.vertices(f);
    const auto& corners = complex[e].corners;
    const auto first = static_cast<std::size_t>(std::ranges::find(v, corners[0]) - v.begin());
    return v[(first + 1) % 3] == corners[1];
  }
  static Id subfacet(const Tr& tr, const Complex& complex, const Facet& f) {
    const auto [a, b, c] = tr.vertices(f);
    return complex.find(tr, a, b, c);
  }
  /// The region at a subfacet, on the side of the cell.
  static int region_beside(const Tr& tr, const Complex& complex, const Facet& f) {
    const Id e = subfacet(tr, complex, f);
    return e == Complex::none ? tr.region(tr.cell(tr.mirror(f))) : complex[e].regions[is_in_front(tr, complex, f, e) ? 0 : 1];
  }
  /// Every subfacet learns the regions on its sides.
  static void note_regions(const Tr& tr, Complex& complex) {
    complex.for_each([&](Id e) {
      const auto [a, b, c] = complex[e].corners;
      const auto f = tr.find_facet(a, b, c);
      if (!f) return;
      const int here = tr.region(tr.cell(*f)), there = tr.region(tr.cell(tr.mirror(*f)));
      complex.set_regions(e, is_in_front(tr, complex, *f, e) ? std::array{here, there} : std::array{there, here});
    });
  }

  /// Whether the regions of cells are those of their neighbours, but for the other side of a facet.
  static bool are_consistent(const Tr& tr, std::span<const Cell> cells) {
    return std::ranges::all_of(cells, [&](Cell c) {
      for (int i = 0; i < 4; ++i)
        if (const Facet f = tr.facet(c, i); !tr.is_marked(f) && tr.region(tr.cell(tr.mirror(f))) != tr.region(c)) return false;
      return true;
    });
  }

  /// A cell with all of its corners on one facet: rounding makes such of cocircular points, with both diagonals of their quadrilateral
  /// as edges. Gives the two faces that are subfacets.
  static std::optional<std::array<int, 2>> flat_pair(const Tr& tr, const Complex& complex, Cell c) {
    if (!tr.has_marked_facets(c)) return std::nullopt;
    std::array<int, 2> pair{};
    std::array<Id, 2> elements{};
    std::size_t n = 0;
    for (int i = 0; i < 4; ++i) {
      if (!tr.is_marked(tr.facet(c, i))) continue;
      const Id e = subfacet(tr, complex, tr.facet(c, i));
      if (e == Complex::none) continue;
      for (std::size_t k = 0; k < n && k < 2; ++k)
        if (complex[elements[k]].facet == complex[e].facet) return std::array{pair[k], i};
      if (n < 2) pair[n] = i, elements[n] = e;
      ++n;
    }
    return std::nullopt;
  }
  /// Puts a flat cell on the other side of its facet when that is outside the domain, by giving the facet the other diagonal; and then
  /// those behind it, for more than four cocircular points make layers of flat cells.
  void push_out(Tr& tr, Set& subfacets, Cell first) {
    layers_.assign(1, first);
    while (!layers_.empty()) {
      const Cell c = layers_.back();
      layers_.pop_back();
      if (tr.region(c) < 0 || !push_out_one(tr, subfacets, c)) continue;
      for (int i = 0; i < 4; ++i)
        if (const Facet f = tr.facet(c, i); tr.is_marked(f)) layers_.push_back(tr.cell(tr.mirror(f)));
    }
  }
  bool push_out_one(Tr& tr, Set& subfacets, Cell c) {
    const Complex& complex = subfacets.complex();
    const auto pair = flat_pair(tr, complex, c);
    if (!pair) return false;
    std::array<Id, 2> elements{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Facet f = tr.facet(c, (*pair)[i]);
      if (tr.region(tr.cell(tr.mirror(f))) >= 0) return false;
      elements[i] = subfacet(tr, complex, f);
    }
    const auto side = complex.side_between(elements[0], elements[1]);
    if (!side || !complex.is_convex(tr, *side)) return false;
    subfacets.flip(tr, *side);
    tr.set_region(c, -1);
    repair_->add_settled(c);
    for (int i = 0; i < 4; ++i)
      if (const Id e = subfacet(tr, complex, tr.facet(c, i)); e == elements[0] || e == elements[1]) subfacets.found(tr, e, tr.facet(c, i));
    return true;
  }

  RegionRepair<Tr>* repair_;
  bool is_labelled_ = false, is_unsure_ = false;
  std::vector<Cell> layers_;
};

}  // namespace delref
