// SPDX-License-Identifier: Apache-2.0
// What a task asks of the network of its plan: links, each with what it is about.
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
  kNow,         ///< the present: neither started before, nor over
  kFact,        ///< a date that was seen
  kDuration,    ///< how long the task may take
  kOrder,       ///< it does not end before it starts
  kAfterEnd,    ///< it waits for the end of `other`
  kAfterStart,  ///< it waits for the start of `other`
  kWithin,      ///< it starts before the end of `other`
  kBeforeStop,  ///< it starts before what stops it, of `other`
  kStop,        ///< it ends with what stops it, of `other`
  kStartAfter,  ///< time constraints
  kStartBefore,
  kEndAfter,
  kEndBefore,
  kAfterGoal,  ///< it starts, or ends, so long after the end of `other`, or of a goal that is over
  kPartner,    ///< others come to meet it, and it ends, or begins, after that
  kNeeded,     ///< others need it there
};

/// A bound after a goal, as the network has it.
struct TaskBound {
  mission::GoalBound bound;
  executive::TaskId other;  ///< TaskId(): the goal was achieved at `over`
  MissionTime over;
  bool operator==(const TaskBound&) const = default;
};

/// What the network has of those whom a task meets.
struct Encounter {
  temporal::PartnerDates with;
  bool at_start = false;  ///< a joint task begins with them; else it ends when they have come
  bool for_air = false;   ///< it was started, and flies once they have left its air
  Meetings::Reliance reliance = Meetings::Reliance::kOnNothing;
  bool awaits() const { return !with.last.empty(); }
  bool operator==(const Encounter&) const = default;
};

/// A task and what was seen of it, as somebody else keeps them.
struct TaskView {
  const mission::ElementaryTask* task = nullptr;
  Observation seen;
  std::vector<TaskBound> bounds = {};
  std::optional<Encounter> encounter = {};
};

/// What a task does with other UAVs, in their common network.
struct PlanMeeting {
  temporal::Meeting what;
  bool at_start = false;  ///< a joint task: it begins with them; else it ends when they have come
};
std::optional<PlanMeeting> meeting_of(const mission::ElementaryTask& task);

/// Part of an order between ways, in their common network.
struct PlanOrder {
  executive::TaskId task;  ///< the motion that waits, or with whose end the air is left
  temporal::Meeting what;
  bool waits = false;
};

/// Gives the tasks their bounds after goals, and what is known of those they meet. A goal that has
/// no tasks here and was not achieved bounds nothing.
void relate(std::vector<TaskView>& tasks, const GoalBounds& bounds);

/// What a link is about.
struct Cause {
  executive::TaskId task;
  BoundKind kind = BoundKind::kNow;
  executive::TaskId other;
  MissionTime instant;        ///< of kFact and time constraints
  std::uint32_t part = 0;     ///< tells links apart that are about the same
  mission::GoalId goal = {};  ///< of kAfterGoal
  std::string who = {};       ///< of kPartner, kNeeded
  bool operator==(const Cause&) const = default;
};
temporal::LinkName name_of(const Cause& cause);
/// The part of a kPartner that is about leaving air.
inline constexpr std::uint32_t kAirPart = 2;

struct PlanLink {
  Cause cause;
  temporal::LiveLink link;
};

inline temporal::NodeName start_of(executive::TaskId task) { return {0, 2 * task.value()}; }
inline temporal::NodeName end_of(executive::TaskId task) { return {0, 2 * task.value() + 1}; }
/// When this UAV could begin a joint task, were it not for the others: of its frontier only.
inline temporal::NodeName ready_of(executive::TaskId task) { return {2, task.value()}; }
/// When the others have come whom the task meets, or have left the air for which it waits.
inline temporal::NodeName others_at(executive::TaskId task) { return {1, task.value()}; }
/// When this UAV has left the air that another waits for: of its frontier only.
inline temporal::NodeName left_of(temporal::MeetingId order) { return {3, order}; }
/// The present: a node at a fixed date, which nothing that has not come may precede.
inline constexpr temporal::NodeName kPresent{0xFFFFFFFF, 1};

/// The least that nature takes for anything.
inline constexpr temporal::Ticks kInstant = 1'000'000;

/// An instant as the network has it: beyond the horizon of 13 days counts as the horizon.
temporal::Ticks ticks_of(MissionTime instant);
/// It stands for what never comes.
inline bool is_never(MissionTime instant) {
  return ticks_of(instant) >= ticks_of(MissionTime::max());
}

/// What was seen of a task of the network; null: it is not there.
using SeenOf = std::function<const Observation*(executive::TaskId)>;

/// Those of one task, by the rules of schedule.hpp.
std::vector<PlanLink> links_of(const TaskView& view, MissionTime now, const SeenOf& seen);

/// No figure bounds its end from above: it is open-ended, or under way for longer than foreseen, or
/// waits for who comes at no known date.
bool is_endless(const TaskView& view, MissionTime now);

}  // namespace skein::supervisor
