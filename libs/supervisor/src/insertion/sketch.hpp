// SPDX-License-Identifier: Apache-2.0
// Time, places and energy of each high-level task, read off a plan of all of them.
#pragma once

#include <map>

#include "insertion/judge.hpp"

namespace skein::supervisor {

/// Figures of one high-level task; times in seconds, with greatest durations unless stated.
struct Stay {
  bool moves = false;                             ///< it has an entry and an exit
  world::Vector3 entry = world::Vector3::Zero();  ///< where its first flight leads
  world::Vector3 exit = world::Vector3::Zero();   ///< where its last flight ends
  double approach = 0;                            ///< duration of its first flight in that plan
  double approach_energy = 0;                     ///< energies: fractions of the full capacity
  double inside = 0;                              ///< from the entry to the end of its last task
  double last_start = 0;                          ///< from the entry to the start of its last task
  double first_end = 0;  ///< from its beginning to the first end of a task, with least durations
  double energy = 0;     ///< including its first flight
};

/// Time [s] and energy saved by leaving a task out.
struct Saving {
  double seconds = 0, energy = 0;
};

class Sketch {
 public:
  Sketch() = default;
  explicit Sketch(const mission::ElementaryPlan& plan, double cruise_speed);

  /// For a goal that is not in the plan: no motion, no time.
  Stay of(mission::GoalId goal) const;
  /// Duration of a flight [s], at the mean pace of the plan's flights.
  double travel(const world::Vector3& from, const world::Vector3& to) const;
  /// Saving by leaving out the task at `index` of an order that begins at `start`.
  Saving saving(const Goals& order, std::size_t index, const world::Vector3& start) const;

 private:
  std::map<mission::GoalId, Stay> stays_;
  double pace_ = 0;           ///< [s/m]
  double flight_energy_ = 0;  ///< [1/s]
};

}  // namespace skein::supervisor
