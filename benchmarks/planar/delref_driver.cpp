// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times delref's refinement of one planar input, apart from reading, checking and building: a line of figures that
// benchmarks/planar/run.py reads. Usage: delref_driver IN.poly ANGLE AREA circle|lens off-centre|circumcentre bucket|lifo|fifo
#include <chrono>
#include <cstdlib>
#include <exception>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>

#include <delref/algorithms/planar.hpp>
#include <delref/core/queue/fifo_queue.hpp>
#include <delref/core/queue/lifo_queue.hpp>
#include <delref/io/triangle_poly.hpp>

namespace {

using Tr = delref::ConstrainedDelaunay2<>;

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

template <template <class> class Queue, class Encroachment, class Points>
void run(const char* path, delref::AngleBound angle, double area, Encroachment encroachment, Points points) {
  using namespace delref;
  const Control control;
  const CheckedPslg checked = check_pslg(read_triangle_poly(path), {}, control);
  Tr tr;
  PlanarDomainBuilder builder(tr, checked, control);
  const PlanarDomain domain = std::move(builder).domain();
  const TriangleCriteria criteria(MinimumAngle{angle}, MaximumArea{area}, MaximumRegionArea(domain.regions));
  using Criteria = std::remove_cv_t<decltype(criteria)>;
  Mesher mesher(tr, EdgesLevel2<Tr, Encroachment>(domain, encroachment),
                FacesLevel2<Tr, Criteria, Points, Queue<typename Tr::Face>>(domain, criteria, points));
  const double before = peak_megabytes();
  const auto start = std::chrono::steady_clock::now();
  const Outcome<Point2> outcome = mesher.refine(control);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::size_t triangles = 0;
  for ([[maybe_unused]] const auto f : tr.domain_faces()) ++triangles;
  fmt::print("seconds {:.6f} vertices_made {} triangles {} megabytes {:.1f} complete {}\n", seconds,
             outcome.levels[0].inserted + outcome.levels[1].inserted, triangles, peak_megabytes() - before, outcome.complete());
}

template <template <class> class Queue>
void choose(char** a) {
  using namespace delref;
  const AngleBound angle = AngleBound::degrees(std::atof(a[2]));
  const double area = std::atof(a[3]) > 0 ? std::atof(a[3]) : std::numeric_limits<double>::infinity();
  const bool lens = std::string_view(a[4]) == "lens", off_centre = std::string_view(a[5]) == "off-centre";
  if (lens && off_centre) run<Queue>(a[1], angle, area, DiametralLens{angle}, OffCentre(angle));
  else if (lens) run<Queue>(a[1], angle, area, DiametralLens{angle}, Circumcentre{});
  else if (off_centre) run<Queue>(a[1], angle, area, DiametralCircle{}, OffCentre(angle));
  else run<Queue>(a[1], angle, area, DiametralCircle{}, Circumcentre{});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  try {
    const std::string_view queue = argv[6];
    if (queue == "lifo") choose<delref::LifoQueue>(argv);
    else if (queue == "fifo") choose<delref::FifoQueue>(argv);
    else choose<delref::BucketQueue>(argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "delref_driver: {}\n", e.what());
    return 1;
  }
}
