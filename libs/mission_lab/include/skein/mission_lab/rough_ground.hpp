// SPDX-License-Identifier: Apache-2.0
// Mountains under a mission.
#pragma once

#include "skein/mission_lab/mission.hpp"

namespace skein::mission_lab {

/// Puts some steep hills, of up to 140 m each, where the vehicles of a drawn mission fly, instead
/// of those that it has: places that were on the plain are on the ground there, those in the air as
/// high above it. Where vehicles start and land, and around the ground station, it stays level.
/// Deterministic for the mission's seed.
void roughen(Mission& mission);

}  // namespace skein::mission_lab
