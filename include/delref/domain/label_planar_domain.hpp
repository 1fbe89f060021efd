// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells what is the domain of a triangulated planar straight line graph: regions by their seeds, without the holes, and the
// sharp corners of its segments.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <range/v3/view/iota.hpp>
#include <range/v3/view/zip.hpp>

#include <delref/core/budget.hpp>
#include <delref/domain/describe.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/domain/planar_domain.hpp>
#include <delref/domain/pslg_check.hpp>

namespace delref {

/// Labels every face of a triangulation that holds all segments of a domain, and completes the domain's regions and segments from
/// nothing: what they were before does not matter. Use once: the constructor does the work.
///
/// `checked` is the domain's graph as it was given, for messages; `vertices` are its input vertices. Throws `InvalidInput` when a
/// seed lies on a segment, two seeds contradict each other, or there is no bounded region left; `Interrupted`.
template <class Tr>
class PlanarDomainLabeller {
  using Vertex = typename Tr::Vertex;
  using Face = typename Tr::Face;
  using Edge = typename Tr::Edge;
  using Cgal = typename Tr::Cgal;

 public:
  PlanarDomainLabeller(Tr& tr, PlanarDomain& domain, const CheckedPslg& checked, std::span<const Vertex> vertices, const Control& control)
      : tr_(tr), domain_(domain), checked_(checked), vertices_(vertices), control_(control) {
    for (PlanarDomain::Segment& s : domain_.segments) s.sharp = {}, s.reach = {}, s.bounds_domain = false;
    // Every face is of region 0 first; what infinity reaches, and then the holes, is taken out.
    for (auto f = tr_.cgal().all_faces_begin(); f != tr_.cgal().all_faces_end(); ++f) f->set_region(unlabelled);
    flood({tr_.cgal().infinite_face()}, outside);
    const bool bounded = !std::ranges::empty(tr_.domain_faces());
    if (!bounded) refuse_open_boundary();
    const auto& pslg = domain_.pslg;
    for (const auto& [h, seed, given] : ranges::views::zip(ranges::views::iota(pslg.first_index), pslg.holes, checked_.pslg.holes))
      if (const auto f = locate_seed(seed, fmt::format("hole seed {}", h), given)) flood(*f, outside);
    if (std::ranges::empty(tr_.domain_faces())) refuse_swallowed();
    label_regions();
    find_boundary_and_corners();
  }

  /// Things that are no errors and that a user may want to know.
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  static constexpr int outside = -1, unlabelled = 0;

  void flood(Face start, int region) {
    if (tr_.region(start) == region) return;
    const int old = tr_.region(start);
    tr_.set_region(start, region);
    std::vector<Face> stack{start};
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face n{f.handle->neighbor(i)};
        if (f.handle->segment(i) >= 0 || tr_.region(n) != old) continue;
        tr_.set_region(n, region);
        stack.push_back(n);
      }
    }
  }

  /// The face of the domain that holds a seed; nothing, and a note, when the seed is outside. Throws when it is on a segment.
  /// Messages give it as it is in the input.
  std::optional<Face> locate_seed(Point2 seed, const std::string& what, Point2 in_input) {
    typename Cgal::Locate_type type;
    int i = 0;
    const auto f = tr_.cgal().locate({seed.x, seed.y}, type, i);
    if (type == Cgal::VERTEX ? tr_.cgal().are_there_incident_constraints(f->vertex(i)) : type == Cgal::EDGE && f->segment(i) >= 0)
      throw InvalidInput({Defect{what + " at " + describe(in_input) + " lies on a segment: move it inside", {in_input}}});
    if (type == Cgal::OUTSIDE_CONVEX_HULL || type == Cgal::OUTSIDE_AFFINE_HULL || f->region() == outside) {
      notes_.push_back(what + " at " + describe(in_input) + " lies outside the domain or in a hole that another seed made: it has no effect");
      return std::nullopt;
    }
    return Face{f};
  }

  void label_regions() {
    const auto& pslg = domain_.pslg;
    domain_.regions.assign(1, Pslg::Region{});
    for (std::size_t r = 0; r < pslg.regions.size(); ++r) {
      const std::string what = fmt::format("region seed {}", r + pslg.first_index);
      domain_.regions.push_back(pslg.regions[r]);
      const Point2 seed = checked_.pslg.regions[r].seed;
      const auto f = locate_seed(pslg.regions[r].seed, what, seed);
      if (!f) continue;
      const int earlier = tr_.region(*f);
      if (earlier != unlabelled) {
        const auto& other = domain_.regions[static_cast<std::size_t>(earlier)];
        if (other.label != pslg.regions[r].label || other.max_area != pslg.regions[r].max_area)
          throw InvalidInput({Defect{fmt::format("{} at {} is in the same region as region seed {} at {}, with another label or area "
                                                 "bound: keep one of them, or separate them by segments",
                                                 what, describe(seed), static_cast<std::size_t>(earlier) - 1 + pslg.first_index,
                                                 describe(checked_.pslg.regions[static_cast<std::size_t>(earlier) - 1].seed)),
                                     {seed}}});
        continue;
      }
      flood(*f, static_cast<int>(domain_.regions.size() - 1));
    }
  }

  void find_boundary_and_corners() {
    std::vector<bool> has_effect(domain_.pslg.segments.size());
    for (const Edge e : tr_.subsegments()) {
      PlanarDomain::Segment& s = domain_.segments[tr_.segment(e)];
      has_effect[s.original] = true;
      if (!tr_.in_domain(tr_.face(tr_.mirror(e)))) s.bounds_domain = true;
    }
    tell_without_effect(has_effect);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (i % 4096 == 0) throw_if_stopped(control_);
      find_corners_at(vertices_[i]);
    }
  }

  void tell_without_effect(const std::vector<bool>& has_effect) {
    ExampleList examples;
    for (std::size_t s = 0; s < has_effect.size(); ++s)
      if (!has_effect[s]) examples.full() ? examples.add() : examples.add(checked_.names().placed_segment(s));
    if (examples.count() > 0)
      notes_.push_back(count_of(examples.count(), "segment has", "segments have") + " no effect, outside the domain or in a hole: " + examples.text());
  }

  /// Marks each two neighbouring segments at `v` that have the domain between them and meet under 60 degrees.
  void find_corners_at(Vertex v) {
    std::vector<Edge> spokes;  // counterclockwise, each named from the face that follows it
    auto around = tr_.cgal().incident_faces(v.handle);
    const auto first = around;
    do {
      const Edge e{around, Cgal::cw(around->index(v.handle))};
      if (tr_.is_constrained(e)) spokes.push_back(e);
    } while (++around != first);
    for (std::size_t k = 0; k < spokes.size() && spokes.size() > 1; ++k) {
      const Edge a = spokes[k], b = spokes[(k + 1) % spokes.size()];
      if (!tr_.in_domain(tr_.face(a))) continue;
      const Vector2 u = tr_.point(tr_.target(a)) - tr_.point(v), w = tr_.point(tr_.target(b)) - tr_.point(v);
      const double d = dot(u, w);
      if (cross(u, w) < 0 || d <= 0 || 4 * d * d <= (1 + 1e-12) * squared_length(u) * squared_length(w)) continue;
      const bool is_tiny = d >= PlanarDomain::tiny_angle_cosine * std::sqrt(squared_length(u) * squared_length(w));
      mark_sharp(a, v, is_tiny ? std::sqrt(squared_length(w)) : 0);
      mark_sharp(b, v, is_tiny ? std::sqrt(squared_length(u)) : 0);
    }
  }

  void mark_sharp(Edge e, Vertex corner, double reach) {
    PlanarDomain::Segment& s = domain_.segments[tr_.segment(e)];
    const std::size_t end = s.ends[0] == tr_.carrier(corner).index ? 0 : 1;
    s.sharp[end] = true;
    s.reach[end] = std::max(s.reach[end], reach);
  }

  // -- what there is nothing to mesh in
  [[noreturn]] void refuse_open_boundary() const {
    std::vector<std::size_t> degree(domain_.pslg.points.size());
    for (const auto& s : domain_.segments)
      for (const Pslg::Index end : s.ends) ++degree[end];
    std::string ends;
    std::vector<Point2> places;
    for (std::size_t i = 0; i < degree.size() && places.size() < 10; ++i) {
      if (degree[i] != 1) continue;
      places.push_back(checked_.pslg.points[i]);
      ends += (ends.empty() ? "" : ", ") + checked_.names().placed_vertex(i);
    }
    throw InvalidInput({Defect{"the segments bound no region: no closed chain of them separates an inside from the outside" +
                                   (ends.empty() ? std::string("; add the missing segments")
                                                 : "; open ends are " + ends + (places.size() == 10 ? " and more" : "") +
                                                       ": close the boundary there"),
                               places}});
  }
  [[noreturn]] void refuse_swallowed() const {
    std::string seeds;
    for (std::size_t h = 0; h < domain_.pslg.holes.size() && h < 10; ++h)
      seeds += fmt::format("{}seed {} at {}", h ? ", " : "", h + domain_.pslg.first_index, describe(checked_.pslg.holes[h]));
    throw InvalidInput({Defect{"the holes swallow the whole domain: " + seeds +
                                   "; a seed removes everything up to the next segments around it: move or remove it, or close "
                                   "the segments around the hole",
                               checked_.pslg.holes}});
  }

  Tr& tr_;
  PlanarDomain& domain_;
  const CheckedPslg& checked_;
  std::span<const Vertex> vertices_;
  const Control& control_;
  std::vector<std::string> notes_;
};

}  // namespace delref
