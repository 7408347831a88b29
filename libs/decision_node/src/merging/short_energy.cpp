// SPDX-License-Identifier: Apache-2.0
#include "merging/short_energy.hpp"

#include <algorithm>

#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

bool ShortEnergy::lasts_longer(const Airways& ways, const world::VehicleState& seen) const {
  return std::any_of(ways.begin(), ways.end(), [&](const Airway& one) {
    if (one.way)
      return !supervisor::must_come_home(seen.energy, knowledge_, world_, now_, one.way->points());
    return !supervisor::must_land(seen.energy, knowledge_, world_, now_,
                                  std::vector{seen.position});
  });
}

const Airway& ShortEnergy::least_costly(const Airways& ways) const {
  const auto cost = [&](const Airway& one) {
    return one.way ? supervisor::least_to_come_home(knowledge_, world_, now_, one.way->points())
                   : 0.0;
  };
  return *std::min_element(ways.begin(), ways.end(),
                           [&](const Airway& a, const Airway& b) { return cost(a) < cost(b); });
}

bool ShortEnergy::lasts_after(const Airway& aside, double energy) const {
  return !aside.way ||
         !supervisor::must_land(energy, knowledge_, world_, now_, aside.way->points());
}

}  // namespace skein::decision_node
