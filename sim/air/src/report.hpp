// SPDX-License-Identifier: Apache-2.0
// The report on the packets carried.
#pragma once

#include <string>
#include <vector>

#include "skein/air/air.hpp"

namespace skein::air {

/// One JSON document with the counts of each direction. `seconds`: duration of the run.
std::string report_of(const Air& air, const std::vector<std::string>& names, double seconds);

}  // namespace skein::air
