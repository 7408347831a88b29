// SPDX-License-Identifier: Apache-2.0
// The node of skein-mavlink, once its vehicle is there.
#pragma once

#include "skein/daemon_main/daemon_main.hpp"
#include "skein/mavlink_node/settings.hpp"

namespace skein::mavlink_daemon {

/// Opens the link and waits, without limit, until the autopilot says where the vehicle is; what
/// happens meanwhile it says on standard error. The failure says what is wrong with the input.
Result<daemon_main::Crew, Failure> crew_of(const scenario::Scenario& scenario,
                                           const std::string& uav,
                                           const mavlink_node::Settings& settings);

}  // namespace skein::mavlink_daemon
