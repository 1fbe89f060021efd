// SPDX-License-Identifier: MIT
//
// What a level says of a proposed refinement point (Rineau and Yvinec 2007, section 3: PERMITTED, REJECTED, REJECTED_FOREVER),
// and the reasons for which a refinement is given up.
#pragma once

#include <cstdint>
#include <string_view>

namespace delref {

/// A level's answer about a refinement point.
enum class Verdict : std::uint8_t {
  permitted,        ///< nothing of this level is encroached
  rejected,         ///< an element of this level is encroached and is now in this level's set; the proposer will ask again
  rejected_forever  ///< the point must never be inserted: the proposing element leaves its set for good
};

/// Why an element that does not meet its criterion was left as it is.
enum class Reason : std::uint8_t {
  small_input_angle,  ///< the input angle at a corner forces it
  precision,          ///< the computed point does not kill its element, is not finite, or rounds onto a vertex
  size_floor,         ///< refining it would go below the smallest element that the budget allows
  protected_segment,  ///< it would need the split of a segment that the caller protects
  outside,            ///< its refinement point lies outside the triangulated domain
  blocked,            ///< a constraint hides its refinement point, and no level owns that constraint
  level_contract,     ///< a level rejected its point without queueing anything
  rejected_by_level,  ///< a level rejected its point for ever and gave no reason of its own
  budget              ///< the run was stopped before it was refined
};

/// The name of a reason, as reports spell it.
constexpr std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::small_input_angle: return "small input angle";
    case Reason::precision: return "precision";
    case Reason::size_floor: return "size floor";
    case Reason::protected_segment: return "protected segment";
    case Reason::outside: return "outside";
    case Reason::blocked: return "blocked";
    case Reason::level_contract: return "level contract";
    case Reason::rejected_by_level: return "rejected by a level";
    case Reason::budget: return "budget";
  }
  return "unknown";
}

}  // namespace delref
