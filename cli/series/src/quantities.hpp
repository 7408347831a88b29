// SPDX-License-Identifier: Apache-2.0
// Quantities of a run by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "state.hpp"

namespace skein::series_tool {

struct Column {
  std::string name;  ///< "energy marvin", "distance marvin heliv", "alarms"
  std::function<double(const State&)> value;
};

/// "x [m]: east of the origin, of each UAV", one a line.
std::string list_of_quantities();

/// The columns of quantities, of these UAVs: one for each UAV, for each two, or one for all. Wrong
/// names are told all at once, with the nearest right one.
Result<std::vector<Column>, Diagnostics> columns_of(const std::vector<std::string>& quantities,
                                                    const std::vector<std::string>& uavs);

}  // namespace skein::series_tool
