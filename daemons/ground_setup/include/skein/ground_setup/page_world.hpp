// SPDX-License-Identifier: Apache-2.0
// The static part of a scenario for the operators' page.
#pragma once

#include <string>

#include "skein/scenario/scenario.hpp"

namespace skein::ground_setup {

/// One JSON object: name, terrain (heights [m] of a grid of at most 160 × 160 points, rows from the
/// south), zones, places, volumes, UAVs with their sensors, node numbers, what
/// a metre at cruise speed takes of a full store and what is kept in reserve (fractions), the
/// high-level tasks of the domain with the kinds of their parameters, the spatial constraints of
/// the interaction models by role and block. Only what operators know beforehand: no truth.
std::string page_world(const scenario::Scenario& scenario);

}  // namespace skein::ground_setup
