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
  Way way;               ///< that leads to it from the place before
};

struct Tour {
  std::vector<Visit> visits;  ///< every stop once, in order
  Way last;                   ///< to `end`; empty without one
  double length = 0;          ///< of the ways in between [m]
  double energy = 0;          ///< fraction of what is held when full; inside: as at cruise speed
  bool exact = false;         ///< no order has a lower cost
};

/// Ways are straight where the airspace is free, else those of `path`; a gate that is blocked is
/// not used. Refined cost: expected seconds, between stops and inside. Steps of the budget: see
/// tour_problem.hpp, where the order is found; exact up to 12 stops. Without a clock 200 stops take
/// some 50 to 150 ms beside the ways. Refused when the whole needs more energy than the vehicle may
/// use. Cost of the ways: O((gates)²) straight lines, and a path where they are not free.
Outcome<Tour> refine(const TourQuery& query, const Setting& setting);

}  // namespace skein::refiners
