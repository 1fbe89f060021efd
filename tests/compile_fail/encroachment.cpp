// expect: an encroachment policy needs: encroaches(tr, subsegment, point) const that gives bool, and a static constexpr bool deletes_free_vertices; and to be copy constructible
// times: 3
// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/levels/encroachment.hpp>

#include "archetype_criteria.hpp"
using namespace archetypes;

struct SomeTriangulation {
  struct Edge {};
};
static_assert(delref::explain_encroachment<NeverWithout<SomeTriangulation, EncroachmentPart::copy>, SomeTriangulation>());
static_assert(delref::explain_encroachment<NeverWithout<SomeTriangulation, EncroachmentPart::encroaches>, SomeTriangulation>());
static_assert(delref::explain_encroachment<NeverWithout<SomeTriangulation, EncroachmentPart::deletes_free_vertices>, SomeTriangulation>());
