// SPDX-License-Identifier: Apache-2.0
// Path queries for ways that the supervisor does not plan.
#pragma once

#include "skein/refiners/path.hpp"

namespace skein::decision_node {

/// A query to the path refiner for a way that begins now, with a small ground clearance.
inline refiners::PathQuery path_query(const world::VehicleModel& vehicle,
                                      const world::Vector3& from, const world::Vector3& to,
                                      MissionTime now) {
  refiners::PathQuery query;
  query.vehicle = vehicle;
  query.from = from;
  query.to = to;
  query.clearance = 5;  // [m]
  query.depart = now;
  return query;
}

}  // namespace skein::decision_node
