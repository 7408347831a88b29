// SPDX-License-Identifier: Apache-2.0
// An answer as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "answer.hpp"

namespace skein::refine_tool {

/// {service, feasible: true, cost, cost_unit, duration, effort, NAME OF THE TASK: {…}}, or
/// {service, feasible: false, refusal: {kind, field, why}}. Metres, seconds, radians; what is never
/// over is null. docs/refiners.md shows all of it by example.
nlohmann::ordered_json to_json(const Query& query, const Answer& answer);

/// The unit of Refined::cost of a service.
const char* cost_unit(const Solution& solution);

}  // namespace skein::refine_tool
