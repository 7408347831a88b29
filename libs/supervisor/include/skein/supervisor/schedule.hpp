// SPDX-License-Identifier: Apache-2.0
// A plan as a temporal network with uncertainty: is it consistent and dynamically controllable, and
// between which dates does each task start and end?
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/temporal/team_dates.hpp"

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
/// What is to start while a task runs starts this long before its end: at one and the same instant
/// the executive may see the end first.
inline constexpr Duration kStartMargin = Duration::milliseconds(1);

/// What holds a task back though all it waits for has come: were it to start, what must start while
/// it runs might come too late. It starts when `on` is over, or when `until` is past.
struct Hold {
  executive::TaskId on;  ///< TaskId(): on time alone
  MissionTime until;     ///< MissionTime::max(): no date is known yet, only the end of `on` counts
  bool operator==(const Hold&) const = default;
};
using Holds = std::map<executive::TaskId, std::vector<Hold>>;

/// Orders between the way of this UAV and others' (spec 6.4).
struct AirOrders {
  std::string uav;                         ///< this one
  std::optional<executive::TaskId> waits;  ///< the motion that waits for its air
  std::vector<std::string> for_others;     ///< to leave it
  std::optional<executive::TaskId> flies;  ///< the motion under way
  /// Others who wait for this UAV to leave: the air of that motion, or where it stays after it.
  std::vector<std::string> for_its_way, for_its_place;
  bool operator==(const AirOrders&) const = default;
};

/// What is known of synchronisations with other UAVs, by their ids. Without it each takes as long
/// as the domain says.
struct Meetings {
  /// What of it counts. What others may do to a plan in force, or to one that is asked for, breaks
  /// it only when it is certain.
  enum class Reliance : std::uint8_t {
    kOnNothing,     ///< they come as late as they may
    kOnTheirBest,   ///< they come as early as they can
    kNobodysNeeds,  ///< likewise, and this UAV is nowhere for another's sake
  };
  std::map<temporal::MeetingId, temporal::PartnerDates> of;
  Reliance reliance = Reliance::kOnNothing;
  AirOrders air = {};  ///< of which others' leaving is in `of`, too
  bool operator==(const Meetings&) const = default;
};

/// What is known of bounds between high-level tasks, and with others, when their elementary tasks
/// are dated.
struct GoalBounds {
  std::map<mission::GoalId, std::vector<mission::GoalBound>> of;  ///< by the one that is bounded
  std::map<mission::GoalId, MissionTime> over;  ///< high-level tasks that were achieved, and when
  Meetings meetings;
  bool operator==(const GoalBounds&) const = default;
};

struct Schedule {
  bool consistent = false;
  /// Dynamically: whatever durations nature chooses, each task started as early as its conditions
  /// and its holds allow. Implies consistent.
  bool controllable = false;
  std::vector<Conflict> conflicts;  ///< empty iff controllable
  /// Windows of the network: what is outside them breaks it. `latest` is unbounded unless some
  /// absolute constraint reaches back to the task. When controllable, a window is what is left of
  /// it in every course of nature (earliest dates with all durations least, latest with all
  /// greatest); else that of the network with durations of one's choice. Empty unless consistent.
  std::map<executive::TaskId, mission::TaskDates> dates;
  /// What will come: dates at which tasks start and end when the executive starts each as early as
  /// its conditions and holds allow; `latest` with all durations greatest, unbounded after what has
  /// no greatest duration. To be shown to people and compared with promises. Empty unless
  /// consistent.
  std::map<executive::TaskId, mission::TaskDates> foreseen;
  /// Of tasks that have not started; of a controllable network only.
  Holds holds;
  /// When the last task ends, as foreseen; MissionTime() without tasks or unless consistent.
  MissionTime earliest_end, latest_end;
};

/// Verdict and dates of the network of the tasks at `now`: mission time zero, and a start and an
/// end of each task. Source: T IV.4.1, spec 5.2, 6.1.
///
///   duration [least, most]     contingent when 0 < least < most < ∞ (least 0: 1 ms); [d, d] fixed;
///                              else, or open-ended, at least `least`
///   ENDED j, OVER j            start >= end of j
///   RUNNING j                  start of j <= start <= end of j - kStartMargin (0 once j started)
///   stop                       end >= every event waited for; the duration does not count. With
///   one
///                              event, start <= event and end <= event + kStopReaction
///   time constraints           start, end against mission time zero; end_after with a stop: the
///                              stop waits for it too
///   bound after a goal         start, or end, of each task of the one against the last ends of the
///                              other, or against the instant when that was achieved
///   waits for its air          flies once the last of those who have it has left it: contingent,
///   its
///                              duration after that
///   meeting with others        end >= when the last of them comes, contingent; the duration does
///                              not count. Start <= when the others need it there
///   not started                start >= now
///   under way                  start at its date; what is left of the duration, at least until
///   now;
///                              longer than its most: end >= now, without bound from its duration
///   over                       start and end at their dates, nothing else: facts break nothing
///
/// Instants beyond 13 days from mission time zero, and such durations, count as unbounded.
///
/// Cost: a check of dynamic controllability, a few milliseconds for 300 tasks; in flight the
/// network is kept instead (plan_network.hpp). Precondition: ids differ. A dependence on a task
/// that is not among `tasks` counts as met.
Schedule schedule(const std::vector<mission::ElementaryTask>& tasks, const Observations& seen,
                  MissionTime now, const GoalBounds& bounds = {});

}  // namespace skein::supervisor
