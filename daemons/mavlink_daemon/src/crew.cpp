// SPDX-License-Identifier: Apache-2.0
#include "crew.hpp"

#include <poll.h>

#include <iostream>

#include "skein/mavlink_node/mavlink_node.hpp"
#include "skein/scenario_setup/setup.hpp"

namespace skein::mavlink_daemon {

namespace {

/// Others begin when all take part, and then want to fly: so this one takes part once it can.
void wait_for_vehicle(mavlink_node::Cockpit& cockpit, const std::string& where) {
  std::cerr << "waiting for the autopilot at " << where << '\n';
  while (!cockpit.is_ready()) {
    pollfd file{cockpit.descriptor(), POLLIN, 0};
    poll(&file, 1, static_cast<int>(100 / cockpit.rate()) + 1);
    cockpit.turn();
    for (const autopilot::Effect& effect : cockpit.take()) {
      if (const auto* notice = std::get_if<autopilot::Notice>(&effect))
        std::cerr << notice->text << '\n';
    }
  }
}

}  // namespace

Result<daemon_main::Crew, Failure> crew_of(const scenario::Scenario& scenario,
                                           const std::string& uav,
                                           const mavlink_node::Settings& settings) {
  const auto layer = mavlink_node::layer_of(scenario, uav);
  if (!layer) return tl::unexpected(layer.error());
  auto config = mavlink_node::bridge_config_of(scenario, uav, settings);
  if (!config) return tl::unexpected(config.error());
  auto link = mavlink_node::Link::open(settings.connect);
  if (!link) return failure("--connect: " + link.error().why);
  auto cockpit = std::make_shared<mavlink_node::Cockpit>(autopilot::Bridge(std::move(*config)),
                                                         std::move(*link), scenario.rate);
  if (scenario.rate > 1 || scenario.rate < 1)
    std::cerr << "the rate is " << scenario.rate << ": only a simulated vehicle keeps up\n";
  wait_for_vehicle(*cockpit, settings.connect);
  return daemon_main::Crew{*layer,
                           std::make_unique<mavlink_node::MavlinkNode>(
                               *layer, uav, scenario_setup::roster_of(scenario), cockpit),
                           std::make_unique<mavlink_node::LinkCompanion>(*layer, uav, cockpit)};
}

}  // namespace skein::mavlink_daemon
