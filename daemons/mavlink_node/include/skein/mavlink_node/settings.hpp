// SPDX-License-Identifier: Apache-2.0
// Settings of skein-mavlink, from texts of its command line, environment or file.
#pragma once

#include <string>

#include "skein/autopilot/bridge.hpp"
#include "skein/foundation/result.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::mavlink_node {

struct Settings {
  std::string connect = "udpin:14540";
  std::string dialect = "auto";
  std::string system_id = "any";
  std::string own_id = "245";
  std::string camera = "1";
};

/// Configuration of the bridge of a UAV; the failure has all errors, joined by "; ".
Result<autopilot::BridgeConfig, Failure> bridge_config_of(const scenario::Scenario& scenario,
                                                          const std::string& uav,
                                                          const Settings& settings);

/// The node that is the functional layer of this UAV and of no other; or the reason why none is.
Result<std::string, Failure> layer_of(const scenario::Scenario& scenario, const std::string& uav);

}  // namespace skein::mavlink_node
