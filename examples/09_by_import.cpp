// SPDX-License-Identifier: MIT
//
// Shows how to do the same by import: the level of example 5 and a criterion, without including a header of delref or CGAL.
#include <algorithm>
#include <cstdio>
#include <ranges>
#include <string_view>
#include <tuple>

import delref;

using Tr = delref::ConstrainedDelaunay2<1, 2>;

/// Example 5 explains it. Here it is for one triangulation type.
class ChannelLevel {
 public:
  using Element = Tr::Face;
  using Proposal = delref::Proposal<Tr>;
  explicit ChannelLevel(double width) : width_(width) {}

  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces() | std::views::filter([&](Element e) { return violates(tr, e); })) set_.add(tr, f, 0);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  delref::Point2 refinement_point(const Tr& tr, Element f) const { return delref::Circumcentre{}.point(shape(tr, f)); }
  delref::Verdict check_refinement_point(Tr&, const Proposal&) const { return delref::Verdict::permitted; }
  void before_insertion(Tr& tr, const Proposal& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  void after_insertion(Tr& tr, Tr::Vertex, const Proposal& proposal) {
    for (const Element f : proposal.zone->new_faces())
      if (tr.in_domain(f) && violates(tr, f)) set_.add(tr, f, 0);
  }
  bool violates(const Tr& tr, Element f) const {
    const auto on_segment = [&](Tr::Vertex v) { return tr.carrier(v).dimension < 2; };
    return std::ranges::all_of(tr.vertices(f), on_segment) && shape(tr, f).longest_squared() > width_ * width_;
  }

 private:
  static delref::TriangleShape shape(const Tr& tr, Element f) {
    const auto [a, b, c] = tr.vertices(f);
    return {tr.point(a), tr.point(b), tr.point(c)};
  }
  double width_;
  delref::ElementSet<Element, delref::FifoQueue<Element>> set_;
};
static_assert(delref::explain_level<ChannelLevel, Tr>());

/// No triangle is taller than so much.
struct Height {
  static constexpr std::string_view name = "height";
  static constexpr bool bounds_size = true;
  double most;
  bool is_met(const delref::TriangleShape& t) const {
    const auto [low, high] = std::ranges::minmax(t.corners | std::views::transform(&delref::Point2::y));
    return high - low <= most;
  }
};

int main() {
  delref::Pslg canal;
  canal.points = {{0, 0}, {9, 0}, {9, 6}, {8, 6}, {8, 1}, {0, 1}};
  canal.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
  const delref::CheckedPslg checked = delref::check_pslg(canal, {}, delref::Control{});
  Tr tr;
  const delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, delref::Control{}).domain();
  const delref::TriangleCriteria criteria(delref::MinimumAngle{}, Height{0.8});
  delref::Mesher mesher(tr, std::tuple_cat(delref::planar_levels<Tr>(domain, criteria), std::tuple(ChannelLevel(0.5))));
  const auto outcome = mesher.refine();
  const auto left = std::ranges::count_if(tr.domain_faces(), [&](Tr::Face f) { return mesher.level<2>().violates(tr, f); });
  std::printf("%zu vertices; %td triangles reach across\n", tr.number_of_vertices(), left);
  return outcome.unmet.empty() && left == 0 && outcome.levels[2].inserted > 0 ? 0 : 1;
}
