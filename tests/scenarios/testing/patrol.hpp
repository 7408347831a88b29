// SPDX-License-Identifier: Apache-2.0
// A mission of any length.
#pragma once

#include "skein/scenario/scenario.hpp"

namespace skein::testing {

/// Marvin is sent along ways by the ground station (three commands a minute), Heliv plans missions
/// on board (one in two minutes); contact is lost four times an hour, energy never ends. Stops the
/// program if it cannot be read.
scenario::Scenario patrol_of(int hours);

}  // namespace skein::testing
