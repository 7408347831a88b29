// SPDX-License-Identifier: Apache-2.0
// The links of a task in the network of its plan, each with its meaning.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/supervisor/schedule.hpp"
#include "skein/temporal/live_network.hpp"

namespace skein::supervisor {

enum class BoundKind : std::uint8_t {
  kNow,         ///< an event that has not come yet is not in the past
  kFact,        ///< an observed date
  kDuration,    ///< the duration of the task
  kOrder,       ///< the task does not end before it starts
  kAfterEnd,    ///< it waits for the end of `other`
  kAfterStart,  ///< it waits for the start of `other`
  kWithin,      ///< it starts before the end of `other`
  kBeforeStop,  ///< it starts before the event of `other` that stops it
  kStop,        ///< it ends with the event of `other` that stops it
  kStartAfter,  ///< time constraints
  kStartBefore,
  kEndAfter,
  kEndBefore,
  kAfterGoal,  ///< bound on its start or end after the end of `other`, or of an achieved goal
  kPartner,    ///< it ends, or begins, after the arrival of partners
  kNeeded,     ///< it starts before the date at which partners need it
};

/// A bound after a goal, expressed on a task.
struct TaskBound {
  mission::GoalBound bound;
  executive::TaskId other;  ///< TaskId(): the goal was achieved at `over`
  MissionTime over;
  bool operator==(const TaskBound&) const = default;
};

/// A task's meeting with partners, in the network.
struct Encounter {
  temporal::PartnerDates with;
  bool at_start = false;  ///< a joint task begins when all have come; others end then
  bool for_air = false;   ///< a motion that was started and flies once partners left its air
  Meetings::Reliance reliance = Meetings::Reliance::kOnNothing;
  bool awaits() const { return !with.last.empty(); }
  bool operator==(const Encounter&) const = default;
};

/// A task with its observation and its bounds; refers to a task that the caller owns.
struct TaskView {
  const mission::ElementaryTask* task = nullptr;
  Observation seen;
  std::vector<TaskBound> bounds = {};
  std::optional<Encounter> encounter = {};
};

/// A task that meets other UAVs, for the team's common network.
struct PlanMeeting {
  temporal::Meeting what;
  bool at_start = false;  ///< as in Encounter
};
std::optional<PlanMeeting> meeting_of(const mission::ElementaryTask& task);

/// One side of a precedence between motions in the same air, for the team's common network.
struct PlanOrder {
  executive::TaskId task;  ///< the motion that waits, or at whose end the air is left
  temporal::Meeting what;
  bool waits = false;  ///< it waits; else it leaves
};

/// Sets `bounds` and `encounter` of each task. A bound after a goal that has no tasks here and was
/// not achieved is ignored.
void relate(std::vector<TaskView>& tasks, const GoalBounds& bounds);

/// The meaning of a link.
struct Cause {
  executive::TaskId task;
  BoundKind kind = BoundKind::kNow;
  executive::TaskId other;
  MissionTime instant;        ///< of kFact and time constraints
  std::uint32_t part = 0;     ///< distinguishes links with the same meaning
  mission::GoalId goal = {};  ///< of kAfterGoal
  std::string who = {};       ///< of kPartner, kNeeded
  bool operator==(const Cause&) const = default;
};
temporal::LinkName name_of(const Cause& cause);
/// Cause::part of a kPartner link about leaving air.
inline constexpr std::uint32_t kAirPart = 2;

struct PlanLink {
  Cause cause;
  temporal::LiveLink link;
};

inline temporal::NodeName start_of(executive::TaskId task) { return {0, 2 * task.value()}; }
inline temporal::NodeName end_of(executive::TaskId task) { return {0, 2 * task.value() + 1}; }
/// When this UAV alone would be ready to begin a joint task; only in its frontier.
inline temporal::NodeName ready_of(executive::TaskId task) { return {2, task.value()}; }
/// When the task's partners have all come, or have left the air for which it waits.
inline temporal::NodeName others_at(executive::TaskId task) { return {1, task.value()}; }
/// When this UAV has left the air that another one waits for; only in its frontier.
inline temporal::NodeName left_of(temporal::MeetingId order) { return {3, order}; }
/// The present: a node at a fixed date, which no future event may precede.
inline constexpr temporal::NodeName kPresent{0xFFFFFFFF, 1};

/// Least duration of a contingent link (1 ms).
inline constexpr temporal::Ticks kInstant = 1'000'000;

/// The instant in ticks, clamped to the horizon of 13 days.
temporal::Ticks ticks_of(MissionTime instant);
/// Whether the instant counts as unbounded.
inline bool is_never(MissionTime instant) {
  return ticks_of(instant) >= ticks_of(MissionTime::max());
}

/// The observation of a task of the network; null: the task is not in the network.
using SeenOf = std::function<const Observation*(executive::TaskId)>;

/// The links of one task, by the rules of schedule.hpp.
std::vector<PlanLink> links_of(const TaskView& view, MissionTime now, const SeenOf& seen);

/// Whether no link bounds the task's end from above: it is open-ended, or has exceeded its greatest
/// duration, or waits for a partner without known date.
bool is_endless(const TaskView& view, MissionTime now);

}  // namespace skein::supervisor
