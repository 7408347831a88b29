// SPDX-License-Identifier: Apache-2.0
// What energy a vehicle has left, against what it takes to come down.
#pragma once

#include "skein/laws/history.hpp"

namespace skein::laws {

/// Nobody could keep the reserve from there, or hardly: going home and landing takes, with half as
/// much again, more than is left above it.
bool lacks_energy_to_land(const History& history, const Uav& uav, const Sample& sample);

}  // namespace skein::laws
