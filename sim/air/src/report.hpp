// SPDX-License-Identifier: Apache-2.0
// What went through the air.
#pragma once

#include <string>
#include <vector>

#include "skein/air/air.hpp"

namespace skein::air {

/// One JSON document: for each direction the counts; `seconds`: how long.
std::string report_of(const Air& air, const std::vector<std::string>& names, double seconds);

}  // namespace skein::air
