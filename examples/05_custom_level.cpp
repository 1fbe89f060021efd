// SPDX-License-Identifier: MIT
//
// Shows how to write a refinement rule of your own and run it together with delref's.
#include <algorithm>
#include <cstdio>
#include <tuple>

#include <delref/algorithms/planar.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>

/// Wherever the domain is wider than `width`, no triangle reaches across it: a triangle with all three vertices on segments and
/// an edge longer than `width` is refined. (A flow solver wants an inner vertex in every channel.)
template <class Tr>
class ChannelLevel {
 public:
  using Element = typename Tr::Face;
  explicit ChannelLevel(double width) : width_(width) {}

  // The set of faces to refine. The mesher gives the level a slot in each face, where the set keeps the face's place.
  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces()) test(tr, f);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }

  // The point that kills a face, and what this level says to the points of others.
  delref::Point2 refinement_point(const Tr& tr, const Element& f) const { return delref::Circumcentre{}.point(shape(tr, f)); }
  delref::Verdict check_refinement_point(Tr&, const delref::Proposal<Tr>&) const { return delref::Verdict::permitted; }

  // Every insertion, by any level: faces die, and new ones are looked at.
  void before_insertion(Tr& tr, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  void after_insertion(Tr& tr, typename Tr::Vertex, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->new_faces())
      if (tr.in_domain(f)) test(tr, f);
  }

  bool violates(const Tr& tr, const Element& f) const {
    const auto on_segment = [&](const auto& v) { return tr.carrier(v).dimension < 2; };
    return std::ranges::all_of(tr.vertices(f), on_segment) && shape(tr, f).longest_squared() > width_ * width_;
  }

 private:
  void test(Tr& tr, const Element& f) {
    if (violates(tr, f)) set_.add(tr, f, shape(tr, f).shortest_squared());
  }
  static delref::TriangleShape shape(const Tr& tr, const Element& f) {
    return {tr.point(tr.vertex(f, 0)), tr.point(tr.vertex(f, 1)), tr.point(tr.vertex(f, 2))};
  }
  double width_;
  delref::ElementSet<Element, delref::FifoQueue<Element>> set_;
};

// One slot per edge, for the edges level; two per face, for the faces level and this one.
using Tr = delref::ConstrainedDelaunay2<1, 2>;
static_assert(delref::explain_level<ChannelLevel<Tr>, Tr>());  // a missing member is told in a sentence: example 8

int main() {
  delref::Pslg canal;
  canal.points = {{0, 0}, {9, 0}, {9, 6}, {8, 6}, {8, 1}, {0, 1}};
  canal.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};
  const delref::CheckedPslg checked = delref::check_pslg(canal, {}, delref::Control{});
  Tr tr;
  const delref::PlanarDomain domain = delref::PlanarDomainBuilder(tr, checked, delref::Control{}).domain();

  // The order of the tuple is the order of priority. Ours comes last: its points give way to the edges level's splits.
  const delref::TriangleCriteria criteria(delref::MinimumAngle{});
  delref::Mesher mesher(tr, std::tuple_cat(delref::planar_levels<Tr>(domain, criteria), std::tuple(ChannelLevel<Tr>(0.5))));
  const auto outcome = mesher.refine();
  const auto left = std::ranges::count_if(tr.domain_faces(), [&](auto f) { return mesher.level<2>().violates(tr, f); });
  std::printf("%zu vertices, %zu of them by our level; %td triangles reach across\n", tr.number_of_vertices(),
              outcome.levels[2].inserted, left);
  return outcome.unmet.empty() && left == 0 && outcome.levels[2].inserted > 0 ? 0 : 1;
}
