// SPDX-License-Identifier: Apache-2.0
// Numbers as the experiment's documents write them.
#pragma once

#include <string>

namespace skein::temporal {

/// Rounded to so many places.
std::string rounded(double value, int places = 2);

/// "N = 8, E = 4".
std::string shape_text(double agents, double external);

}  // namespace skein::temporal
