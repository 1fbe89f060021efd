// SPDX-License-Identifier: MIT
//
// Shows how to stop a run (by a budget, step by step, from another thread), look at the mesh between, and go on;
// and how to add to it.
#include <cstdio>
#include <stop_token>
#include <string>

#include <delref/algorithms/planar.hpp>
#include <delref/io/planar_formats.hpp>

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "examples/data/greece.poly";
  const delref::Pslg coast = delref::read_pslg(path).pslg;

  // `mesh_planar` as an object. Nothing is refined until it is told to.
  delref::PlanarRefinement refinement(coast);

  // One step at a time: each takes one element, and says what it did with it.
  for (std::size_t inserted = 0; inserted < 100;)
    if (refinement.step() == delref::Step::inserted) ++inserted;

  // Between steps there is always a mesh: valid, and not yet as good as asked.
  std::printf("after 100 insertions: %zu triangles\n", refinement.mesh().triangles.size());

  // A budget: no more than so many vertices in all.
  delref::Budget budget;
  budget.max_vertices = 8000;
  const auto first = refinement.refine(delref::Control(budget));
  std::printf("with a budget:        %zu triangles, %zu elements wait\n", refinement.mesh().triangles.size(),
              first.unmet_count(delref::Reason::budget));

  // A stop token: what the button of a window or a signal handler's thread asks for. Here it is asked before the run begins.
  std::stop_source cancel;
  cancel.request_stop();
  const auto second = refinement.refine(delref::Control({}, cancel.get_token()));
  std::printf("cancelled:            %zu triangles\n", refinement.mesh().triangles.size());

  // Nothing was lost: the queues are as they were. Go on to the end.
  const auto last = refinement.refine();
  const delref::PlanarMesh mesh = refinement.mesh();
  std::printf("to the end:           %zu triangles, %s\n", mesh.triangles.size(), refinement.done() ? "done" : "not done");

  // The same mesh as in one go.
  const delref::PlanarMesh at_once = delref::mesh_planar(coast, {}).mesh;
  std::printf("in one go:            %zu triangles\n", at_once.triangles.size());

  // Vertices and segments may be added to what is refined already, here a road. Then it is refined again.
  delref::Pslg road;
  road.points = {{17.09, 39.55}, {17.60, 39.64}};
  road.segments = {{0, 1}};
  refinement.add(road);
  const auto added = refinement.refine();
  std::printf("with a road:          %zu triangles\n", refinement.mesh().triangles.size());
  const bool grown = added.complete() && refinement.mesh().triangles.size() > mesh.triangles.size();

  const bool stopped = first.stopped == delref::Stop::vertices && second.stopped == delref::Stop::token && last.complete();
  return stopped && grown && mesh.points == at_once.points && mesh.triangles == at_once.triangles ? 0 : 1;
}
