// SPDX-License-Identifier: Apache-2.0
// coverage: a way that sweeps an area entirely with a sensor's swath.
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
  double swath = 0;                   ///< width of the strip that is perceived [m], > 0
  double altitude = 0;                ///< of the lanes over the ground at their ends [m], > 0
  SweepMode mode = SweepMode::kLeastTime;
  double direction = 0;                 ///< of the lanes [rad], for kGiven
  std::optional<world::Vector3> start;  ///< where the vehicle comes from: begin near it
  std::optional<world::Vector3> end;    ///< where it goes afterwards
  double speed = 0;                     ///< [m/s]; 0: cruise
  MissionTime depart;                   ///< volumes with a time window count from then on
  /// All between the first lane and the last, turns too, stays within the area, which must be
  /// convex then: along its border a headland is left for the turns. A vehicle that hovers sweeps
  /// it in a lap along the border (but for the tips of corners sharper than a right angle); one
  /// that cannot leaves it out.
  bool turns_inside = false;
};

struct Lane {
  world::Vector2 from = world::Vector2::Zero(), to = world::Vector2::Zero();
};

struct Coverage {
  Way way;  ///< lanes and turns, in order; from `start` and to `end` where they are given
  std::vector<Lane> lanes;  ///< in the order and sense flown
  double direction = 0;     ///< of most lanes, [0, π) [rad]
  double length = 0;        ///< [m]
  std::size_t turns = 0;
  std::size_t parts = 1;  ///< convex parts that the area was cut into
  double energy = 0;      ///< fraction of what is held when full
  double headland = 0;    ///< width of the strip along the border that is left for turns [m]
  double left_out = 0;    ///< part of the area that is not swept because of it, [0, 1)
};

/// Refined cost: expected seconds, turns included. Steps of the budget: directions tried.
Outcome<Coverage> refine(const CoverageQuery& query, const Setting& setting);

/// Seconds from the end of one lane to the beginning of the next, `spacing` metres beside it and in
/// the opposite sense: for a vehicle that hovers, braking, moving over, turning round and gathering
/// speed; else the shortest curve it can fly.
double turn_time(const world::VehicleModel& vehicle, double spacing, double speed = 0);

}  // namespace skein::refiners
