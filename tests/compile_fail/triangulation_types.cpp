// expect: a triangulation needs: types Point (with is_finite(point)), Vertex (copyable, comparable), Edge, Hint, Zone, all but Hint default constructible, and a constant `dimension`
// times: 7
// SPDX-License-Identifier: MIT
#include <delref/core/triangulation_concept.hpp>

#include "archetype_triangulation.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<LineWithout<LinePart::point_type>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::is_finite>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::vertex_type>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::edge_type>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::hint_type>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::zone_type>>());
static_assert(delref::explain_triangulation<LineWithout<LinePart::dimension>>());
