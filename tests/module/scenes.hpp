// SPDX-License-Identifier: GPL-3.0-or-later
//
// A domain for the tests of the module. To be included after `import delref;`.
#pragma once

/// A square of side 2 with a square hole of side 1 in the middle.
inline delref::Pslg square_with_hole() {
  delref::Pslg pslg;
  pslg.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  pslg.segment_markers = {1, 1, 1, 1, 2, 2, 2, 2};
  pslg.holes = {{1, 1}};
  return pslg;
}
