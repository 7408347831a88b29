// SPDX-License-Identifier: Apache-2.0
// Geographic features of an answer for other programs: paths, areas, places.
#pragma once

#include <vector>

#include "answer.hpp"
#include "skein/geodata/shapes.hpp"

namespace skein::refine_tool {

/// Named as the answer names them.
std::vector<geodata::Feature> features_of(const Query& query, const Solution& solution);

}  // namespace skein::refine_tool
