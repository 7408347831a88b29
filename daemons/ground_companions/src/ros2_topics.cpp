// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_companions/ros2_topics.hpp"

#include <CLI/CLI.hpp>

#include "skein/ros2_out/ros2_out.hpp"

namespace skein::ground_companions {

void Ros2Topics::declare(CLI::App& app) {
  app.add_option("--ros2", domain_,
                 "Tell programs of ROS 2 in this domain (ROS_DOMAIN_ID) of the team, and take "
                 "missions from them")
      ->check(CLI::Range(0, 100));
}

Result<daemon_main::CompanionSource::Opened, Failure> Ros2Topics::open(
    const daemon_main::Surroundings& surroundings) {
  if (!domain_) return Opened{};
  auto out = ros2_out::Ros2Out::open(
      {*domain_, surroundings.network, ros2_out::narrator_config_of(surroundings.scenario)});
  if (!out) return failure("--ros2: " + out.error().why);
  return Opened{std::move(*out), "topics of ROS 2 in its domain " + std::to_string(*domain_)};
}

}  // namespace skein::ground_companions
