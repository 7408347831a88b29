// SPDX-License-Identifier: Apache-2.0
// Makes the node of skein-mavlink once its vehicle is connected.
#pragma once

#include "skein/daemon_main/daemon_main.hpp"
#include "skein/mavlink_node/settings.hpp"

namespace skein::mavlink_daemon {

/// Opens the link and waits, without limit, until the autopilot reports the vehicle's position;
/// progress goes to standard error. The failure describes the error in the input.
Result<daemon_main::Crew, Failure> crew_of(const scenario::Scenario& scenario,
                                           const std::string& uav,
                                           const mavlink_node::Settings& settings);

}  // namespace skein::mavlink_daemon
