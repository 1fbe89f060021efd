// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's Delaunay triangulation of space as delref's levels see it: each cell knows its region, which of its faces and edges lie on
// input facets and segments, and a slot per level; each vertex its carrier, its provenance and a number. Refinement points are
// inserted by the star of their conflict zone, found once (Bowyer 1981, Watson 1981). Cospherical points are told apart by
// CGAL's symbolic perturbation, which makes no flat cell (Devillers and Teillaud 2003).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <delref/core/carrier.hpp>
#include <delref/core/point.hpp>
#include <delref/core/proposal.hpp>
#include <delref/triangulation/detail/range_of.hpp>
#include <delref/triangulation/detail/spatial_filters.hpp>
#include <delref/triangulation/detail/spatial_records.hpp>

namespace delref {

/// A Delaunay triangulation with `CellSlots` slots per cell and `FacetSlots` per face; models `SpatialTriangulation`.
///
/// Cells outside the domain have a negative region; which they are is decided by `domain/label_polyhedral_domain.hpp`. Handles
/// stay valid until their element dies. Copying is not offered.
template <int CellSlots = 1, int FacetSlots = 0>
class Delaunay3 {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = detail::SpatialVertexRecord<Kernel>;
  using CellBase = detail::SpatialCellRecord<Kernel, CellSlots, FacetSlots>;

 public:
  /// The triangulation that does the work, for those who include CGAL.
  using Cgal = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
  using CgalVertex = typename Cgal::Vertex_handle;
  using CgalCell = typename Cgal::Cell_handle;

  using Point = Point3;
  static constexpr int dimension = 3;

  /// A vertex. Default: none.
  struct Vertex {
    CgalVertex handle{};
    friend bool operator==(const Vertex& a, const Vertex& b) { return a.handle == b.handle; }
  };
  /// A tetrahedron. Default: none.
  struct Cell {
    CgalCell handle{};
    friend bool operator==(const Cell& a, const Cell& b) { return a.handle == b.handle; }
  };
  /// The face of `cell` that is opposite to its vertex `index`.
  struct Facet {
    CgalCell cell{};
    int index = 0;
    friend bool operator==(const Facet& a, const Facet& b) { return a.cell == b.cell && a.index == b.index; }
  };
  /// The edge between two vertices, present or not.
  struct Edge {
    Vertex a, b;
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  /// Where the search for a point starts.
  struct Hint {
    CgalCell cell{};
    Hint() = default;
    Hint(const Cell& c) : cell(c.handle) {}
    Hint(const Facet& f) : cell(f.cell) {}
    Hint(const Vertex& v) : cell(v.handle->cell()) {}
  };

  /// The conflict zone of a point. Reused from one point to the next, so that it costs no allocation.
  class Zone {
   public:
    /// Before insertion: the cells that die.
    std::span<const Cell> dying_cells() const { return dying_; }
    /// Before insertion: the faces around the zone, named from the cells outside it, which survive.
    std::span<const Facet> boundary_facets() const { return boundary_; }
    /// The vertices that this insertion removes: none.
    std::span<const Vertex> vanishing() const { return {}; }
    /// After insertion: the cells that are new.
    std::span<const Cell> new_cells() const { return new_; }

   private:
    friend class Delaunay3;
    struct Wall;
    struct Link;
    std::vector<Cell> dying_, behind_, new_;
    std::vector<Facet> boundary_;
    std::vector<Wall> walls_;
    std::vector<Link> links_;
    std::vector<std::int32_t> first_link_;
    std::vector<CgalVertex> corners_;
  };

  template <class Element>
  static constexpr std::size_t slot_count = std::is_same_v<Element, Cell>    ? std::size_t{CellSlots}
                                               : std::is_same_v<Element, Facet> ? std::size_t{FacetSlots}
                                                                                : std::size_t{0};

  Delaunay3() = default;
  Delaunay3(const Delaunay3&) = delete;
  Delaunay3& operator=(const Delaunay3&) = delete;

  Cgal& cgal() { return cgal_; }
  const Cgal& cgal() const { return cgal_; }

  // -- vertices
  Point3 point(Vertex v) const { return bare(v.handle->point()); }
  std::size_t index(Vertex v) const { return v.handle->index; }
  Carrier carrier(Vertex v) const { return v.handle->carrier; }
  LevelIndex provenance(Vertex v) const { return v.handle->provenance; }
  void set_origin(Vertex v, Carrier carrier, LevelIndex provenance) {
    v.handle->carrier = carrier;
    v.handle->provenance = provenance;
  }
  std::size_t number_of_vertices() const { return cgal_.number_of_vertices(); }
  bool is_infinite(Vertex v) const { return cgal_.is_infinite(v.handle); }

  // -- cells, faces and edges
  Vertex vertex(Cell c, int i) const { return {c.handle->vertex(i)}; }
  std::array<Vertex, 4> vertices(Cell c) const { return {vertex(c, 0), vertex(c, 1), vertex(c, 2), vertex(c, 3)}; }
  /// Counterclockwise when seen from inside the facet's cell.
  std::array<Vertex, 3> vertices(Facet f) const {
    return {Vertex{f.cell->vertex(Cgal::vertex_triple_index(f.index, 0))}, Vertex{f.cell->vertex(Cgal::vertex_triple_index(f.index, 1))},
            Vertex{f.cell->vertex(Cgal::vertex_triple_index(f.index, 2))}};
  }
  std::array<Vertex, 2> vertices(Edge e) const { return {e.a, e.b}; }
  Facet facet(Cell c, int i) const { return {c.handle, i}; }
  Cell cell(Facet f) const { return {f.cell}; }
  /// The vertex of the facet's cell that is not on the facet.
  /// Its index in the other vertex order is the same: `facet(c, index(c, v))` is opposite to `v`.
  int index(Cell c, Vertex v) const { return c.handle->index(v.handle); }
  Cell neighbour(Cell c, int i) const { return {c.handle->neighbor(i)}; }
  Vertex apex(Facet f) const { return {f.cell->vertex(f.index)}; }
  Facet mirror(Facet f) const {
    const CgalCell n = f.cell->neighbor(f.index);
    return {n, n->index(f.cell)};
  }
  bool is_infinite(Cell c) const { return cgal_.is_infinite(c.handle); }
  bool is_simplex(std::span<const Vertex> v) const;
  /// The facet with three vertices, if it is there. Looks at the star of the first.
  std::optional<Facet> find_facet(Vertex a, Vertex b, Vertex c) const {
    CgalCell cell;
    int i = 0, j = 0, k = 0;
    if (!cgal_.is_facet(a.handle, b.handle, c.handle, cell, i, j, k)) return std::nullopt;
    return Facet{cell, 6 - i - j - k};
  }
  /// All cells that have both vertices; none when there is no such edge. Looks at the star of the first.
  void cells_around(Vertex a, Vertex b, std::vector<Cell>& cells) const {
    cells.clear();
    star_.clear();
    cgal_.incident_cells(a.handle, std::back_inserter(star_));
    for (const CgalCell c : star_)
      if (c->has_vertex(b.handle)) cells.push_back({c});
  }
  Point3 barycentre(std::span<const Vertex> vertices) const {
    Point3 sum;
    const double w = 1.0 / static_cast<double>(vertices.size());
    for (const Vertex v : vertices) sum = sum + w * (point(v) - Point3{});
    return sum;
  }

  /// The finite cells, the cells of the domain, all cells, and the finite vertices, in the order of storage.
  auto finite_cells() const {
    return detail::range_of<Cell>(cgal_.finite_cells_begin(), cgal_.finite_cells_end(), [](const auto&) { return true; });
  }
  auto domain_cells() const {
    return detail::range_of<Cell>(cgal_.finite_cells_begin(), cgal_.finite_cells_end(),
                                  [](const auto& c) { return c->region() >= 0; });
  }
  auto all_cells() const {
    return detail::range_of<Cell>(cgal_.all_cells_begin(), cgal_.all_cells_end(), [](const auto&) { return true; });
  }
  Cell infinite_cell() const { return {cgal_.infinite_cell()}; }
  /// The finite cell that contains a point, on its boundary or inside.
  std::optional<Cell> locate(Point3 p) const { return locate(p, Hint(infinite_cell())); }
  std::optional<Cell> locate(Point3 p, const Hint& hint) const {
    CgalCell found;
    if (walk(CgalPoint(p.x, p.y, p.z), hint.cell, found).kind == Where::Kind::outside) return std::nullopt;
    return Cell{found};
  }
  auto finite_vertices() const {
    return detail::range_of<Vertex>(cgal_.finite_vertices_begin(), cgal_.finite_vertices_end(), [](const auto&) { return true; });
  }

  // -- constraints and regions
  bool has_marked_facets(Cell c) const { return c.handle->has_marked_faces(); }
  bool has_marked_edges(Cell c) const { return c.handle->has_marked_edges(); }
  /// Whether the facet lies on an input facet.
  bool is_marked(Facet f) const { return f.cell->is_face_marked(f.index); }
  /// Marks a facet on both of its sides.
  void mark(Facet f, bool on) {
    const Facet m = mirror(f);
    f.cell->mark_face(f.index, on);
    m.cell->mark_face(m.index, on);
  }
  /// Whether an edge of the cell lies on an input segment. Every cell around an edge has the mark of its own.
  bool is_edge_marked(Cell c, int i, int j) const { return c.handle->is_edge_marked(i, j); }
  void mark_edge(Cell c, int i, int j, bool on) { c.handle->mark_edge(i, j, on); }
  bool in_domain(Cell c) const { return c.handle->region() >= 0; }
  int region(Cell c) const { return c.handle->region(); }
  void set_region(Cell c, int region) { c.handle->set_region(region); }

  // -- slots
  QueuePosition slot(Cell c, std::size_t k) const { return c.handle->slots[k]; }
  void set_slot(Cell c, std::size_t k, QueuePosition position) { c.handle->slots[k] = position; }
  /// A face has the same slots seen from both of its cells, and keeps them while it is there.
  QueuePosition slot(Facet f, std::size_t k) const { return f.cell->facet_slot(f.index, k); }
  void set_slot(Facet f, std::size_t k, QueuePosition position) {
    const Facet m = mirror(f);
    f.cell->set_facet_slot(f.index, k, position);
    m.cell->set_facet_slot(m.index, k, position);
  }
  /// Forgets the zone of the mesher before this one too, should it not have been inserted.
  void clear_slots() {
    for (auto c = cgal_.all_cells_begin(); c != cgal_.all_cells_end(); ++c) {
      c->clear_slots();
      c->set_dying(false);
    }
  }

  // -- insertion
  bool dies(Cell c, const Zone&) const { return c.handle->dying(); }
  /// Whether both cells of the facet die, and so the facet.
  bool dies(Facet f, const Zone&) const { return f.cell->dying() && f.cell->neighbor(f.index)->dying(); }
  /// Finds the cells whose circumsphere contains `p`. The search starts in the hint when that is one of them, and walks to `p` else.
  /// A point outside the hull has a zone too: rounding puts points of hull facets there.
  Location<Delaunay3> conflict_zone(Point3 p, const Hint& hint, Zone& zone) { return conflict_zone(p, hint, zone, false); }
  /// The same for a point that must not destroy a marked face: where it would, only a part of the zone may be found, which must not be
  /// inserted into. Of the cells behind marked faces it has the first few hundred, so that the faces in the way are known to die:
  /// behind them a zone can be as large as the triangulation.
  Location<Delaunay3> conflict_zone_up_to_marks(Point3 p, const Hint& hint, Zone& zone) { return conflict_zone(p, hint, zone, true); }
  /// Inserts `p` into its zone, which then lists the new cells. Marks stay on the faces and edges around the zone; a new cell has
  /// the region of the dying cell at its face there.
  Vertex insert(Point3 p, Zone& zone);
  /// Vertices inserted through `cgal()` were numbered by the caller: the next one gets `next`.
  void number_from(std::size_t next) { next_index_ = static_cast<std::uint32_t>(next); }

 private:
  using Where = Location<Delaunay3>;
  static constexpr std::size_t enough_behind_marks = 256;
  using CgalPoint = typename Kernel::Point_3;

  bool in_conflict(CgalCell c, const CgalPoint& p) const {
    const CgalVertex infinite = cgal_.infinite_vertex();
    if (c->vertex(0) != infinite && c->vertex(1) != infinite && c->vertex(2) != infinite && c->vertex(3) != infinite) {
      const auto at = [&c](int i) { return bare(c->vertex(i)->point()); };
      const int side = detail::filtered_side_of_sphere(at(0), at(1), at(2), at(3), bare(p));
      if (side != 0) return side > 0;
    }
    return cgal_.side_of_sphere(c, p, true) == CGAL::ON_BOUNDED_SIDE;
  }
  static Point3 bare(const CgalPoint& p) { return {p.x(), p.y(), p.z()}; }
  void release(Zone& zone) {
    for (const Cell c : zone.dying_) c.handle->set_dying(false);
    for (const Cell c : zone.behind_) c.handle->set_dying(false);
    zone.dying_.clear(), zone.behind_.clear(), zone.new_.clear(), zone.boundary_.clear();
  }
  Where walk(const CgalPoint& p, CgalCell start, CgalCell& found) const;
  bool is_at(CgalVertex v, const CgalPoint& p) const { return v->point() == p && !cgal_.is_infinite(v); }
  bool has_corner_at(CgalCell c, const CgalPoint& p) const {
    return is_at(c->vertex(0), p) || is_at(c->vertex(1), p) || is_at(c->vertex(2), p) || is_at(c->vertex(3), p);
  }
  static void clear_surviving(Zone& zone) {
    for (const Facet f : zone.boundary_) f.cell->set_surviving(false);
  }
  Location<Delaunay3> conflict_zone(Point3 p, const Hint& hint, Zone& zone, bool up_to_marks);
  bool grow(const CgalPoint& p, CgalCell start, Zone& zone, bool up_to_marks);
  void build_walls(Zone& zone);
  void link(Zone& zone, std::size_t wall, int side);

  Cgal cgal_;
  std::uint32_t next_index_ = 0;
  mutable std::vector<CgalCell> star_;  // scratch
};

}  // namespace delref

#include <delref/triangulation/detail/delaunay_3_zone.hpp>
