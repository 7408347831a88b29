// SPDX-License-Identifier: Apache-2.0
// Ways that are flown and not planned by the supervisor.
#pragma once

#include "skein/refiners/path.hpp"

namespace skein::decision_node {

/// A way at once, a little over the ground at least, as the path refiner is asked for it.
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
