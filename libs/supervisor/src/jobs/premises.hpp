// SPDX-License-Identifier: Apache-2.0
// The assumptions of a job about plan and world.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

struct Premises {
  std::vector<TaskId> standing;
  std::set<TaskId> withdrawn;    ///< tasks to abort when the result is applied
  std::vector<GoalId> goals;     ///< planned anew
  std::vector<GoalId> added;     ///< goals inserted by operator 1
  std::uint64_t world = 0;       ///< Beliefs::revision()
  std::set<std::string> broken;  ///< devices
  TaskId next_id;
  std::optional<world::Vector3> position;  ///< the vehicle's [m, ENU], if no standing task moves it
  double stays_within = 0;  ///< [m] of that position while nothing moves it; on a circle if it
                            ///< cannot hover
};

/// The premises of a job that plans all free goals and the goals of the tasks `withdrawn`, which
/// its plan replaces.
Premises premises_of(const Book& book, const Beliefs& beliefs,
                     const std::set<TaskId>& withdrawn = {});

/// The tasks that an urgent mission interrupts: all in hand, except those of goals that have a
/// takeoff or a landing under way, or that were handed over to the ground.
std::set<TaskId> urgently_interrupted(const Book& book);

/// The tasks in hand, if one of them is a perception along a way that is under way and can be
/// interrupted and resumed (at the cost of the way there and back); else empty.
std::set<TaskId> interrupted_between_parts(const Book& book);

/// Whether a result with the premises `then` may be applied `now`: no task is new, missing tasks
/// have ended well, all else is unchanged.
bool hold(const Premises& then, const Premises& now, const Book& book);

}  // namespace skein::supervisor
