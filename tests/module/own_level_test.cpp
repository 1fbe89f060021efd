// SPDX-License-Identifier: GPL-3.0-or-later
//
// A level, a criterion and an observer of one's own, written, composed with delref's levels and run by import alone; and the law
// tests on them.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

import delref;

#include "scenes.hpp"

namespace {

using Tr = delref::ConstrainedDelaunay2<1, 2>;

/// No triangle has a vertex of the hole's boundary and one of the outer boundary.
class NoBridges {
 public:
  using Element = Tr::Face;
  explicit NoBridges(const delref::PlanarDomain& domain) : domain_(&domain) {}

  std::string_view name() const { return "no bridges"; }
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces() | std::views::filter([&](Element f) { return is_bridge(tr, f); })) set_.add(tr, f, 0);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  template <class F>
  void for_each_queued(F&& f) const { set_.for_each(f); }

  delref::Point2 refinement_point(const Tr& tr, Element f) const { return delref::Circumcentre{}.point(shape(tr, f)); }
  delref::Verdict check_refinement_point(Tr&, const delref::Proposal<Tr>&) const { return delref::Verdict::permitted; }
  void before_insertion(Tr& tr, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  void after_insertion(Tr& tr, Tr::Vertex, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->new_faces())
      if (tr.in_domain(f) && is_bridge(tr, f)) set_.add(tr, f, 0);
  }

  bool is_bridge(const Tr& tr, Element f) const {
    const auto marker = [&](Tr::Vertex v) { return this->marker(tr.carrier(v)); };
    const auto vertices = tr.vertices(f);
    const auto markers = vertices | std::views::transform(marker);
    return std::ranges::find(markers, 1) != markers.end() && std::ranges::find(markers, 2) != markers.end();
  }

 private:
  int marker(delref::Carrier c) const {
    if (c.dimension == 2) return 0;
    return c.dimension == 0 ? (c.index < 4 ? 1 : 2) : domain_->pslg.segment_marker(domain_->segments[c.index].original);
  }
  static delref::TriangleShape shape(const Tr& tr, Element f) {
    const auto [a, b, c] = tr.vertices(f);
    return {tr.point(a), tr.point(b), tr.point(c)};
  }

  const delref::PlanarDomain* domain_;
  delref::ElementSet<Element, delref::FifoQueue<Element>> set_;
};
static_assert(delref::explain_level<NoBridges, Tr>());

/// No triangle is wider than so much.
struct Width {
  static constexpr std::string_view name = "width";
  static constexpr bool bounds_size = true;
  double most = 1;
  bool is_met(const delref::TriangleShape& t) const {
    const auto [low, high] = std::ranges::minmax(t.corners | std::views::transform(&delref::Point2::x));
    return high - low <= most;
  }
};
static_assert(delref::explain_triangle_criterion<Width>());

struct LastVertex {
  delref::Point2 point;
  void on_after_insertion(const Tr& tr, Tr::Vertex v, const delref::Proposal<Tr>&) { point = tr.point(v); }
};

auto levels(const delref::PlanarDomain& domain) {
  const delref::TriangleCriteria criteria(delref::MinimumAngle{}, Width{0.4});
  return std::tuple_cat(delref::planar_levels<Tr>(domain, criteria), std::tuple(NoBridges(domain)));
}

}  // namespace

TEST_CASE("a level and a criterion of one's own refine together with delref's by import") {
  const auto checked = delref::check_pslg(square_with_hole(), {}, delref::Control{});
  Tr tr;
  const delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, delref::Control{}).domain();
  delref::Mesher mesher(tr, levels(domain));
  LastVertex last;
  const auto outcome = mesher.refine(delref::Control{}, last);
  CHECK(outcome.complete());
  CHECK(outcome.unmet.empty());
  CHECK(outcome.levels.at(2).name == "no bridges");
  CHECK(outcome.levels.at(2).inserted > 0);
  CHECK(std::ranges::none_of(tr.domain_faces(), [&](Tr::Face f) { return mesher.level<2>().is_bridge(tr, f); }));
  CHECK(std::ranges::any_of(tr.finite_vertices(), [&](Tr::Vertex v) { return tr.point(v) == last.point; }));

  const delref::PlanarMesh mesh = delref::extract_planar_mesh(tr, domain, {"edges", "faces", "no bridges"});
  for (const auto& [a, b, c] : mesh.triangles) CHECK(Width{0.4}.is_met({mesh.points[a], mesh.points[b], mesh.points[c]}));
}

TEST_CASE("a level of one's own keeps the laws, tried by import") {
  const auto checked = delref::check_pslg(square_with_hole(), {}, delref::Control{});
  const std::vector<std::string> broken = delref::testing::check_laws([&](auto run) {
    Tr tr;
    const delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, delref::Control{}).domain();
    run(tr, levels(domain));
  });
  CHECK(broken == std::vector<std::string>{});
}
