// SPDX-License-Identifier: Apache-2.0
// --ros2: topics of ROS 2 about the team, and missions from them.
#pragma once

#include <cstdint>
#include <optional>

#include "skein/daemon_main/daemon_main.hpp"

namespace skein::ground_companions {

class Ros2Topics final : public daemon_main::CompanionSource {
 public:
  void declare(CLI::App& app) override;
  Result<Opened, Failure> open(const daemon_main::Surroundings& surroundings) override;

 private:
  std::optional<std::uint32_t> domain_;  ///< ROS_DOMAIN_ID; none: no topics
};

}  // namespace skein::ground_companions
