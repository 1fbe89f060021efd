// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the planar triangulation keeps in each vertex and face, in the form in which CGAL takes it: base classes that are rebound
// to the triangulation's own handles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <CGAL/Triangulation_ds_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>

#include <delref/core/carrier.hpp>
#include <delref/core/queue/refinement_queue.hpp>

namespace delref::detail {

template <class Kernel, class Base = CGAL::Triangulation_vertex_base_2<Kernel>>
struct PlanarVertexRecord : Base {
  using Base::Base;
  template <class Tds>
  struct Rebind_TDS {
    using Other = PlanarVertexRecord<Kernel, typename Base::template Rebind_TDS<Tds>::Other>;
  };
  Carrier carrier;
  std::uint32_t index = 0;
  LevelIndex provenance = input_level;
};

/// Models CGAL's ConstrainedTriangulationFaceBase_2. An edge is constrained when it has an input segment.
template <class Kernel, int EdgeSlots, int FaceSlots, class Base = CGAL::Triangulation_ds_face_base_2<>>
class PlanarFaceRecord : public Base {
 public:
  template <class Tds>
  struct Rebind_TDS {
    using Other = PlanarFaceRecord<Kernel, EdgeSlots, FaceSlots, typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using typename Base::Face_handle;
  using typename Base::Vertex_handle;
  /// The segment of a constraint that CGAL has just made and nobody has named yet.
  static constexpr std::int32_t unnamed = std::numeric_limits<std::int32_t>::max();

  PlanarFaceRecord() { forget(); }
  PlanarFaceRecord(Vertex_handle a, Vertex_handle b, Vertex_handle c) : Base(a, b, c) { forget(); }
  PlanarFaceRecord(Vertex_handle a, Vertex_handle b, Vertex_handle c, Face_handle x, Face_handle y, Face_handle z)
      : Base(a, b, c, x, y, z) {
    forget();
  }

  bool is_constrained(int i) const { return segment(i) >= 0; }
  void set_constraint(int i, bool constrained) {
    if (constrained != is_constrained(i)) set_segment(i, constrained ? unnamed : -1);
  }
  void set_constraints(bool a, bool b, bool c) { set_constraint(0, a), set_constraint(1, b), set_constraint(2, c); }
  void reorient() {
    Base::reorient();
    std::swap(segments_[0], segments_[1]);
  }
  void ccw_permute() {
    Base::ccw_permute();
    segments_ = {segments_[2], segments_[0], segments_[1]};
  }
  void cw_permute() {
    Base::cw_permute();
    segments_ = {segments_[1], segments_[2], segments_[0]};
  }

  std::int32_t segment(int i) const { return segments_[static_cast<std::size_t>(i)]; }
  void set_segment(int i, std::int32_t s) { segments_[static_cast<std::size_t>(i)] = s; }
  void clear_slots() {
    for (auto& s : edge_slots) s.fill(-1);
    face_slots.fill(-1);
  }
  void forget() {
    segments_.fill(-1);
    clear_slots();
    region_ = -1 * 2;
  }

  /// Of the domain if >= 0. Shares a word with the mark of the faces in the current conflict zone.
  int region() const { return region_ >> 1; }
  void set_region(int region) { region_ = region * 2 + (region_ & 1); }
  bool dying() const { return (region_ & 1) != 0; }
  void set_dying(bool dying) { region_ = (region_ & ~1) + (dying ? 1 : 0); }


 private:
  // First what the search for a zone reads, so that it is in one cache line with CGAL's handles.
  std::array<std::int32_t, 3> segments_;
  std::int32_t region_ = -1;

 public:
  std::array<std::array<QueuePosition, 3>, EdgeSlots> edge_slots;
  std::array<QueuePosition, FaceSlots> face_slots;
};

}  // namespace delref::detail
