// SPDX-License-Identifier: MIT
//
// A program of somebody else, by import: meshes a square with delref's levels, a criterion and a level of its own.
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <tuple>

import delref;

namespace {

using Tr = delref::ConstrainedDelaunay2<1, 2>;

/// Triangles left of a line are small.
struct SmallOnTheLeft {
  static constexpr std::string_view name = "small on the left";
  static constexpr bool bounds_size = true;
  bool is_met(const delref::TriangleShape& t) const { return t.centroid().x > 0.5 || t.longest_squared() <= 0.01; }
};

/// No face holds the point (0.9, 0.9) and is larger than 0.001.
class FineAroundPoint {
 public:
  using Element = Tr::Face;
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces()) test(tr, f);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  delref::Point2 refinement_point(const Tr& tr, Element f) const { return delref::Circumcentre{}.point(shape(tr, f)); }
  delref::Verdict check_refinement_point(Tr&, const delref::Proposal<Tr>&) const { return delref::Verdict::permitted; }
  void before_insertion(Tr& tr, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  void after_insertion(Tr& tr, Tr::Vertex, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->new_faces())
      if (tr.in_domain(f)) test(tr, f);
  }
  static bool is_coarse(const Tr& tr, Element f) {
    const delref::TriangleShape t = shape(tr, f);
    const delref::Point2 p{0.9, 0.9};
    for (std::size_t i = 0; i < 3; ++i)
      if (cross(t.corners[(i + 1) % 3] - t.corners[i], p - t.corners[i]) < 0) return false;
    return t.doubled_area > 0.002;
  }

 private:
  void test(Tr& tr, Element f) {
    if (is_coarse(tr, f)) set_.add(tr, f, 0);
  }
  static delref::TriangleShape shape(const Tr& tr, Element f) {
    const auto [a, b, c] = tr.vertices(f);
    return {tr.point(a), tr.point(b), tr.point(c)};
  }
  delref::ElementSet<Element, delref::LifoQueue<Element>> set_;
};
static_assert(delref::explain_level<FineAroundPoint, Tr>());

}  // namespace

int main() {
  delref::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const delref::CheckedPslg checked = delref::check_pslg(square, {}, delref::Control{});
  Tr tr;
  const delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, delref::Control{}).domain();
  const delref::TriangleCriteria criteria(delref::MinimumAngle{}, SmallOnTheLeft{});
  delref::Mesher mesher(tr, std::tuple_cat(delref::planar_levels<Tr>(domain, criteria), std::tuple(FineAroundPoint{})));
  const auto outcome = mesher.refine();
  bool met = outcome.complete() && outcome.unmet.empty() && outcome.levels[2].inserted > 0;
  for (const Tr::Face f : tr.domain_faces()) met = met && !FineAroundPoint::is_coarse(tr, f);
  std::printf("%zu vertices, %zu unmet\n", tr.number_of_vertices(), outcome.unmet.size());
  return met ? 0 : 1;
}
