// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangles between the tetrahedra of a mesh, found by sorting them at their lowest vertex. A half-face is numbered 4 t + k
// and is the face of tetrahedron t opposite to its corner k.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <delref/core/budget.hpp>
#include <delref/mesh/verify_3/subject.hpp>

namespace delref::verification_3 {

class MeshTopology {
 public:
  struct Face {
    Index a, b, c;          ///< a < b < c
    Index positive = none;  ///< the half-face whose tetrahedron sees a, b, c counterclockwise
    Index negative = none;  ///< the half-face on the other side
    bool crowded = false;   ///< more than one tetrahedron on one side

    std::array<Index, 3> corners() const { return {a, b, c}; }
    bool boundary() const { return (positive == none) != (negative == none); }
    Index some() const { return positive != none ? positive : negative; }
  };

  /// Requires valid indices and positively oriented tetrahedra. Expected time linear for bounded degrees.
  MeshTopology(const TetrahedralMesh& mesh, const Control& control) : tetrahedra_(mesh.tetrahedra) {
    find_faces(mesh.points.size(), control);
  }

  std::span<const Face> faces() const { return faces_; }
  Index face_of(Index half_face) const { return face_of_[half_face]; }
  /// The corner that faces a half-face in its tetrahedron.
  Index apex(Index half_face) const { return tetrahedra_[half_face / 4][half_face % 4]; }
  /// The half-face on the other side, or none.
  Index twin(Index half_face) const {
    const Face& f = faces_[face_of_[half_face]];
    return f.positive == half_face ? f.negative : f.positive;
  }
  /// The face of three vertices, or none.
  Index find(std::array<Index, 3> v) const {
    std::ranges::sort(v);
    if (v[0] + 1 >= begin_.size()) return none;
    const auto star = std::span(faces_).subspan(begin_[v[0]], begin_[v[0] + 1] - begin_[v[0]]);
    const auto found =
        std::ranges::lower_bound(star, std::pair(v[1], v[2]), {}, [](const Face& f) { return std::pair(f.b, f.c); });
    if (found == star.end() || found->b != v[1] || found->c != v[2]) return none;
    return static_cast<Index>(begin_[v[0]] + static_cast<std::size_t>(found - star.begin()));
  }
  bool used(Index vertex) const { return used_[vertex]; }

 private:
  struct Record {
    Index low, middle, high, half_face;
    bool positive;
  };

  /// A face at the bucket of its lowest vertex.
  struct Entry {
    Index middle, high, half_face_and_side;
    friend bool operator<(const Entry& p, const Entry& q) {
      return p.middle != q.middle ? p.middle < q.middle
             : p.high != q.high   ? p.high < q.high
                                  : p.half_face_and_side < q.half_face_and_side;
    }
  };

  Record record(std::size_t t, std::size_t k) const {
    const auto& v = tetrahedra_[t];
    std::array<Index, 3> w{};
    for (std::size_t i = 0, n = 0; i < 4; ++i)
      if (i != k) w[n++] = v[i];
    bool positive = k % 2 == 1;
    const auto order = [&](std::size_t i, std::size_t j) {
      if (w[j] < w[i]) std::swap(w[i], w[j]), positive = !positive;
    };
    order(0, 1), order(1, 2), order(0, 1);
    return {w[0], w[1], w[2], static_cast<Index>(4 * t + k), positive};
  }

  void find_faces(std::size_t vertex_count, const Control& control) {
    std::vector<std::size_t> bucket_begin(vertex_count + 2, 0);
    used_.assign(vertex_count, false);
    for (const auto& tetrahedron : tetrahedra_)
      for (std::size_t k = 0; k < 4; ++k) {
        used_[tetrahedron[k]] = true;
        Index low = none;
        for (std::size_t i = 0; i < 4; ++i)
          if (i != k) low = std::min(low, tetrahedron[i]);
        ++bucket_begin[low + 2];
      }
    for (std::size_t i = 2; i < bucket_begin.size(); ++i) bucket_begin[i] += bucket_begin[i - 1];
    std::vector<Entry> bucket(4 * tetrahedra_.size());
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      if (t % 4096 == 0) throw_if_stopped(control);
      for (std::size_t k = 0; k < 4; ++k) {
        const Record r = record(t, k);
        bucket[bucket_begin[r.low + 1]++] = {r.middle, r.high, 2 * r.half_face + r.positive};
      }
    }
    face_of_.resize(bucket.size());
    faces_.reserve(bucket.size() / 2 + bucket.size() / 16);
    begin_.assign(1, 0);
    for (Index v = 0; v < vertex_count; ++v) {
      if (v % 4096 == 0) throw_if_stopped(control);
      const auto star = std::span(bucket).subspan(bucket_begin[v], bucket_begin[v + 1] - bucket_begin[v]);
      std::ranges::sort(star, std::less<>{});
      for (const Entry& e : star) add(v, e.middle, e.high, e.half_face_and_side / 2, e.half_face_and_side % 2 == 1);
      begin_.push_back(faces_.size());
    }
  }

  void add(Index low, Index middle, Index high, Index half_face, bool positive) {
    if (faces_.size() == begin_.back() || faces_.back().b != middle || faces_.back().c != high)
      faces_.push_back({low, middle, high});
    Face& f = faces_.back();
    Index& side = positive ? f.positive : f.negative;
    if (side == none)
      side = half_face;
    else
      f.crowded = true;
    face_of_[half_face] = static_cast<Index>(faces_.size() - 1);
  }

  std::span<const std::array<Index, 4>> tetrahedra_;
  std::vector<Face> faces_;
  std::vector<Index> face_of_;
  std::vector<std::size_t> begin_;
  std::vector<bool> used_;
};

}  // namespace delref::verification_3
