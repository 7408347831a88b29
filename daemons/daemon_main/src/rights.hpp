// SPDX-License-Identifier: Apache-2.0
// Access rights of each node to DDS topics, for scripts/make-keys.
#pragma once

#include <string>

#include "skein/node/roster.hpp"

namespace skein::daemon_main {

/// A line "NODE publish|subscribe PARTITION SLOT" for each endpoint that a node of the roster
/// opens, and for all that a spy reads.
std::string rights_of(const node::Roster& roster);

}  // namespace skein::daemon_main
