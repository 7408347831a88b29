// SPDX-License-Identifier: Apache-2.0
// What each high-level task takes in time, place and energy, read off a plan of all of them.
#pragma once

#include <map>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// Of one high-level task. Seconds at the most.
struct Stay {
  bool moves = false;                             ///< it has an entry and an exit
  world::Vector3 entry = world::Vector3::Zero();  ///< where its first flight leads
  world::Vector3 exit = world::Vector3::Zero();   ///< where its last flight ends
  double approach = 0;                            ///< its first flight, as it was in that plan
  double approach_energy = 0;
  double inside = 0;      ///< from the entry to the end of all
  double last_start = 0;  ///< from the entry to the start of its last task
  double first_end = 0;   ///< from its beginning to the first end of a task, at the least
  double energy = 0;      ///< all of it, its first flight too
};

/// What leaving a task out saves.
struct Saving {
  double seconds = 0, energy = 0;
};

class Sketch {
 public:
  Sketch() = default;
  explicit Sketch(const mission::ElementaryPlan& plan, double cruise_speed);

  /// Nothing is known: takes no time, where it is.
  Stay of(mission::GoalId goal) const;
  /// Seconds of a flight, at the pace of those in the plan.
  double travel(const world::Vector3& from, const world::Vector3& to) const;
  /// Of leaving out one task of an order that begins at `start`.
  Saving saving(const Goals& order, std::size_t index, const world::Vector3& start) const;

 private:
  std::map<mission::GoalId, Stay> stays_;
  double pace_ = 0;           ///< [s/m]
  double flight_energy_ = 0;  ///< [1/s]
};

}  // namespace skein::supervisor
