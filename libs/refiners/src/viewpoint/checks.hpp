// SPDX-License-Identifier: Apache-2.0
// Checks of view-point queries, and refusals of those without a solution.
#pragma once

#include <optional>

#include "viewpoint/search.hpp"

namespace skein::refiners {

/// Checks everything except the name of the sensor, which has been resolved.
std::optional<Refusal> check(const ViewpointQuery& query, const world::World& world,
                             const world::SensorModel& sensor);

/// The refusal if no place is good, with the number of places per failed check.
Refusal explain(const ViewpointField& field, const ViewpointSearch::Survey& survey);

}  // namespace skein::refiners
