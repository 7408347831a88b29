// SPDX-License-Identifier: Apache-2.0
// The joint monitoring plan of the thesis. Source: notes 7 (T IV.4.1); take-off and landing may be
// quicker.
#pragma once

#include "controllability/stnu_builder.hpp"

namespace skein::temporal::testing {

/// Date 0 is 9:00:00. Each UAV takes off (20 to 30 s), both monitor together for 900 s, each lands
/// (20 to 30 s) before 9:40:00.
inline Stnu two_uavs() {
  constexpr Ticks kSecond = kTicksPerSecond;
  StnuBuilder builder(
      "nine monitor takeoff1 aloft1 done1 land1 down1 takeoff2 aloft2 done2 land2 down2");
  for (const std::string uav : {"1", "2"}) {
    builder.arc("nine", "takeoff" + uav, 0, kInfinite)
        .contingent("takeoff" + uav, "aloft" + uav, 20 * kSecond, 30 * kSecond)
        .arc("aloft" + uav, "monitor", 0, kInfinite)
        .contingent("monitor", "done" + uav, 900 * kSecond, 900 * kSecond)
        .arc("done" + uav, "land" + uav, 0, kInfinite)
        .contingent("land" + uav, "down" + uav, 20 * kSecond, 30 * kSecond)
        .arc("nine", "down" + uav, kMinusInfinite, 2400 * kSecond);
  }
  return builder.build();
}

inline NodeIndex node_named(const Stnu& network, const std::string& name) {
  const auto place = std::find(network.nodes.begin(), network.nodes.end(), name);
  return static_cast<NodeIndex>(place - network.nodes.begin());
}

}  // namespace skein::temporal::testing
