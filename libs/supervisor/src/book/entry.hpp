// SPDX-License-Identifier: Apache-2.0
// An elementary task of a goal, and its stage between plan and executive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/functional/task_type.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/schedule.hpp"

namespace skein::supervisor {

using executive::TaskId;

/// In the first five stages a task counts for its goal ("live"). A task that was withdrawn, because
/// it was replaced or is no longer wanted, is in one of the others.
enum class Stage : std::uint8_t {
  kPlanned,  ///< the executive does not have it
  kGiven,    ///< the executive has it
  kOrdered,  ///< an open-ended task that was told to end, since orders have come
  kDone,     ///< over, and successful
  kLost,     ///< over, and not successful

  kDropped,    ///< withdrawn before it was given
  kWithdrawn,  ///< withdrawn; the executive has it and is to be told to abort it
  kStopping,   ///< withdrawn; the executive was told to abort it
  kPastDone,   ///< kDone, and withdrawn before or after
  kPastLost    ///< kLost, and withdrawn before or after
};
/// "planned", "given", …
std::string_view to_text(Stage stage);

/// A transition between stages.
enum class Step : std::uint8_t {
  kGive,      ///< the task was given to the executive, by the supervisor or by others
  kOrder,     ///< an open-ended task is told to end
  kWithdraw,  ///< the task no longer counts for its goal
  kStop,      ///< the executive was told to abort the task
  kEnd,       ///< the task ended
  kAbort,     ///< the task was aborted or refused, or somebody took it over
  kExcuse     ///< the abort turned out to be as planned: the task counts as done
};
std::string_view to_text(Step step);

/// The table of transitions; absent: `step` is impossible in `stage`.
std::optional<Stage> after(Stage stage, Step step);

/// Which delay of a task was reported already.
enum class Tardiness : std::uint8_t {
  kInTime,
  kLate,    ///< that it has not started in time
  kOverdue  ///< that it has not ended in time
};

struct Entry {
  mission::ElementaryTask task;
  mission::TaskDates window;    ///< Schedule::dates: outside of it a constraint is violated
  mission::TaskDates dates;     ///< Schedule::foreseen, as of now
  mission::TaskDates promised;  ///< `dates` when the plan was made or last shifted
  Observation seen;
  std::optional<MissionTime> running;               ///< since when it is running
  world::Vector3 seen_at = world::Vector3::Zero();  ///< the vehicle's position then [m, ENU]
  std::size_t passed = 0;  ///< way-points reached, after the first, of the motion flown along
  /// Of a perception along a patrol: how long the vehicle was seen during it, and how long of that
  /// the device had the zone in view.
  Duration watched, viewed;
  /// For the flight of a part of a mapping: the way-points, from its last one on, that are left to
  /// the mapping. Empty: the mapping is not planned to go on there.
  std::vector<world::Vector3> beyond = {};
  std::string why;                                              ///< of its abort
  executive::AbortCause cause = executive::AbortCause::kOther;  ///< of its abort
  std::vector<Hold> holds;                                      ///< last sent to the executive
  mission::TaskDates told_window;                               ///< last sent to the executive
  bool by_others = false;       ///< given by somebody else, with other conditions
  bool scheduled = false;       ///< an executive confirmed to have it
  bool was_held = false;        ///< it was given with holds
  bool unseen = false;          ///< taken over by somebody else: its outcome is unknown
  bool over_elsewhere = false;  ///< it ended at another executive, and was not given back
  bool told_when_back = false;  ///< it changed, or was stopped, while another executive had it
  Tardiness told = Tardiness::kInTime;

  Stage stage() const { return stage_; }
  /// Precondition: the table has this step.
  void advance(Step step);
  /// Records that the task was aborted. Precondition: the table has Step::kAbort here.
  void abort(MissionTime at) {
    seen.over = at;
    seen.aborted = true;
    advance(Step::kAbort);
  }

  bool given() const { return stage_ != Stage::kPlanned && stage_ != Stage::kDropped; }
  bool live() const { return stage_ < Stage::kDropped; }  ///< counts for its goal
  bool ordered() const { return stage_ == Stage::kOrdered; }
  /// The executive was told to abort it.
  bool stopping() const { return ordered() || stage_ == Stage::kStopping; }
  bool done() const { return stage_ == Stage::kDone || stage_ == Stage::kPastDone; }
  bool over() const { return done() || stage_ == Stage::kLost || stage_ == Stage::kPastLost; }
  /// The executive has it, and it counts.
  bool in_hand() const { return stage_ == Stage::kGiven || ordered(); }
  bool under_way() const { return in_hand() && seen.started.has_value(); }
  /// A motion that was started and has not run: the vehicle stays where it is until its air is
  /// reserved, and also when the motion is aborted before that.
  bool has_not_moved() const { return seen.started && !running && !done() && !task.way.empty(); }

 private:
  Stage stage_ = Stage::kPlanned;
};

}  // namespace skein::supervisor
