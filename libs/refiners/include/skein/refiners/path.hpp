// SPDX-License-Identifier: Apache-2.0
// path: the least costly path from one place to another.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "skein/refiners/flight.hpp"
#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/volume.hpp"

namespace skein::refiners {

/// Radio contact to be kept all along a path: with `with`, directly or through any of the relays
/// (each of which must itself have a link to `with`, directly or through other relays).
struct Contact {
  world::Vector3 with = world::Vector3::Zero();
  std::vector<world::Vector3> relays;
};

struct PathQuery {
  world::VehicleModel vehicle;
  world::Vector3 from = world::Vector3::Zero();
  world::Vector3 to = world::Vector3::Zero();
  /// Headings of the vehicle at the ends [rad]; they bind only vehicles that cannot hover.
  std::optional<double> heading_from, heading_to;
  double clearance = 0;                 ///< least height over the ground [m], >= 0
  double speed = 0;                     ///< [m/s]; 0: cruise
  MissionTime depart;                   ///< volumes with a time window count from then on
  std::vector<world::Volume> reserved;  ///< volumes of other vehicles, closed for this path
  std::optional<Contact> contact;
};

struct Path {
  Way way;                ///< from `from` to `to`; flyable by the vehicle. No two equal points in
                          ///< succession; a single point if both ends are the same
  double length = 0;      ///< [m]
  double graph_cost = 0;  ///< of the least costly path on the graph, before it was pulled straight
                          ///< [m × crossing cost]; 0 when no graph was searched
  double energy = 0;      ///< fraction of the full capacity
};

/// A path planning algorithm. Refined cost: integral of the crossing cost along the path [m ×
/// cost]. Steps of the budget: nodes expanded, or states sampled.
class PathPlanner {
 public:
  PathPlanner() = default;
  PathPlanner(const PathPlanner&) = delete;
  PathPlanner& operator=(const PathPlanner&) = delete;
  virtual ~PathPlanner() = default;
  /// Any thread.
  virtual Outcome<Path> plan(const PathQuery& query, const Setting& setting) const = 0;
};

/// Plans with setting.paths; if null, with VoxelPathPlanner.
Outcome<Path> refine(const PathQuery& query, const Setting& setting);

}  // namespace skein::refiners
