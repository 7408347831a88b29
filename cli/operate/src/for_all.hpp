// SPDX-License-Identifier: Apache-2.0
// "All UAVs" of a request: the shell's, as the ground station takes one name at a time.
#pragma once

#include <string>

#include "station.hpp"

namespace skein::operate_tool {

/// Whether an action of the list is for UAV "all". False for text that is no JSON list.
bool names_all(const std::string& request);

/// Replaces each action for "all" by one for each UAV concerned: giving back, keeping and letting
/// go concern the UAVs that the operator controls, asking those that another operator controls.
std::string for_all(const std::string& request, const std::string& who, const Boards& boards);

}  // namespace skein::operate_tool
