// SPDX-License-Identifier: MIT
//
// Shows how to put a level of your own between delref's facets and tetrahedra: what crosses a membrane is to be fine.
#include <algorithm>
#include <cstdio>
#include <tuple>
#include <utility>

#include <delref/algorithms/polyhedral_refinement.hpp>

/// Refines the tetrahedra of the domain that reach across the plane x = 0.4 and whose circumradius is above a bound.
template <class Tr>
class MembraneLevel {
 public:
  using Element = typename Tr::Cell;
  MembraneLevel(double radius, delref::RegionRepair<Tr>& repair) : radius_(radius), repair_(&repair) {}
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element c : tr.domain_cells()) test(tr, c);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  // The point that kills a cell. Edges and facets come first and reject it in their favour; here, nothing leaves the domain.
  delref::Point3 refinement_point(const Tr& tr, const Element& c) {
    repair_->set_for_size(true);  // the facets are to be refined for this in any case
    return shape(tr, c).circumcentre;
  }
  delref::Verdict check_refinement_point(Tr& tr, const delref::Proposal<Tr>& proposal) const {
    const bool inside = std::ranges::all_of(proposal.zone->dying_cells(), [&](const Element& c) { return tr.in_domain(c); });
    return proposal.carrier.dimension < 3 || inside ? delref::Verdict::permitted : delref::Verdict::rejected_forever;
  }
  // Every insertion: cells die, new ones are looked at, and those whose region was unsure until now.
  void before_insertion(Tr& tr, const delref::Proposal<Tr>& proposal) {
    for (const Element c : proposal.zone->dying_cells()) set_.erase(tr, c);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex, const delref::Proposal<Tr>& proposal) {
    for (const Element c : proposal.zone->new_cells()) test(tr, c);
    for (const Element c : repair_->settled()) test(tr, c);
  }

 private:
  void test(Tr& tr, const Element& c) {
    const delref::TetrahedronShape t = shape(tr, c);
    const auto [low, high] = std::ranges::minmax(t.corners, {}, &delref::Point3::x);
    if (tr.in_domain(c) && low.x < 0.4 && high.x > 0.4 && t.squared_circumradius > radius_ * radius_) set_.add(tr, c, 0);
  }
  static delref::TetrahedronShape shape(const Tr& tr, const Element& c) {
    return std::apply([&](auto... v) { return delref::TetrahedronShape({tr.point(v)...}); }, tr.vertices(c));
  }
  double radius_;
  delref::RegionRepair<Tr>* repair_;
  delref::ElementSet<Element, delref::FifoQueue<Element>> set_;
};
using Tr = delref::Delaunay3<2>;  // two slots per cell: for this level and the tetrahedra level
static_assert(delref::explain_level<MembraneLevel<Tr>, Tr>());

int main() {
  delref::Plc box;
  box.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  box.facets = {{{{0, 1, 2, 3}}, {}, 0}, {{{4, 5, 6, 7}}, {}, 0}, {{{0, 1, 5, 4}}, {}, 0},
                {{{1, 2, 6, 5}}, {}, 0}, {{{2, 3, 7, 6}}, {}, 0}, {{{3, 0, 4, 7}}, {}, 0}};
  const delref::PolyhedralDomain domain = delref::check_plc(box);
  Tr tr;  // as in example 12: conform, label, refine
  const auto vertices = delref::insert_input_points(tr, domain, delref::Control{});
  delref::RegionRepair<Tr> repair;
  delref::Mesher conform(tr, delref::conforming_levels<Tr>(tr, domain, vertices, repair));
  conform.refine();
  delref::PolyhedralDomainLabeller<Tr>(tr, domain, delref::Control{});
  auto facets = conform.release<1>();
  facets.domain_is_labelled(tr);
  const delref::SmallAngleGuard guard(domain);
  delref::TetrahedraLevel3 tetrahedra(delref::TetrahedronCriteria(delref::RadiusEdge{2}), repair, guard);
  delref::Mesher mesher(tr, std::tuple(conform.release<0>(), std::move(facets), MembraneLevel<Tr>(0.06, repair), std::move(tetrahedra)));
  const auto outcome = mesher.refine();
  std::printf("%zu vertices, %zu of them by our level\n", tr.number_of_vertices(), outcome.levels[2].inserted);
  return outcome.complete() && outcome.unmet.empty() && outcome.levels[2].inserted > 0 ? 0 : 1;
}
