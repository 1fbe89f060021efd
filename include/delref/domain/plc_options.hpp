// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a piecewise linear complex is to be understood where its numbers are not exact.
#pragma once

namespace delref {

/// Options of `check_plc`.
struct PlcOptions {
  /// Neighbouring facets whose planes differ by at most this many degrees are joined into one facet, if they bound the same
  /// regions and have the same marker; negative: none are. A box of twelve triangles then has six facets.
  double join_coplanar_degrees = -1;
  /// Input vertices at most so far apart are merged, in the unit of the input; 0 merges equal ones only.
  double merge_tolerance = 0;
  /// How far a vertex of a facet may be off its plane, in parts of the facet's diameter.
  double planarity_tolerance = 1e-5;
};

}  // namespace delref
