// SPDX-License-Identifier: Apache-2.0
// "All UAVs" of a request: the shell's, as the ground station takes one name at a time.
#pragma once

#include <string>

#include "station.hpp"

namespace skein::operate_tool {

/// Whether an action of the list is for UAV "all". Text that is no JSON list names nobody so.
bool names_all(const std::string& request);

/// One action for each UAV in place of each for all: what is given back, kept or let go is what the
/// operator has in hand, what is asked for is what another has.
std::string for_all(const std::string& request, const std::string& who, const Boards& boards);

}  // namespace skein::operate_tool
