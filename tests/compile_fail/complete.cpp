// SPDX-License-Identifier: GPL-3.0-or-later
//
// The counterpart of the other sources: with nothing taken away, everything compiles under the same flags.
#include <delref/core/mesher.hpp>
#include <delref/core/queue/element_set.hpp>
#include <delref/criteria/sizing_field.hpp>
#include <delref/criteria/triangle_criteria.hpp>

#include "../unit/core/rule.hpp"
#include "archetype_criteria.hpp"
#include "archetypes.hpp"
using namespace archetypes;

static_assert(delref::explain_triangulation<Line>());
static_assert(delref::explain_level<Halves, Line>());
static_assert(delref::explain_observer<Watches<Event::proposed>, Line>());
static_assert(delref::explain_queue<Stack, Interval>());
static_assert(delref::explain_triangle_criterion<AnythingWithout<CriterionPart::none>>());
template void delref::explain_sizing_field<UnboundedWithout<FieldPart::none>>();

void refine(Line& line, track::Track<2>& road) {
  Watches<Event::proposed> watch;
  delref::Mesher(line, Halves(0.5), Halves(0.25)).step(watch);
  delref::Mesher(road, track::Rule<track::Track<2>>{}, track::Rule<track::Track<2>>{});
}
