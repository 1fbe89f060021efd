// SPDX-License-Identifier: MIT
//
// The archetypes of the frame: for each of its concepts a type with the required members and no other.
#pragma once

#include "archetype_level.hpp"
#include "archetype_policies.hpp"
#include "archetype_triangulation.hpp"
