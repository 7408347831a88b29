// SPDX-License-Identifier: Apache-2.0
// The supervisor of the deliberative layer: the conductor of planner, refiners, interaction manager
// and executive.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/supervisor/deliberation.hpp"
#include "skein/temporal/team_dates.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::supervisor {

// ---- inputs ----

/// Operator 0: a user adds a unit mission.
struct AddMission {
  mission::UnitMission mission;
};
/// Operators 0 and 2: a user cancels or interrupts high-level tasks.
struct CancelMission {
  mission::CancelGoals goals;
  std::string asked_by;
};
/// The operator lowers the degree, or the contact-loss policy takes over: the supervisor stops
/// deciding. Tasks that it has not given to the executive are handed over (HandedOver).
struct Disengage {
  std::string cause;  ///< "degree 3 by operator", "contact lost: hold"
};
/// The UAV is at degree 4 (again): the supervisor decides. With `resume`, high-level tasks that
/// were handed over and are not settled are planned again from the present state.
struct Engage {
  bool resume = true;
  std::string cause;
  /// The tasks that the executive has and that are not over. Absent: all that it was given. Other
  /// tasks were taken over by somebody else and count as lost.
  std::optional<std::vector<executive::TaskId>> in_executive = std::nullopt;
  /// Tasks under way that another executive has, and will give back unless it is not heard. Nothing
  /// of the plan is given before they are here or over, but for a few seconds at most.
  std::vector<executive::TaskId> elsewhere = {};
};
struct WorldChanged {
  mission::ChangeWorld change;
};
/// The executive reported a state of a task; also of tasks that others gave it.
struct TaskSeen {
  executive::TaskEvent event;
  /// A wait without end: its executive ends it when another task that needs the vehicle begins.
  bool gives_way = false;
};
/// The executive answered a request of the supervisor.
struct RequestAnswered {
  executive::Reply reply;
};
struct VehicleSeen {
  world::VehicleState state;
  std::vector<std::string> failed;  ///< devices that do not work
};
struct JobFinished {
  std::uint64_t job = 0;
  DeliberationResult result;
};
/// The executive wants a joint task carried out, or interrupted.
struct JointTaskDue {
  executive::TaskId task;
  bool interrupt = false;  ///< it is to be interrupted
};
/// The interaction manager's answer to LoadJointTask.
struct JointTaskAnswered {
  executive::TaskId task;
  bool loaded = false;
  mission::Interval agreed;  ///< start, relative to mission time zero; if loaded
  std::string why;           ///< why it is not loaded
  /// Duration and energy of the UAV's role along its nominal path.
  struct Takes {
    Duration expected;
    double energy = 0;  ///< expected, as a fraction of the full capacity
  };
  std::optional<Takes> takes = {};
};
/// When partners come to the UAV's meetings, as far as their plans are known. Replaces what was
/// known before.
struct PartnersSeen {
  std::map<temporal::MeetingId, temporal::PartnerDates> meetings;
};
/// The precedences between this UAV's motions and others' in the same air changed.
struct OrdersSeen {
  AirOrders orders;
};
/// There may have been a life before this one, of which nothing is known here: what is numbered
/// from now on begins at a number by the instant, which that life did not come to. A vehicle tells
/// of a task that it knows how that ended, and does not do it again.
struct LivesAgain {};
struct Tick {};

using Input = std::variant<AddMission, CancelMission, Disengage, Engage, WorldChanged, TaskSeen,
                           RequestAnswered, VehicleSeen, JobFinished, JointTaskDue,
                           JointTaskAnswered, PartnersSeen, OrdersSeen, LivesAgain, Tick>;

// ---- effects ----

/// The answer to AddMission, CancelMission or WorldChanged, in the same call, with every reason of
/// a refusal.
struct Answer {
  bool accepted = true;
  std::vector<std::string> reasons;
};
/// An accepted mission was planned, or turned out to have no plan.
struct MissionDecided {
  mission::MissionOutcome outcome;
};
/// START, ABORT or UPDATE-COND for the executive; or the status of a joint task.
struct ToExecutive {
  executive::Input input;
};
/// Run deliberate(request) as a job and return its result as JobFinished. The request is shared, so
/// that a job costs no copy.
struct StartDeliberation {
  std::uint64_t job = 0;
  std::shared_ptr<const DeliberationRequest> request;
};
/// The result of this job is no longer wanted: it may end at once with any result, which still
/// comes back as JobFinished.
struct StopDeliberation {
  std::uint64_t job = 0;
};
/// The plan, its dates or the state of a high-level task changed. At most one in a call.
struct PlanChanged {
  mission::PlanReport report;
};
struct GoalChanged {
  mission::GoalStatus status;
};
/// An operator was applied.
struct Decided {
  mission::Decision decision;
};
/// The tasks that the executive did not have when the supervisor was disengaged, with the
/// conditions that they would have been given with.
struct HandedOver {
  std::vector<mission::HeldTask> tasks;
};
/// A task of the plan is over, without success, though no executive says so: the one that had it
/// did not give it back in time. Whoever watches tasks is to hear it.
struct NotGivenBack {
  executive::TaskEvent event;
};
/// Operator 4: the interaction manager is to load a joint task. Without preferences: the task is no
/// longer wanted.
struct LoadJointTask {
  mission::ElementaryTask task;
  std::vector<mission::Interval>
      preferences;  ///< starts, relative to mission time zero; best first
};
/// The part of the plan's network that partners need to know changed. Empty: the supervisor is
/// disengaged.
struct FrontierChanged {
  temporal::Frontier frontier;
};
/// For the log.
struct Notice {
  std::string text;
};

using Effect = std::variant<Answer, MissionDecided, ToExecutive, StartDeliberation,
                            StopDeliberation, PlanChanged, GoalChanged, Decided, HandedOver,
                            NotGivenBack, LoadJointTask, FrontierChanged, Notice>;
using Effects = std::vector<Effect>;

struct Config {
  std::shared_ptr<const Knowledge> knowledge;
  std::shared_ptr<const world::World> world;
  /// Commitment horizon: a high-level task is given to the executive when it may start within this
  /// time.
  Duration horizon = Duration::seconds(15);
  /// By how much a task may exceed its greatest duration before that is a contingency.
  Duration grace = Duration::seconds(1);
  /// Partners are sent the whole network of the plan instead of its reduction to the meetings.
  bool tells_all = false;
  int refinements = 2;            ///< how often a failed high-level task is refined again
  executive::TaskId first_id{1};  ///< of the first elementary task
};

/// Keeps the plan of one UAV at degree 4: accepts missions, has them planned as jobs, gives tasks
/// to the executive as they come near, watches their execution, and repairs the plan. Requests are
/// answered in the same call, whatever job runs; one job runs at a time, others wait for its end,
/// and a job whose premises no longer hold when its result comes is run again.
///
/// Laws: tasks that the executive has are revised only on explicit requests of users and by repair.
/// A high-level task is achieved when all its elementary tasks have ended, and fails with the first
/// one that is aborted and not replaced. While the supervisor is engaged and the UAV in the air,
/// the UAV has a task; if the plan gives it none, the effects say so and start a safe wait.
///
/// The supervisor is disengaged until the first Engage; inputs before it count. Before it has given
/// its first task, it only reports by a Notice that the UAV flies without a task.
///
/// The host carries out all effects of a call in their order, and only then passes in the inputs
/// that result from them, in the order in which they arose.
///
/// `now` never decreases. Deterministic. Not safe to share between threads. Source: T IV.4, spec 6.
class Supervisor {
 public:
  explicit Supervisor(Config config);
  ~Supervisor();
  Supervisor(Supervisor&&) noexcept;
  Supervisor& operator=(Supervisor&&) noexcept;

  Effects handle(const Input& input, MissionTime now);
  std::optional<MissionTime> next_wakeup() const;

  bool engaged() const;
  const mission::PlanReport& report() const;
  /// The world as the supervisor believes it to be, at any degree. The returned object is
  /// immutable; a change of belief makes a new one.
  std::shared_ptr<const world::World> world() const;
  /// Whether the UAV looks, or will with tasks that the executive has, at the place from where it
  /// would be hidden by the ground if it were there now. The host need not tell every move of a
  /// place, but this one.
  bool loses_sight_of(const std::string& place, const world::Vector3& now) const;
  /// Whether the task is of the plan and over, as far as is known here: it ended, or another
  /// executive did not give it back in time. Nobody is to begin it any more.
  bool has_given_up(executive::TaskId task) const;
  /// Absent: no such goal is known.
  std::optional<mission::HighLevelTask> goal(mission::GoalId id) const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::supervisor
