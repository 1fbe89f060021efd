// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <delref/algorithms/smooth_refinement.hpp>
#include <delref/mesh/verify_smooth.hpp>

namespace delref::property_smooth {

std::string Meshed::unmet() const {
  std::map<std::string, std::size_t> times;
  for (const auto& u : outcome.unmet) ++times[u.criterion + ": " + std::string(to_string(u.reason))];
  std::string text;
  for (const auto& [what, count] : times) text += what + ", " + std::to_string(count) + " times\n";
  return text;
}
bool Meshed::lists(std::string_view criterion) const {
  return std::ranges::any_of(outcome.unmet, [&](const auto& u) { return u.criterion == criterion; });
}

Meshed meshed(const Domain& domain, const SmoothOptions& options, std::size_t max_vertices) {
  Budget budget;
  budget.max_vertices = max_vertices;
  SmoothRefinement<Domain> refinement(domain, options);
  Meshed result;
  const Domain::Counts before = domain.counts();
  result.outcome = refinement.refine(Control(budget));
  const Domain::Counts after = domain.counts();
  result.asked = {after.labels - before.labels, after.crossings - before.crossings, after.evaluations - before.evaluations};
  result.options = refinement.options();
  result.mesh = refinement.mesh();
  result.patches = refinement.patches().size();
  result.components = refinement.components().found;
  result.missed_components = refinement.components().missed;
  result.loose_vertices = refinement.components().loose_vertices;
  result.vertices = refinement.triangulation().number_of_vertices();
  return result;
}

std::string broken_promises(const Domain& domain, const Meshed& result) {
  SmoothExpectations expected;
  expected.complete = result.outcome.complete();
  expected.listed = result.outcome.unmet;
  expected.missed_components = result.missed_components;
  std::string text;
  for (const Finding& f : verify_smooth(domain, result.mesh, result.options, expected).findings)
    if (f.status == CheckStatus::failed)
      text += f.name + ": " + std::to_string(f.failures) + " of " + std::to_string(f.examined) + " are not: " +
              (f.places.empty() ? "" : f.places.front()) + "\n";
  return text;
}

bool same_bytes(const TetrahedralMesh& a, const TetrahedralMesh& b) {
  return a.points == b.points && a.point_markers == b.point_markers && a.carriers == b.carriers && a.provenance == b.provenance &&
         a.tetrahedra == b.tetrahedra && a.regions == b.regions && a.triangles == b.triangles && a.triangle_markers == b.triangle_markers &&
         a.triangle_facets == b.triangle_facets;
}

namespace {

using Index = TetrahedralMesh::Index;

/// Looks at one mesh. Coordinates are taken from the first vertex on, so that domains far from the origin lose nothing.
class Examination {
 public:
  explicit Examination(const Meshed& result) : r_(result), mesh_(result.mesh) {
    for (const auto& u : r_.outcome.unmet) listed_.insert(key(u.place));
  }
  std::string run() {
    if (mesh_.triangles.empty()) return "no triangles\n";
    look_at_edges();
    look_at_vertices();
    look_at_angles();
    if (!mesh_.tetrahedra.empty()) {
      look_at_tetrahedra();
      look_at_volumes();
    }
    return text_;
  }

 private:
  using Key = std::array<double, 3>;
  static Key key(Point3 p) { return {p.x, p.y, p.z}; }
  Vector3 at(Index v) const { return mesh_.points[v] - mesh_.points[0]; }
  void complain(const char* what, std::size_t failures, std::size_t of, double worst = 0) {
    if (failures != 0) text_ += fmt::format("{}: {} of {}, worst {}\n", what, failures, of, worst);
  }
  /// The outcome lists the element with these corners.
  template <std::size_t N>
  bool is_listed(const std::array<Index, N>& corners) const {
    Vector3 sum{};
    double longest = 0;
    for (const Index v : corners) sum = sum + (1.0 / N) * (mesh_.points[v] - Point3{}), longest = std::max(longest, squared_length(at(v) - at(corners[0])));
    const Point3 place = Point3{} + sum;
    const double tolerance = 1e-6 * std::sqrt(longest) + 8 * rounding_near(place);
    for (auto i = listed_.lower_bound({place.x - tolerance, -infinity, -infinity}); i != listed_.end() && (*i)[0] <= place.x + tolerance; ++i)
      if (std::abs((*i)[1] - place.y) <= tolerance && std::abs((*i)[2] - place.z) <= tolerance) return true;
    return false;
  }

  void look_at_edges() {
    std::map<std::array<Index, 2>, std::array<int, 2>> edges;  // triangles, and those that have it in this direction less the others
    for (const auto& t : mesh_.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index a = t[i], b = t[(i + 1) % 3];
        auto& e = edges[{std::min(a, b), std::max(a, b)}];
        ++e[0], e[1] += a < b ? 1 : -1;
      }
    std::size_t odd = 0, crowded = 0, turned = 0;
    for (const auto& [ends, e] : edges) {
      if (r_.patches == 1) odd += e[0] % 2 != 0, turned += e[1] != 0;
      else odd += e[0] < 2;
      crowded += e[0] > 2;
    }
    complain("edges at which the surface is not closed", odd, edges.size());
    complain("edges whose triangles disagree about the inside", turned, edges.size());
    if (r_.patches == 1 && is_done() && r_.options.manifold && r_.outcome.unmet.empty())
      complain("edges with more than two triangles", crowded, edges.size());
  }

  /// The triangles at a vertex, where only two regions meet, have to be one closed umbrella.
  void look_at_vertices() {
    if (r_.patches != 1 || !is_done() || !r_.options.manifold) return;
    std::map<Index, std::vector<std::size_t>> stars;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const Index v : mesh_.triangles[t]) stars[v].push_back(t);
    std::size_t bad = 0;
    for (const auto& [v, star] : stars) {
      std::map<Index, Index> next;
      bool is_disk = true;
      for (const std::size_t t : star) {
        const auto& c = mesh_.triangles[t];
        const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
        is_disk = next.emplace(c[(k + 1) % 3], c[(k + 2) % 3]).second && is_disk;
      }
      std::size_t steps = 0;
      for (Index at = next.begin()->first; is_disk && steps <= star.size(); ++steps) {
        const auto found = next.find(at);
        is_disk = found != next.end();
        if (is_disk) at = found->second;
        if (at == next.begin()->first) {
          ++steps;
          break;
        }
      }
      if (is_disk && steps == star.size()) continue;
      if (!std::ranges::all_of(star, [&](std::size_t t) { return is_listed(mesh_.triangles[t]); })) ++bad;
    }
    complain("vertices whose triangles are no disk", bad, stars.size());
  }

  void look_at_angles() {
    if (!is_done()) return;
    const double least = std::asin(std::sqrt(r_.options.facet_angle.squared_sine())) * (1 - 1e-9);
    std::size_t bad = 0;
    double worst = 10;
    for (const auto& t : mesh_.triangles) {
      double smallest = 10;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 u = at(t[(i + 1) % 3]) - at(t[i]), v = at(t[(i + 2) % 3]) - at(t[i]);
        smallest = std::min(smallest, std::atan2(std::sqrt(squared_length(cross(u, v))), dot(u, v)));
      }
      if (smallest >= least || is_listed(t)) continue;
      ++bad, worst = std::min(worst, smallest);
    }
    complain("angles under the bound", bad, mesh_.triangles.size(), worst);
  }

  void look_at_tetrahedra() {
    std::size_t inverted = 0, bad = 0;
    double worst = 0;
    for (const auto& t : mesh_.tetrahedra) {
      const Vector3 u = at(t[1]) - at(t[0]), v = at(t[2]) - at(t[0]), w = at(t[3]) - at(t[0]);
      const double volume = dot(u, cross(v, w)), longest = std::max({squared_length(u), squared_length(v), squared_length(w)});
      const bool is_noise = std::abs(volume) <= 1e-11 * longest * std::sqrt(longest);
      if (volume < 0 && !is_noise) ++inverted;
      const double radius = std::sqrt(squared_length(squared_length(u) * cross(v, w) + squared_length(v) * cross(w, u) + squared_length(w) * cross(u, v))) / (2 * volume);
      double shortest = std::min({squared_length(u), squared_length(v), squared_length(w), squared_length(u - v), squared_length(u - w), squared_length(v - w)});
      const double ratio = radius / std::sqrt(shortest);
      if (!is_done() || is_listed(t) || (!is_noise && ratio <= r_.options.radius_edge * (1 + 1e-7))) continue;
      ++bad, worst = std::max(worst, ratio);
    }
    complain("inverted tetrahedra", inverted, mesh_.tetrahedra.size());
    complain("radius-edge ratios over the bound", bad, mesh_.tetrahedra.size(), worst);
  }

  /// With one patch the tetrahedra have to fill what the triangles, which look outwards, enclose.
  void look_at_volumes() {
    double of_tetrahedra = 0, of_triangles = 0;
    for (const auto& t : mesh_.tetrahedra) of_tetrahedra += dot(at(t[1]) - at(t[0]), cross(at(t[2]) - at(t[0]), at(t[3]) - at(t[0])));
    if (r_.patches != 1) return;
    for (const auto& t : mesh_.triangles) of_triangles += dot(at(t[0]), cross(at(t[1]), at(t[2])));
    if (std::abs(of_tetrahedra - of_triangles) > 1e-9 * of_tetrahedra)
      text_ += fmt::format("the tetrahedra have a volume of {}, the triangles enclose {}\n", of_tetrahedra / 6, of_triangles / 6);
  }
  bool is_done() const { return r_.outcome.complete(); }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const Meshed& r_;
  const TetrahedralMesh& mesh_;
  std::set<Key> listed_;
  std::string text_;
};

}  // namespace

std::string defects(const Meshed& result) { return Examination(result).run(); }

}  // namespace delref::property_smooth
