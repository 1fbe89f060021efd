// expect: this triangulation has too few slots: more levels keep their place in an element than the element has slots; use a triangulation type with more slots per element
// SPDX-License-Identifier: MIT
#include <delref/core/mesher.hpp>

#include "../unit/core/rule.hpp"

void refine(track::Track<1>& road) {
  delref::Mesher(road, track::Rule<track::Track<1>>{}, track::Rule<track::Track<1>>{});
}
