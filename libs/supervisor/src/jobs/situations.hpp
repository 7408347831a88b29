// SPDX-License-Identifier: Apache-2.0
// The state that a plan starts from: when what the executive keeps is over. Source: spec 3.3.
#pragma once

#include <cstdint>
#include <memory>
#include <set>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// What a task does to where the vehicle is. One that does not end in the air or on the ground by
/// itself leaves it there where it was: a wait on the ground is no flight.
void move(const mission::ElementaryTask& task, Situation& at);

/// Lifetime: refers to its arguments.
class Situations {
 public:
  Situations(std::shared_ptr<const Knowledge> knowledge, const Beliefs& beliefs, const Book& book)
      : knowledge_(std::move(knowledge)), beliefs_(beliefs), book_(book) {}

  /// Without tasks: knowledge, world, and the situation after what stands, when `withdrawn` is told
  /// to stop.
  PlanningRequest base_request(const Standing& standing, const std::set<TaskId>& withdrawn,
                               std::uint64_t seed, MissionTime now) const;
  /// Where the last task that the executive keeps, of those that move it, leaves it.
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
