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

  bool is_constrained(int i) const { return (state_ & (2 << i)) != 0; }
  /// Whether any edge is.
  bool is_constrained() const { return (state_ & 14) != 0; }
  void set_constraint(int i, bool constrained) {
    if (constrained != is_constrained(i)) set_segment(i, constrained ? unnamed : -1);
  }
  void set_constraints(bool a, bool b, bool c) { set_constraint(0, a), set_constraint(1, b), set_constraint(2, c); }
  void reorient() {
    Base::reorient();
    set_segments({segments_[1], segments_[0], segments_[2]});
  }
  void ccw_permute() {
    Base::ccw_permute();
    set_segments({segments_[2], segments_[0], segments_[1]});
  }
  void cw_permute() {
    Base::cw_permute();
    set_segments({segments_[1], segments_[2], segments_[0]});
  }

  std::int32_t segment(int i) const { return segments_[static_cast<std::size_t>(i)]; }
  void set_segment(int i, std::int32_t s) {
    segments_[static_cast<std::size_t>(i)] = s;
    state_ = s >= 0 ? state_ | (2 << i) : state_ & ~(2 << i);
  }
  void clear_slots() {
    for (auto& s : edge_slots) s.fill(-1);
    face_slots.fill(-1);
  }
  void forget() {
    segments_.fill(-1);
    clear_slots();
    state_ = state_of(-1);
  }
  /// The same for a face that has no constraints but perhaps one on edge 0.
  void renew(int region, std::int32_t segment) {
    segments_ = {segment, -1, -1};
    clear_slots();
    state_ = state_of(region) + (segment >= 0 ? 2 : 0);
  }

  /// Of the domain if >= 0. Shares a word with the mark of the faces in the current conflict zone and those of constrained edges.
  int region() const { return state_ >> 4; }
  void set_region(int region) { state_ = state_of(region) + (state_ & 15); }
  bool dying() const { return (state_ & 1) != 0; }
  void set_dying(bool dying) { state_ = (state_ & ~1) + (dying ? 1 : 0); }

 private:
  void set_segments(const std::array<std::int32_t, 3>& s) {
    for (int i = 0; i < 3; ++i) set_segment(i, s[static_cast<std::size_t>(i)]);
  }
  static constexpr int state_of(int region) { return region * 16; }
  // First what the search for a zone reads, so that it is in one cache line with CGAL's handles.
  std::int32_t state_ = 0;
  std::array<std::int32_t, 3> segments_;

 public:
  std::array<std::array<QueuePosition, 3>, EdgeSlots> edge_slots;
  std::array<QueuePosition, FaceSlots> face_slots;
};

/// Has the processor fetch the record of a face into its cache, while it does other work.
template <class FaceHandle>
void fetch_record(const FaceHandle& f) {
  const char* record = static_cast<const char*>(static_cast<const void*>(&*f));
  __builtin_prefetch(record);
  __builtin_prefetch(record + 64);  // it may straddle a cache line
}
/// The same for what the record refers to: neighbours and points.
template <class FaceHandle>
void fetch_around(const FaceHandle& f) {
  for (int i = 0; i < 3; ++i) {
    fetch_record(f->neighbor(i));
    __builtin_prefetch(&f->vertex(i)->point());
  }
}

}  // namespace delref::detail
