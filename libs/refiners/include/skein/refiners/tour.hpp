// SPDX-License-Identifier: Apache-2.0
// tour: the order in which to visit points and areas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"

namespace skein::refiners {

/// One possible visit of a stop: entry, exit, and the duration in between.
struct Gate {
  world::Vector3 entry = world::Vector3::Zero();
  world::Vector3 exit = world::Vector3::Zero();
  Duration inside;
};

/// A point or area to visit. A point has one gate, whose entry is its exit; an area has several
/// (the corners where its sweep may begin), of which one is used.
struct Stop {
  std::string name;
  std::vector<Gate> gates;  ///< at least one
};

struct TourQuery {
  world::VehicleModel vehicle;
  world::Vector3 start = world::Vector3::Zero();
  std::optional<world::Vector3> end;  ///< absent: the tour ends at the exit of the last stop
  std::vector<Stop> stops;            ///< at least one
  double clearance = 0;               ///< of the paths between stops [m]
  double speed = 0;                   ///< [m/s]; 0: cruise
  MissionTime depart;
};

struct Visit {
  std::size_t stop = 0;  ///< index into the query
  std::size_t gate = 0;  ///< index into its gates
  Way way;  ///< path to the entry from the previous place; one point: it is the same place
};

struct Tour {
  std::vector<Visit> visits;  ///< every stop once, in order
  Way last;                   ///< to `end`; empty without one
  double length = 0;          ///< of the paths between stops [m]
  double energy = 0;          ///< fraction of the full capacity; inside stops at cruise speed
  bool exact = false;         ///< no order has a lower cost
};

/// Most rounds of ordering a tour; each round plans at most one path for each stop and one to the
/// end.
inline constexpr std::size_t kMostTourRounds = 50;

/// Paths are straight where the airspace is free, else those of the path service (avoiding every
/// volume whose window is open at any time after `depart`); closed gates are not used.
/// Refined cost: expected seconds, between and inside stops. Exact up to 12 stops.
///
/// Paths are planned lazily: stops are ordered first by the times of straight flights, which are
/// lower bounds, then again with the real times of the paths used, until nothing changes, at most
/// kMostTourRounds times. Steps of the budget: those of tour_problem.hpp, over all rounds. When the
/// clock ends the search, the best tour with all paths known is returned, kBudgetExhausted if there
/// is none. With a clock the search uses all of its time, over the known paths.
///
/// Refused if the tour needs more energy than the vehicle may use. Cost: the airspace is built
/// once; then for each round an ordering, and a path for each new leg that is not free. Measured
/// without a clock in a valley of 200 × 200 × 34 voxels where two of three pairs are closed
/// (bench/tour_bench.cpp): 200 stops in 0.15 s of CPU with 2 to 4 ways for a vehicle that hovers,
/// in 0.7 to 1.3 s with some 200 ways for one that does not.
Outcome<Tour> refine(const TourQuery& query, const Setting& setting);

}  // namespace skein::refiners
