// SPDX-License-Identifier: Apache-2.0
// A plan as a temporal network with uncertainty (STNU): whether it is consistent and dynamically
// controllable, and between which dates each task starts and ends.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/mission/elementary_plan.hpp"
#include "skein/temporal/team_dates.hpp"

namespace skein::supervisor {

/// What the executive reported of a task.
struct Observation {
  std::optional<MissionTime> started;  ///< dispatched
  std::optional<MissionTime> over;     ///< ended or aborted
  bool aborted = false;
  bool operator==(const Observation&) const = default;
};
using Observations = std::map<executive::TaskId, Observation>;

/// A bound that makes the network inconsistent or uncontrollable, and the task it belongs to.
struct Conflict {
  executive::TaskId task;
  std::string why;  ///< "ends no earlier than 431 s, must end before 400 s"
  bool operator==(const Conflict&) const = default;
};

/// Longest time from the event that stops a task to the task's end.
inline constexpr Duration kStopReaction = Duration::milliseconds(1000);
/// A task that must start while another one runs starts at least this long before the other's end:
/// if both come at one instant, the executive may see the end first.
inline constexpr Duration kStartMargin = Duration::milliseconds(1);

/// An additional wait of a task whose own conditions hold, as the network's execution strategy asks
/// for it: if the task started earlier, tasks bounded from above by its start might be late. The
/// task may start once `on` is over or `until` is past, whichever comes first.
struct Hold {
  executive::TaskId on;  ///< TaskId(): none, only `until` counts
  MissionTime until;     ///< MissionTime::max(): no date known yet, only the end of `on` counts
  bool operator==(const Hold&) const = default;
};
using Holds = std::map<executive::TaskId, std::vector<Hold>>;

/// Precedences between motions of this UAV and of others in the same air, by plan merging (spec
/// 6.4).
struct AirOrders {
  std::string uav;                         ///< the name of this UAV
  std::optional<executive::TaskId> waits;  ///< the own motion that waits for its air
  std::vector<std::string> for_others;     ///< the UAVs that have to leave that air
  std::optional<executive::TaskId> flies;  ///< the own motion under way
  /// UAVs that wait until this UAV has left the air of motion `flies`, or the place where it stays
  /// after that motion.
  std::vector<std::string> for_its_way, for_its_place;
  bool operator==(const AirOrders&) const = default;
};

/// What is known of the partners' plans for meetings (synchronisations, joint tasks, air to be
/// left), by id. A synchronisation without an entry takes as long as the domain says.
struct Meetings {
  /// How optimistic the network is about partners, from the least on. A plan breaks because of
  /// partners only if it breaks under every level.
  enum class Reliance : std::uint8_t {
    kOnNothing,     ///< partners come as late as they may
    kOnTheirBest,   ///< partners come as early as they can
    kNobodysNeeds,  ///< the same, and deadlines that partners need of this UAV are dropped
  };
  std::map<temporal::MeetingId, temporal::PartnerDates> of;
  Reliance reliance = Reliance::kOnNothing;
  AirOrders air = {};  ///< the dates at which others leave the air are in `of`, too
  bool operator==(const Meetings&) const = default;
};

/// Bounds between high-level tasks, and with other UAVs, for the dates of elementary tasks.
struct GoalBounds {
  std::map<mission::GoalId, std::vector<mission::GoalBound>> of;  ///< by the bounded task
  std::map<mission::GoalId, MissionTime> over;  ///< achieved high-level tasks, and when
  Meetings meetings;
  bool operator==(const GoalBounds&) const = default;
};

struct Schedule {
  bool consistent = false;
  /// Dynamically controllable: all constraints are kept for any contingent durations, if each task
  /// starts as early as its conditions and its holds allow. Implies consistent.
  bool controllable = false;
  std::vector<Conflict> conflicts;  ///< empty iff controllable
  /// Time windows of the network: a start or an end outside its window violates a constraint.
  /// `latest` is unbounded unless an absolute constraint propagates back to the task. If
  /// controllable, earliest dates are those with all contingent durations least, latest dates those
  /// with all greatest; else the windows are those of the network with all durations controllable.
  /// Empty unless consistent.
  std::map<executive::TaskId, mission::TaskDates> dates;
  /// Forecast: dates at which tasks start and end if the executive starts each as early as its
  /// conditions and holds allow; `latest` with all durations greatest, unbounded behind a task
  /// without greatest duration. To be shown to people and compared with promised dates. Empty
  /// unless consistent.
  std::map<executive::TaskId, mission::TaskDates> foreseen;
  /// Of tasks that have not started; of a controllable network only.
  Holds holds;
  /// When the last task ends, by `foreseen`; MissionTime() without tasks or unless consistent.
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
///                              one event, start <= event and end <= event + kStopReaction
///   time constraints           start, end against mission time zero; end_after with a stop: the
///                              stop waits for it too
///   bound after a goal         start, or end, of each task of the bounded goal against the last
///                              end of the other goal, or the instant when that was achieved
///   waits for its air          its duration begins when the last UAV has left the air, which is
///                              contingent
///   meeting with others        end >= arrival of the last partner, contingent; the duration does
///                              not count. Start <= the date at which partners need this UAV there
///   not started                start >= now
///   under way                  start at its date; the rest of the duration, but end >= now. Longer
///                              than its most: end >= now, without an upper bound from its duration
///   over                       start and end at their dates, nothing else: observed dates break
///                              no constraint
///
/// Instants beyond 13 days from mission time zero, and such durations, count as unbounded.
///
/// Cost: a check of dynamic controllability, a few milliseconds for 300 tasks; in flight an
/// incremental network is used instead (plan_network.hpp). Precondition: ids differ. A dependence
/// on a task that is not among `tasks` counts as met.
Schedule schedule(const std::vector<mission::ElementaryTask>& tasks, const Observations& seen,
                  MissionTime now, const GoalBounds& bounds = {});

}  // namespace skein::supervisor
