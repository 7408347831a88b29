// SPDX-License-Identifier: Apache-2.0
// --mavlink-out: telemetry of the team to a ground station that speaks MAVLink.
#pragma once

#include <string>

#include "skein/daemon_main/daemon_main.hpp"

namespace skein::ground_companions {

class MavlinkStation final : public daemon_main::CompanionSource {
 public:
  void declare(CLI::App& app) override;
  Result<Opened, Failure> open(const daemon_main::Surroundings& surroundings) override;

 private:
  std::string address_;  ///< empty: no telemetry is sent
  double geoid_ = 0;     ///< of the sea over the ellipsoid there [m]
};

}  // namespace skein::ground_companions
