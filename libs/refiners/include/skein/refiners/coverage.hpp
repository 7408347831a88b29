// SPDX-License-Identifier: Apache-2.0
// coverage: a path that sweeps an area entirely with a sensor's swath.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "skein/refiners/flight.hpp"
#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

/// How the direction of the lanes is chosen. Source: spec 4.2.
enum class SweepMode : std::uint8_t {
  kLeastTime,     ///< length and turns together
  kMinimumWidth,  ///< fewest lanes: across the minimum width of the area
  kLongestLine,   ///< along the longest straight line inside: the seeds' rule
  kGiven,         ///< along CoverageQuery::direction
};

struct CoverageQuery {
  world::VehicleModel vehicle;
  world::Polygon area;                ///< simple; convex or not
  std::vector<world::Polygon> holes;  ///< inside it, apart; need not be swept
  double swath = 0;                   ///< width of the perceived strip [m], > 0
  double altitude = 0;                ///< of the lanes over the ground at their ends [m], > 0
  SweepMode mode = SweepMode::kLeastTime;
  double direction = 0;                 ///< of the lanes [rad], for kGiven
  std::optional<world::Vector3> start;  ///< position of the vehicle before the sweep
  std::optional<world::Vector3> end;    ///< its destination after the sweep
  double speed = 0;                     ///< [m/s]; 0: cruise
  MissionTime depart;                   ///< volumes with a time window count from then on
  /// Keeps the path from the first lane to the last, turns included, within the area, which must
  /// then be convex: a headland along the border is reserved for turns. A hovering vehicle sweeps
  /// the headland in a lap along the border (except for the tips of corners sharper than a right
  /// angle); for others it stays unswept.
  bool turns_inside = false;
};

struct Lane {
  world::Vector2 from = world::Vector2::Zero(), to = world::Vector2::Zero();
};

struct Coverage {
  Way way;  ///< lanes and turns in order, including the legs from `start` and to `end` if given
  std::vector<Lane> lanes;  ///< in the order and direction flown
  double direction = 0;     ///< of most lanes, [0, π) [rad]
  double length = 0;        ///< [m]
  std::size_t turns = 0;
  std::size_t parts = 1;  ///< convex parts that the area was cut into
  double energy = 0;      ///< fraction of the full capacity
  double headland = 0;    ///< width of the headland along the border [m]
  double left_out = 0;    ///< fraction of the area not swept because of the headland, [0, 1)
};

/// Refined cost: expected seconds, turns included. Steps of the budget: directions tried.
Outcome<Coverage> refine(const CoverageQuery& query, const Setting& setting);

/// Duration [s] of the turn from the end of a lane to the beginning of the next one, which is
/// `spacing` [m] beside it and flown in the opposite direction: for a hovering vehicle braking,
/// moving sideways, turning and accelerating; for others the shortest curve of their turn radius.
double turn_time(const world::VehicleModel& vehicle, double spacing, double speed = 0);

}  // namespace skein::refiners
