// SPDX-License-Identifier: Apache-2.0
// A plan as a temporal network with uncertainty: is it consistent and dynamically controllable, and
// between which dates does each task start and end?
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/temporal/network.hpp"

namespace skein::supervisor {

/// What was seen of a task that the executive has.
struct Observation {
  std::optional<MissionTime> started;  ///< dispatched
  std::optional<MissionTime> over;     ///< ended or aborted
  bool aborted = false;
  bool operator==(const Observation&) const = default;
};
using Observations = std::map<executive::TaskId, Observation>;

/// A bound that breaks the network, put back to the task it is of.
struct Conflict {
  executive::TaskId task;
  std::string why;  ///< "ends no earlier than 431 s, must end before 400 s"
  bool operator==(const Conflict&) const = default;
};

/// Within this time the end of a task follows what stops it.
inline constexpr Duration kStopReaction = Duration::milliseconds(1000);

struct Schedule {
  bool consistent = false;
  /// Dynamically, and by starting each task as early as it may be, as the executive does; implies
  /// consistent.
  bool controllable = false;
  std::vector<Conflict> conflicts;  ///< empty iff controllable
  /// Windows of the network: what is outside them breaks it. `latest` is unbounded unless some
  /// absolute constraint reaches back to the task. When controllable, a window is what is left of
  /// it in every course of nature (earliest dates with all durations least, latest with all
  /// greatest); else that of the network with durations of one's choice. Empty unless consistent.
  std::map<executive::TaskId, mission::TaskDates> dates;
  /// What will come: dates at which tasks start and end when the executive starts each as early as
  /// it may be; `latest` with all durations greatest, unbounded after what has no greatest
  /// duration. To be shown to people and compared with promises. Empty unless consistent.
  std::map<executive::TaskId, mission::TaskDates> foreseen;
  /// When the last task ends, as foreseen; MissionTime() without tasks or unless consistent.
  MissionTime earliest_end, latest_end;
};

/// The network of the tasks at `now`. Node 0 is mission time zero; each task has a start and an end
/// node ("103 start", "103 end"). Source: T IV.4.1, spec 5.2, 6.1.
///
///   duration [least, most]     contingent when 0 < least < most < ∞ (least 0: 1 ms); [d, d] fixed;
///                              else, or open-ended, at least `least`
///   ENDED j, OVER j            start >= end of j
///   RUNNING j                  start of j <= start <= end of j
///   stop                       end >= every event waited for; the duration does not count. With
///                              one event, start <= event and end <= event + kStopReaction; once
///                              that has come, end <= now + kStopReaction
///   time constraints           start, end against mission time zero; end_after with a stop: the
///                              stop waits for it too
///   not started                start >= now
///   under way                  start at its date; what is left of the duration, at least until
///   now;
///                              longer than its most: end >= now, without bound from its duration
///   over                       start and end at their dates, nothing else: facts break nothing
///
/// Instants beyond 13 days from mission time zero, and such durations, count as unbounded.
temporal::Stnu network_of(const std::vector<mission::ElementaryTask>& tasks,
                          const Observations& seen, MissionTime now);

/// Starting each task as early as it may be is a strategy of the executive that succeeds whenever
/// one does, but for one case: a task that must start while another runs, and waits for a third
/// that the other does not wait for. Such a plan is not controllable here unless the dates show
/// that the third is always over in time. Cost: a check of dynamic controllability, a few
/// milliseconds for 300 tasks. Precondition: ids differ. A dependence on a task that is not among
/// `tasks` counts as met.
Schedule schedule(const std::vector<mission::ElementaryTask>& tasks, const Observations& seen,
                  MissionTime now);

}  // namespace skein::supervisor
