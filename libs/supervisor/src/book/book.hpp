// SPDX-License-Identifier: Apache-2.0
// The supervisor's record of goals (high-level tasks) and elementary tasks: planned, given to the
// executive, observed.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "book/entry.hpp"
#include "flight/whereabouts.hpp"
#include "skein/foundation/byte_book.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/insertion.hpp"

namespace skein::supervisor {

using executive::TaskState;
using mission::GoalId;
using mission::GoalState;

/// A high-level task.
struct Goal {
  mission::HighLevelTask task;
  mission::MissionId mission;
  std::string asked_by;
  GoalState state = GoalState::kReceived;
  std::string why;
  int refined = 0;      ///< how often it was refined again after a failure
  std::string no_air;   ///< why it was given up last for want of air
  bool queued = false;  ///< its mission waits for its insertion
  std::string done;     ///< its progress in words, by tasks that are over
  /// Planned without tasks: the goal will be true when its turn comes, provided that the vehicle is
  /// at this place then.
  std::optional<Whereabouts> true_at;
  MissionTime settled;      ///< when it was settled, if it is
  bool tasks_gone = false;  ///< it is settled, and its tasks were removed from the book

  /// Neither settled nor handed over to the ground station.
  bool open() const { return !is_settled(state) && state != GoalState::kHandedOver; }
};

/// A task of the executive that belongs to no goal: a safe wait, or a task that others gave.
struct Loose {
  std::string type;
  bool ours = false;  ///< the supervisor gave it
  bool holds_vehicle = false;
  bool stopping = false;    ///< the supervisor told the executive to abort it
  bool ran = false;         ///< the functional layer accepted it
  bool begun = false;       ///< the executive started it
  bool leads_away = false;  ///< given by an operator; the vehicle's position after it is unknown
  bool gives_way = false;  ///< given by others, begun, and over when another task needs the vehicle
};

/// In Book::forgotten: the supervisor gave it, and another executive has it; it may come back.
inline constexpr std::uint8_t kOursElsewhere = 2;

/// True for a task that ends by its stop or by an order: the executive never counts it as ended.
bool ends_by_order(const mission::ElementaryTask& task);

/// True when a precondition of `task` is that `other` has ended (not merely is over), or runs.
bool depends_on(const mission::ElementaryTask& task, TaskId other);

/// Goals and elementary tasks by id; `order` is the high-level plan.
class Book {
 public:
  std::map<GoalId, Goal> goals;
  ByteBook past;  ///< 1 for goals that were removed from `goals`
  std::vector<GoalId> order;
  std::map<TaskId, Entry> tasks;
  std::map<TaskId, Loose> loose;  ///< tasks of no goal that are not over
  ByteBook forgotten;             ///< tasks of no goal that are over, or another executive's: 1, or
                                  ///< kOursElsewhere
  std::set<TaskId> elsewhere;     ///< another executive has these, and is to give them back
  Meetings meetings;              ///< what is known of partners and their plans
  TaskId next_id{1};
  bool more_settled = false;  ///< goals were settled since the last let_go_of_the_past()

  /// Whether there ever was a goal with this id.
  bool knows(GoalId id) const { return goals.contains(id) || past.knows(id.value()); }
  Entry* find(TaskId id);
  const Entry* find(TaskId id) const;

  /// Live tasks (Entry::live) of the goal, by id.
  std::vector<const Entry*> of(GoalId goal) const;
  bool has_in_hand(GoalId goal) const;
  bool is_wholly_given(GoalId goal) const;
  bool is_given(GoalId goal) const;  ///< some live task of it was given to the executive
  bool is_planned(GoalId goal) const;
  bool was_begun(GoalId goal) const;  ///< some task of it, even a withdrawn one, has started
  bool has_lost(GoalId goal) const;   ///< some live task of it was aborted

  /// Tasks of the plan that the executive has and keeps.
  std::vector<TaskId> in_hand() const;
  bool nothing_in_hand() const;
  Standing standing(const std::set<TaskId>& but = {}) const;
  /// The task is part of the plan's network: live, not over, and given, or its goal is still open.
  bool counts(const Entry& entry) const;
  /// The tasks for which counts() is true.
  std::vector<mission::ElementaryTask> open_tasks() const;

  /// Goals that a job may plan anew: open, not queued and not with the executive; in order. A goal
  /// without tasks counts as given if a goal behind it is given.
  std::vector<GoalId> free_goals() const;
  /// Bounds after goals, of all unsettled goals and of `more` (goals that are not in the book yet);
  /// and what is known of meetings.
  GoalBounds bounds(const std::vector<mission::HighLevelTask>& more = {}) const;
  std::vector<mission::HighLevelTask> tasks_of(const std::vector<GoalId>& ids) const;

  /// Tasks that the executive never counts as ended.
  std::set<TaskId> ending_by_order() const;
  /// `goals`, and transitively the goals with tasks in hand that depend on unfinished tasks of
  /// these.
  std::set<GoalId> falling_with(std::set<GoalId> goals) const;
  /// Tasks of the executive that hold the vehicle, are not over, and have no precedence in the
  /// plan: withdrawn tasks, tasks given by others, and waits for orders that come before the task
  /// `next`.
  std::set<TaskId> loose_motion(TaskId next) const;
  /// The same for tasks that use the device.
  std::set<TaskId> loose_users_of(const std::string& device) const;
  /// An operator's task that moves the vehicle away (Loose::leads_away) is not over.
  bool is_led_away() const;
  /// Open-ended tasks that wait for orders and are not over.
  std::vector<const Entry*> waits_for_orders() const;
  /// The vehicle has a reason to fly: a task that was not told to stop is under way, or one that
  /// moves or holds the vehicle is expected to begin by `soon`.
  bool has_occupation(MissionTime soon) const;
  /// A task given by others that holds the vehicle, has not begun, and that tasks of the plan wait
  /// for; absent while any task that holds the vehicle is under way.
  std::optional<TaskId> in_the_way() const;
  /// A landing was told to stop and is not over: below some height it continues to the ground.
  bool stops_landing() const;
  /// A safe wait is under way and was not told to stop.
  bool waits_safely() const;
  /// All conditions of the task are met.
  bool is_due(const Entry& entry) const;

  /// The goals that are parts (kMapPart) of this mapping, by id.
  std::vector<GoalId> parts_of(GoalId whole) const;
  /// Updates Entry::beyond: the way-points that planned parts leave to their mappings.
  void note_parts();

  /// "goal 702 (perform-detection Z2 P2 300)".
  std::string named(GoalId goal) const;

  /// Enters a task of no goal: a safe wait, an immediate landing. Returns its id.
  TaskId add_loose(const std::string& type);
  void enter(const mission::ElementaryPlan& plan);
  /// Withdraws the tasks of these goals. Returns the tasks that the executive has to be told to
  /// abort, the highest id first; tasks that were only planned are dropped.
  std::vector<TaskId> withdraw(const std::set<GoalId>& from);
  /// Moves settled goals to the front of `order`; returns all goals in that order. Cost: one
  /// look-up per goal.
  std::vector<const Goal*> goals_settled_first();
  /// New order: settled goals, then `wanted`, then the others in their previous order.
  void reorder(const std::vector<GoalId>& wanted);
};

}  // namespace skein::supervisor
