// SPDX-License-Identifier: Apache-2.0
// tour: the order in which to visit points and areas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"

namespace skein::refiners {

/// One way of visiting a stop: in here, out there, and what it takes in between.
struct Gate {
  world::Vector3 entry = world::Vector3::Zero();
  world::Vector3 exit = world::Vector3::Zero();
  Duration inside;
};

/// A point has one gate, whose entry is its exit; an area has several (the corners where its sweep
/// may begin), of which one is used.
struct Stop {
  std::string name;
  std::vector<Gate> gates;  ///< at least one
};

struct TourQuery {
  world::VehicleModel vehicle;
  world::Vector3 start = world::Vector3::Zero();
  std::optional<world::Vector3> end;  ///< absent: where the last stop leaves it
  std::vector<Stop> stops;            ///< at least one
  double clearance = 0;               ///< of the ways in between [m]
  double speed = 0;                   ///< [m/s]; 0: cruise
  MissionTime depart;
};

struct Visit {
  std::size_t stop = 0;  ///< index into the query
  std::size_t gate = 0;  ///< index into its gates
  Way way;  ///< that leads to it from the place before; one point: it is the same place
};

struct Tour {
  std::vector<Visit> visits;  ///< every stop once, in order
  Way last;                   ///< to `end`; empty without one
  double length = 0;          ///< of the ways in between [m]
  double energy = 0;          ///< fraction of what is held when full; inside: as at cruise speed
  bool exact = false;         ///< no order has a lower cost
};

/// Most times that a tour is ordered; each time at most one way for each stop and the end is looked
/// for.
inline constexpr std::size_t kMostTourRounds = 50;

/// Ways are straight where the airspace is free, else those of `path` (through volumes at no time
/// of theirs, if they can be met at any time after `depart`); a gate that is closed is not used.
/// Refined cost: expected seconds, between stops and inside. Exact up to 12 stops.
///
/// Ways are looked for only where a tour uses them: ordered first by straight flights, which no way
/// beats, then again with what the ways used really take, until nothing changes, at most
/// kMostTourRounds times. Steps of the budget: of tour_problem.hpp, of all orders together. A clock
/// that cuts gives the best tour of which all ways were found; kBudgetExhausted when there was
/// none. With a clock the search goes on until it is up, over the ways known.
///
/// Refused when the whole needs more energy than the vehicle may use. Cost: the airspace is built
/// once; then for each round an order, and a way for each new leg that is not free. Measured
/// without a clock in a valley of 200 × 200 × 34 voxels where two of three pairs are closed
/// (bench/tour_bench.cpp): 200 stops in 0.15 s of CPU with 2 to 4 ways for a vehicle that hovers,
/// in 0.7 to 1.3 s with some 200 ways for one that does not.
Outcome<Tour> refine(const TourQuery& query, const Setting& setting);

}  // namespace skein::refiners
