// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace skein::ground_station {

/// A UAV handed over, without being asked, what its contact-loss policy interrupted; it is held
/// now.
struct PlanInterrupted {
  std::string uav;
};

}  // namespace skein::ground_station
