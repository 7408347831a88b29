// SPDX-License-Identifier: Apache-2.0
// The devices of all UAVs, told apart.
#pragma once

#include <string>

#include "skein/world/perception.hpp"

namespace skein::ground_station {

/// "marvin/visible".
inline std::string device_of(const world::Perception& look) { return look.uav + "/" + look.device; }

}  // namespace skein::ground_station
