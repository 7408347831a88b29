// SPDX-License-Identifier: Apache-2.0
// The initial state of a plan: after the tasks that the executive keeps. Source: spec 3.3.
#pragma once

#include <cstdint>
#include <memory>
#include <set>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Applies the effect of a task on position and `airborne`. A task type that does not define
/// whether it ends in the air or on the ground leaves that as it was: a wait on the ground is no
/// flight.
void move(const mission::ElementaryTask& task, Situation& at);

/// Lifetime: refers to its arguments.
class Situations {
 public:
  Situations(std::shared_ptr<const Knowledge> knowledge, const Beliefs& beliefs, const Book& book)
      : knowledge_(std::move(knowledge)), beliefs_(beliefs), book_(book) {}

  /// A request without tasks: knowledge, world, and the situation after the standing tasks,
  /// assuming that the tasks `withdrawn` are told to abort now.
  PlanningRequest base_request(const Standing& standing, const std::set<TaskId>& withdrawn,
                               std::uint64_t seed, MissionTime now) const;
  /// The place where the last standing task that moves the vehicle leaves it.
  Situation place_after(const Standing& standing) const;

 private:
  Situation situation(const Standing& standing, const std::set<TaskId>& withdrawn,
                      MissionTime now) const;
  void place_on_timelines(const Standing& standing, const std::set<TaskId>& withdrawn,
                          Situation& result) const;
  void place_loose(const std::set<TaskId>& withdrawn, Situation& result) const;
  Timeline timeline_after(const mission::ElementaryTask& task, MissionTime now) const;
  mission::Progress done_of(GoalId goal, const Standing& standing, MissionTime now) const;
  double energy_after(const Standing& standing, MissionTime now) const;

  std::shared_ptr<const Knowledge> knowledge_;
  const Beliefs& beliefs_;
  const Book& book_;
};

}  // namespace skein::supervisor
