// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the triangulation of space keeps in each vertex and cell, in the form in which CGAL takes it: base classes that are rebound
// to the triangulation's own handles. A cell is 80 bytes with one slot of its own and none of its faces; 16 bytes more with a slot of each face.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <CGAL/Triangulation_ds_cell_base_3.h>
#include <CGAL/Triangulation_ds_vertex_base_3.h>

#include <delref/core/carrier.hpp>
#include <delref/core/queue/refinement_queue.hpp>

namespace delref::detail {

template <class Kernel, class Base = CGAL::Triangulation_ds_vertex_base_3<>>
class SpatialVertexRecord : public Base {
 public:
  template <class Tds>
  struct Rebind_TDS {
    using Other = SpatialVertexRecord<Kernel, typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using Point = typename Kernel::Point_3;
  using typename Base::Cell_handle;

  SpatialVertexRecord() = default;
  explicit SpatialVertexRecord(const Point& p) : point_(p) {}
  SpatialVertexRecord(const Point& p, Cell_handle c) : Base(c), point_(p) {}
  explicit SpatialVertexRecord(Cell_handle c) : Base(c) {}

  const Point& point() const { return point_; }
  Point& point() { return point_; }
  void set_point(const Point& p) { point_ = p; }

 private:
  Point point_;

 public:
  Carrier carrier;
  std::uint32_t index = 0;
  /// Its number in the hole that is being filled; for the triangulation's use within one insertion.
  std::int32_t number_in_hole = -1;
  LevelIndex provenance = input_level;
};

/// The slots of the four faces of a cell; nothing at all where no level wants any.
template <int FacetSlots>
struct FacetSlotArray {
  std::array<QueuePosition, std::size_t{4} * FacetSlots> positions;
  QueuePosition at(int face, std::size_t k) const { return positions[4 * k + static_cast<std::size_t>(face)]; }
  QueuePosition& at(int face, std::size_t k) { return positions[4 * k + static_cast<std::size_t>(face)]; }
  void clear() { positions.fill(-1); }
};
template <>
struct FacetSlotArray<0> {
  static QueuePosition at(int, std::size_t) { return -1; }
  static void clear() {}
};

/// Faces and edges of a cell are marked as those that lie on input facets and segments: bits of one word.
template <class Kernel, int CellSlots, int FacetSlots = 0, class Base = CGAL::Triangulation_ds_cell_base_3<>>
class SpatialCellRecord : public Base {
 public:
  template <class Tds>
  struct Rebind_TDS {
    using Other = SpatialCellRecord<Kernel, CellSlots, FacetSlots, typename Base::template Rebind_TDS<Tds>::Other>;
  };
  using typename Base::Cell_handle;
  using typename Base::Vertex_handle;
  using Point = typename Kernel::Point_3;

  SpatialCellRecord() { forget(); }
  SpatialCellRecord(Vertex_handle a, Vertex_handle b, Vertex_handle c, Vertex_handle d) : Base(a, b, c, d) { forget(); }
  SpatialCellRecord(Vertex_handle a, Vertex_handle b, Vertex_handle c, Vertex_handle d, Cell_handle p, Cell_handle q,
                    Cell_handle r, Cell_handle s)
      : Base(a, b, c, d, p, q, r, s) {
    forget();
  }

  /// The number, 0 to 5, of the edge between two vertices of a cell.
  static int edge_number(int i, int j) {
    constexpr int numbers[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
    return numbers[i][j];
  }

  bool is_face_marked(int i) const { return (marks_ >> i & 1u) != 0; }
  void mark_face(int i, bool on) { set(i, on); }
  bool is_edge_marked(int i, int j) const { return (marks_ >> (4 + edge_number(i, j)) & 1u) != 0; }
  void mark_edge(int i, int j, bool on) { set(4 + edge_number(i, j), on); }
  bool has_marked_faces() const { return (marks_ & 0xfu) != 0; }
  bool has_marked_edges() const { return (marks_ & 0x3f0u) != 0; }

  bool dying() const { return (marks_ >> 10 & 1u) != 0; }
  void set_dying(bool on) { set(10, on); }
  /// Next to the hole and not in it, as the search found.
  bool surviving() const { return (marks_ >> 11 & 1u) != 0; }
  void set_surviving(bool on) { set(11, on); }

  int region() const { return region_; }
  void set_region(int region) { region_ = region; }

  QueuePosition facet_slot(int i, std::size_t k) const { return facet_slots_.at(i, k); }
  void set_facet_slot(int i, std::size_t k, QueuePosition position) {
    if constexpr (FacetSlots > 0) facet_slots_.at(i, k) = position;
  }
  /// Face i is the same as face j of a neighbour, which keeps its slots.
  void share_facet_slots(int i, const SpatialCellRecord& neighbour, int j) {
    for (std::size_t k = 0; k < FacetSlots; ++k) set_facet_slot(i, k, neighbour.facet_slot(j, k));
  }

  void clear_slots() {
    slots.fill(-1);
    facet_slots_.clear();
  }
  void forget() {
    marks_ = 0;
    region_ = -1;
    clear_slots();
  }

 private:
  void set(int bit, bool on) {
    marks_ = static_cast<std::uint16_t>(on ? marks_ | (1u << bit) : marks_ & ~(1u << bit));
  }
  std::uint16_t marks_;
  std::int32_t region_;
  [[no_unique_address]] FacetSlotArray<FacetSlots> facet_slots_;

 public:
  std::array<QueuePosition, CellSlots> slots;
};

}  // namespace delref::detail
