// SPDX-License-Identifier: Apache-2.0
// Rooms of the supervisor without the supervisor: a book with a plan in it, and who works on it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "safety/safe_mode.hpp"
#include "testing/core_harness.hpp"
#include "watch/contingencies.hpp"

namespace skein::supervisor::testing {

/// Its calls begin with `at`. Nothing is given to an executive but by the room under test, or
/// `gave`.
class Rooms {
 public:
  explicit Rooms(Config with = config_for_tests())
      : config(std::move(with)),
        beliefs(*config.knowledge, config.world),
        out(book),
        dates(book, config.grace),
        agenda(out),
        committer(config.knowledge->vehicle, config.horizon, agenda, dates, out, book),
        contingencies({config.grace, config.refinements},
                      {beliefs, dates, committer, agenda, out, book}),
        safe_mode(config.horizon, beliefs, agenda, committer, out, book) {
    book.next_id = config.first_id;
  }
  Rooms(const Rooms&) = delete;

  Rooms& at(double s) {
    out.begin(MissionTime::seconds(s));
    return *this;
  }
  Rooms& goals(const std::vector<std::uint64_t>& ids, GoalState state = GoalState::kPlanned) {
    for (const std::uint64_t id : ids) {
      Goal goal;
      goal.task = a_goal(id);
      goal.state = state;
      book.goals[GoalId{id}] = goal;
      book.order.push_back(GoalId{id});
    }
    return *this;
  }
  /// Enters the tasks, and gives them dates.
  Rooms& plan(std::vector<mission::ElementaryTask> tasks) {
    book.enter(plan_of(std::move(tasks)));
    dates.update(out.now());
    dates.promise();
    return *this;
  }
  Rooms& gave(const std::vector<std::uint64_t>& tasks) {
    for (const std::uint64_t id : tasks) entry(id).advance(Step::kGive);
    return *this;
  }
  Rooms& started(std::uint64_t id) {
    entry(id).seen.started = out.now();
    dates.update(out.now());
    return *this;
  }
  Rooms& ended(std::uint64_t id) {
    entry(id).seen.over = out.now();
    entry(id).advance(Step::kEnd);
    return *this;
  }
  Rooms& lost(std::uint64_t id) {
    entry(id).seen.over = out.now();
    entry(id).seen.aborted = true;
    entry(id).advance(Step::kAbort);
    return *this;
  }
  Rooms& flies(world::Vector3 position = {0, 0, 40}) {
    world::VehicleState state;
    state.position = std::move(position);
    state.airborne = true;
    beliefs.see(state, {}, out.now());
    return *this;
  }

  Entry& entry(std::uint64_t id) { return book.tasks.at(TaskId{id}); }
  GoalState state_of(std::uint64_t id) const { return book.goals.at(GoalId{id}).state; }
  /// Since the last call, which ends.
  std::vector<std::string> requests() { return Desk::requests_in(out.close()); }
  std::vector<std::string> notices() {
    std::vector<std::string> words;
    for (const Effect& effect : out.close()) {
      if (const auto* one = std::get_if<Notice>(&effect)) words.push_back(one->text);
    }
    return words;
  }

  Config config;
  Book book;
  Beliefs beliefs;
  Outbox out;
  Dates dates;
  Agenda agenda;
  Committer committer;
  Contingencies contingencies;
  SafeMode safe_mode;
};

inline std::vector<TaskId> tasks_of(const std::vector<std::uint64_t>& ids) {
  std::vector<TaskId> result;
  for (const std::uint64_t id : ids) result.emplace_back(id);
  return result;
}
inline std::vector<GoalId> goal_ids(const std::vector<std::uint64_t>& ids) {
  std::vector<GoalId> result;
  for (const std::uint64_t id : ids) result.emplace_back(id);
  return result;
}

}  // namespace skein::supervisor::testing
