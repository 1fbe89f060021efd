// SPDX-License-Identifier: MIT
//
// Shows how to watch a run: count, log, draw or animate it without touching the mesher.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include <delref/algorithms/planar.hpp>
#include <delref/io/planar_formats.hpp>

namespace {

/// Counts who inserts where. An observer has any of six members, and at least one; it may be templated on the triangulation, or not.
struct Journal {
  std::size_t on_segments = 0, inside = 0, rejected = 0, faces_rebuilt = 0, largest_zone = 0;

  template <class Tr>
  void on_before_insertion(const Tr&, const delref::Proposal<Tr>& proposal) {
    const std::size_t dying = proposal.zone->dying_faces().size();
    faces_rebuilt += dying;
    largest_zone = std::max(largest_zone, dying);
  }
  template <class Tr>
  void on_after_insertion(const Tr& tr, typename Tr::Vertex v, const delref::Proposal<Tr>&) {
    ++(tr.carrier(v).dimension == 1 ? on_segments : inside);
  }
  template <class Tr>
  void on_rejected(const Tr&, const delref::Proposal<Tr>&, delref::LevelIndex /*by*/) {
    ++rejected;
  }
};

/// Prints a line at every thousandth vertex.
struct Progress {
  template <class Tr>
  void on_after_insertion(const Tr& tr, typename Tr::Vertex, const delref::Proposal<Tr>&) {
    if (tr.number_of_vertices() % 1000 == 0) std::printf("... %zu vertices\n", tr.number_of_vertices());
  }
};

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "examples/data/greece.poly";
  const delref::Pslg coast = delref::read_pslg(path).pslg;

  // Observers come last in the call, as many as you like; they are yours, and called in this order. What none of them watches costs
  // nothing.
  Journal journal;
  Progress progress;
  const auto result = delref::mesh_planar(coast, delref::PlanarOptions{}, delref::Control{}, journal, progress);

  const std::size_t inserted = journal.on_segments + journal.inside;
  std::printf("%zu vertices on segments, %zu inside; %zu points rejected\n", journal.on_segments, journal.inside, journal.rejected);
  std::printf("%.1f faces die per insertion, at most %zu\n",
              static_cast<double>(journal.faces_rebuilt) / static_cast<double>(inserted), journal.largest_zone);

  // The same vertices are in the mesh: each knows the level that inserted it.
  const auto steiner = std::ranges::count_if(result.mesh.provenance, [](auto level) { return level != delref::input_level; });
  return static_cast<std::size_t>(steiner) == inserted ? 0 : 1;
}
