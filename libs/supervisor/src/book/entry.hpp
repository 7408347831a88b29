// SPDX-License-Identifier: Apache-2.0
// An elementary task of a goal, and how it stands between plan and executive.
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

/// The first five count for its goal. A task that is withdrawn from there, since it was made anew
/// or is not wanted any more, goes on in the others.
enum class Stage : std::uint8_t {
  kPlanned,  ///< the executive does not have it
  kGiven,    ///< the executive has it
  kOrdered,  ///< open-ended, and told to end: orders have come
  kDone,     ///< over as it should be
  kLost,     ///< over otherwise

  kDropped,    ///< withdrawn from kPlanned
  kWithdrawn,  ///< withdrawn from the executive, which is to be told to stop it
  kStopping,   ///< and was told
  kPastDone,   ///< kDone, and withdrawn before or since
  kPastLost    ///< kLost, likewise
};
/// "planned", "given", …
std::string_view to_text(Stage stage);

/// What makes one stage of another.
enum class Step : std::uint8_t {
  kGive,      ///< the executive has it, from us or from others
  kOrder,     ///< it is told to end
  kWithdraw,  ///< it counts no longer for its goal
  kStop,      ///< the executive was told to abort it
  kEnd,       ///< it ended
  kAbort,     ///< it was aborted or refused, or somebody took it over
  kExcuse     ///< it was aborted as it should be
};
std::string_view to_text(Step step);

/// The table of transitions. Nothing: this never happens there.
std::optional<Stage> after(Stage stage, Step step);

/// Whether a time that has passed without what was foreseen was dealt with.
enum class Tardiness : std::uint8_t {
  kInTime,
  kLate,    ///< it has not started
  kOverdue  ///< it has not ended
};

struct Entry {
  mission::ElementaryTask task;
  mission::TaskDates window;    ///< what is outside breaks the network
  mission::TaskDates dates;     ///< foreseen now
  mission::TaskDates promised;  ///< foreseen when the plan was made or last shifted
  Observation seen;
  std::optional<MissionTime> running;               ///< since when
  world::Vector3 seen_at = world::Vector3::Zero();  ///< where the vehicle was then
  std::size_t passed = 0;  ///< way-points behind the first, of the motion it perceives along
  /// Of the lanes of a part of a mapping: the way-points, from its last on, that it leaves to that.
  /// Empty: the mapping is not planned to go on there.
  std::vector<world::Vector3> beyond = {};
  std::string why;                                              ///< of its interruption
  executive::AbortCause cause = executive::AbortCause::kOther;  ///< likewise
  std::vector<Hold> holds;                                      ///< as the executive was told
  mission::TaskDates told_window;                               ///< likewise
  bool by_others = false;  ///< given by somebody else, with conditions of their own
  bool scheduled = false;  ///< an executive said that it has it
  bool was_held = false;   ///< it was given with something in `holds`
  bool unseen = false;     ///< lost to somebody else: nobody saw what became of it
  Tardiness told = Tardiness::kInTime;

  Stage stage() const { return stage_; }
  /// Precondition: the table has this step.
  void advance(Step step);
  /// It is over, and did not end. Precondition: as of Step::kAbort.
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
