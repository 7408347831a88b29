// SPDX-License-Identifier: Apache-2.0
// What a job supposes of the plan and of the world.
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
  std::set<TaskId> withdrawn;  ///< to be told to stop when its result is applied
  std::vector<GoalId> goals;   ///< planned anew
  std::vector<GoalId> added;   ///< by operator 1
  std::uint64_t world = 0;
  std::set<std::string> broken;
  TaskId next_id;
  std::optional<world::Vector3> position;  ///< where it is, when nothing moves it
};

/// Of a plan for all that is free and for the goals of these tasks, which it takes the place of.
Premises premises_of(const Book& book, const Beliefs& beliefs,
                     const std::set<TaskId>& withdrawn = {});

/// What an urgent mission interrupts: what is in hand, but no takeoff and no landing that has
/// begun, and nothing that the ground decides on.
std::set<TaskId> urgently_interrupted(const Book& book);

/// What is in hand when a task of which parts count is under way: a device that perceives along a
/// way, with what comes behind it. Interrupted it loses nothing but the way there and back. Empty:
/// there is none.
std::set<TaskId> interrupted_between_parts(const Book& book);

/// A result that supposed `then` is of use `now`: nothing new is there, what is missing has ended
/// well, nothing else is otherwise.
bool hold(const Premises& then, const Premises& now, const Book& book);

}  // namespace skein::supervisor
