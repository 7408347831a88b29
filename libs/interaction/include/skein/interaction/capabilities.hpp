// SPDX-License-Identifier: Apache-2.0
// What a UAV has of what may be asked of it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "skein/interaction/requirement.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::interaction {

/// A capability of a UAV: with values (`camera: visible`, `camera: ir`), with a figure
/// (`endurance`), or neither.
struct Capability {
  std::set<std::string> values;
  std::optional<double> figure;
};
using Capabilities = std::map<std::string, Capability>;

/// Of a vehicle with so much of its energy [0, 1]: `hovering`, `radio: relay`, a `camera` of each
/// sensor and its `SENSOR-range` [m], `speed` [m/s] and `ceiling` [m] at the most, `endurance` in
/// hover on what is left over the reserve [s], and the figures that its model declares.
Capabilities capabilities_of(const world::VehicleModel& vehicle, double energy);

/// All requirements that the capabilities do not meet. Source: T def. V.1, V.3.2.
std::vector<Requirement> unmet(const std::vector<Requirement>& requirements,
                               const Capabilities& capabilities);

/// "it lacks camera: ir, payload ≥ 2 (it has 1.5)"; empty: nothing.
std::string lacking(const std::vector<Requirement>& requirements, const Capabilities& capabilities);

}  // namespace skein::interaction
