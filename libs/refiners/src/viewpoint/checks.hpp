// SPDX-License-Identifier: Apache-2.0
// What is wrong with a query for view points, and why one has no answer.
#pragma once

#include <optional>

#include "viewpoint/search.hpp"

namespace skein::refiners {

/// All but the name of the sensor, which is known.
std::optional<Refusal> check(const ViewpointQuery& query, const world::World& world,
                             const world::SensorModel& sensor);

/// No place is good: what became of how many.
Refusal explain(const ViewpointField& field, const ViewpointSearch::Survey& survey);

}  // namespace skein::refiners
