// SPDX-License-Identifier: Apache-2.0
// What the supervisor keeps of goals and tasks: planned, given to the executive, seen.
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
  int refined = 0;      ///< times that it was refined again after a failure
  bool queued = false;  ///< its mission waits for its insertion
  std::string done;     ///< of it, in words: by tasks that are over
  /// Planned to need no tasks: it is true when its turn comes, if the vehicle is there.
  std::optional<Whereabouts> true_at;
  MissionTime settled;      ///< when, of one that is
  bool tasks_gone = false;  ///< let go, of one that is

  /// It is to come to an end here: it is not settled, and the ground station does not have it.
  bool open() const { return !is_settled(state) && state != GoalState::kHandedOver; }
};

/// A task of the executive that is of no goal: a safe wait, or somebody else's.
struct Loose {
  std::string type;
  bool ours = false;
  bool holds_vehicle = false;
  bool stopping = false;    ///< told to by us
  bool ran = false;         ///< the vehicle took it
  bool begun = false;       ///< its executive started it
  bool leads_away = false;  ///< an operator's: where the vehicle is once it is over, nobody knows
};

/// True for a task whose way to end is being told so: it never counts as ended for the executive.
bool ends_by_order(const mission::ElementaryTask& task);

/// True when the task waits of the other one that it has ended well, or runs.
bool depends_on(const mission::ElementaryTask& task, TaskId other);

/// Goals in the order of the high-level plan, tasks by id.
class Book {
 public:
  std::map<GoalId, Goal> goals;
  ByteBook past;  ///< 1 for goals of which nothing else is known any more
  std::vector<GoalId> order;
  std::map<TaskId, Entry> tasks;
  std::map<TaskId, Loose> loose;  ///< those that are not over
  ByteBook forgotten;             ///< 1 for loose ones that are over
  Meetings meetings;              ///< what is known of those whom the UAV is to meet
  TaskId next_id{1};
  bool more_settled = false;  ///< goals, since the past was last let go

  /// Whether there ever was a goal of that number.
  bool knows(GoalId id) const { return goals.contains(id) || past.knows(id.value()); }
  Entry* find(TaskId id);
  const Entry* find(TaskId id) const;

  /// Live tasks of the goal, by id.
  std::vector<const Entry*> of(GoalId goal) const;
  bool has_in_hand(GoalId goal) const;
  bool is_wholly_given(GoalId goal) const;
  bool is_given(GoalId goal) const;  ///< some live task of it is, or was, with the executive
  bool is_planned(GoalId goal) const;
  bool was_begun(GoalId goal) const;  ///< some task of it, withdrawn or not, has started
  bool has_lost(GoalId goal) const;   ///< some live task of it was aborted

  /// What the executive has of ours and keeps.
  std::vector<TaskId> in_hand() const;
  bool nothing_in_hand() const;
  Standing standing(const std::set<TaskId>& but = {}) const;
  /// In hand, or planned to be: live, not over, and nobody else decides on it.
  bool counts(const Entry& entry) const;
  /// Those that count.
  std::vector<mission::ElementaryTask> open_tasks() const;

  /// Goals that are to be done, are not queued and not with the executive: those that a job may
  /// plan anew; in order. A goal without tasks counts as given when one behind it is.
  std::vector<GoalId> free_goals() const;
  /// Bounds after goals, of all that are not settled and of `more`, that are not in the book; and
  /// what is known of meetings.
  GoalBounds bounds(const std::vector<mission::HighLevelTask>& more = {}) const;
  std::vector<mission::HighLevelTask> tasks_of(const std::vector<GoalId>& ids) const;

  /// Tasks that the executive never counts as ended.
  std::set<TaskId> ending_by_order() const;
  /// The goals that lose what they wait for when these do.
  std::set<GoalId> falling_with(std::set<GoalId> goals) const;
  /// Tasks of the executive that hold the vehicle, are not over, and that the plan does not order:
  /// withdrawn ones, what others gave, and waits for orders that come before the task `next`.
  std::set<TaskId> loose_motion(TaskId next) const;
  /// Likewise, those that use the device.
  std::set<TaskId> loose_users_of(const std::string& device) const;
  /// An operator's task is not over after which the vehicle is elsewhere.
  bool is_led_away() const;
  /// Open-ended tasks that wait for orders and are not over.
  std::vector<const Entry*> waits_for_orders() const;
  /// Something that is to go on is under way, or moves or holds the vehicle and begins by `soon`,
  /// as far as is known: what it hovers, or circles, for.
  bool has_occupation(MissionTime soon) const;
  /// While nothing that holds the vehicle is under way: a task of others that may not begin yet and
  /// that the plan waits for.
  std::optional<TaskId> in_the_way() const;
  /// A landing was stopped and is not over: too low, it goes on to the ground.
  bool stops_landing() const;
  /// A safe wait goes on.
  bool waits_safely() const;
  /// All that it waits for has come.
  bool is_due(const Entry& entry) const;

  /// The parts of that mapping, in the order of their numbers.
  std::vector<GoalId> parts_of(GoalId whole) const;
  /// What the parts that are planned leave to their mappings, as those are planned now.
  void note_parts();

  /// "goal 702 (perform-detection Z2 P2 300)".
  std::string named(GoalId goal) const;

  /// A task of no goal, for the executive: a safe wait, a landing at once. Returns its number.
  TaskId add_loose(const std::string& type);
  void enter(const mission::ElementaryPlan& plan);
  /// These goals lose their tasks. Returns those that the executive has to be told to stop, the
  /// highest id first; what was only planned is forgotten.
  std::vector<TaskId> withdraw(const std::set<GoalId>& from);
  /// Puts them first in the order, and gives all in it. Cost: a look-up each.
  std::vector<const Goal*> goals_settled_first();
  /// Settled ones first, then `wanted`, then what `wanted` does not name, as it was.
  void reorder(const std::vector<GoalId>& wanted);
};

}  // namespace skein::supervisor
