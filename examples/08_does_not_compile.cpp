// SPDX-License-Identifier: MIT
//
// Shows how the compiler tells what a level lacks: this one forgets to look at the new faces. README.md has what it says.
#include <delref/core/mesher.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/levels/point_choice.hpp>
#include <delref/triangulation/constrained_delaunay_2.hpp>

/// Refines every face larger than `area`.
template <class Tr>
class AreaLevel {
 public:
  using Element = typename Tr::Face;
  explicit AreaLevel(double area) : area_(area) {}

  void assign_slot(std::size_t k) { set_.assign_slot(k); }
  void scan_triangulation(Tr& tr) {
    set_.clear();
    for (const Element f : tr.domain_faces())
      if (shape(tr, f).doubled_area > 2 * area_) set_.add(tr, f, 0);
  }
  bool empty() const { return set_.empty(); }
  Element next_element() { return set_.front(); }
  void pop_next_element(Tr& tr) { set_.pop(tr); }
  delref::Point2 refinement_point(const Tr& tr, const Element& f) const { return delref::Circumcentre{}.point(shape(tr, f)); }
  delref::Verdict check_refinement_point(Tr&, const delref::Proposal<Tr>&) const { return delref::Verdict::permitted; }
  void before_insertion(Tr& tr, const delref::Proposal<Tr>& proposal) {
    for (const Element f : proposal.zone->dying_faces()) set_.erase(tr, f);
  }
  // void after_insertion(Tr& tr, typename Tr::Vertex v, const delref::Proposal<Tr>& proposal) { ... }

 private:
  static delref::TriangleShape shape(const Tr& tr, const Element& f) {
    return {tr.point(tr.vertex(f, 0)), tr.point(tr.vertex(f, 1)), tr.point(tr.vertex(f, 2))};
  }
  double area_;
  delref::ElementSet<Element, delref::FifoQueue<Element>> set_;
};

using Tr = delref::ConstrainedDelaunay2<>;

// Ask beside the level; `delref::Mesher` asks the same of each of its levels.
static_assert(delref::explain_level<AreaLevel<Tr>, Tr>());

int main() {}
