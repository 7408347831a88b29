// SPDX-License-Identifier: Apache-2.0
// Inputs and effects of the ground station's components.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/foundation/id.hpp"
#include "skein/foundation/time.hpp"
#include "skein/functional/port.hpp"
#include "skein/ground_orders/alarm.hpp"
#include "skein/mission/autonomy.hpp"
#include "skein/mission/elementary_plan.hpp"
#include "skein/mission/high_level_task.hpp"
#include "skein/mission/request.hpp"
#include "skein/team/global_mission.hpp"
#include "skein/team/ownership.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::ground_station {

using mission::Degree;
using mission::Request;
using mission::runs_at_ground;
using mission::synchronises_directly;

/// Stages of a unit mission that are reported.
enum class MissionStage {
  kPlanned,   ///< the UAV has a plan for it
  kRefused,   ///< it was refused: by the ground, by the UAV, or because no plan has room for it
  kAchieved,  ///< none of its high-level tasks is open, none failed, one was achieved
  kFailed,    ///< none of them is open, and one failed
  kEvaluated  ///< asked for evaluation only: it could be planned (else refused)
};

/// Numbered from 1 in the order issued.
using CommandNumber = Id<struct CommandNumberTag, std::uint64_t>;

// ---- from the outside ----

/// Time passes.
struct Tick {};
/// The ground station is back with what it knew: nothing was heard until now, and what came
/// meanwhile is yet to be told. First input of such a life.
struct Resumed {};
/// The state of a vehicle, from the vehicle.
using TelemetryReceived = world::Telemetry;
/// A task of a UAV entered a state; reported by its MLE.
struct TaskEventReceived {
  std::string uav;
  executive::TaskId task;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
  std::string reason = {};
  bool at_ground = false;  ///< from the MLE that runs here for the UAV
};
/// The answer of a UAV's MLE to a command.
struct RequestReplyReceived {
  CommandNumber command;
  bool accepted = false;
  std::string why = {};
};
/// The command is with the UAV's decision node, which has not answered yet.
struct CommandDelivered {
  CommandNumber command;
};
/// The command could not be delivered in its lifetime.
struct CommandUndelivered {
  CommandNumber command;
};
/// The ground's radio contact with a UAV's decision node changed, as far as the ground knows.
struct PeerReachable {
  std::string uav;
  bool reachable = false;
  bool restarted = false;  ///< the node restarted and has no plan
};
struct PlannedTaskStatus {
  executive::TaskId task;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
};
/// Versions of interaction models, by type of joint task. Source: spec 7.3.
using ModelVersions = std::map<std::string, std::uint64_t>;

/// The plan that a UAV's decision node holds; makes up for lost events. Nodes at degree 1 hold
/// none.
struct PlanBoardReceived {
  std::string uav;
  Degree degree = 3;
  bool airborne = false;
  std::vector<PlannedTaskStatus> tasks;
  /// Time of this state; absent: now.
  std::optional<MissionTime> at = std::nullopt;
  ModelVersions models = {};  ///< interaction models that the UAV has
};
/// The plan of a UAV at degree 4, and the states of its high-level tasks.
struct MissionPlanReceived {
  std::string uav;
  mission::PlanReport plan;
  std::optional<MissionTime> at = std::nullopt;  ///< as in PlanBoardReceived
};
/// A UAV changed its degree and hands over its plan.
struct HandOverReceived {
  std::string uav;
  mission::HandOver hand_over;
  std::optional<MissionTime> at = std::nullopt;  ///< as in PlanBoardReceived
};
/// A UAV's supervisor applied an operator.
struct DecisionReceived {
  std::string uav;
  mission::Decision decision;
};
/// The outcome of a mission that a UAV had accepted for planning.
struct MissionOutcomeReceived {
  std::string uav;
  mission::MissionOutcome outcome;
};
/// The functional layer's answer to a request dispatched by the ground (degree 1).
struct FunctionalStatusReceived {
  std::string uav;
  executive::FunctionalStatus status;
};
/// A synchronisation message that the UAVs do not exchange directly: to be relayed or used here.
struct SyncReceived {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  executive::SyncWord word = executive::SyncWord::kThere;
  std::optional<MissionTime> said = std::nullopt;  ///< when it was sent; absent: now
};
/// An operator did the action `does`, for which OnOperator triggers wait.
struct OperatorActs {
  std::string does;
};
/// An operator's own request, outside of the script.
struct OperatorCommand {
  std::string uav;
  Request request;
  Duration lifetime = Duration::milliseconds(60'000);
};

// ---- between components, and to the outside ----

/// Ask MCS to send a request and to follow it until it is settled.
struct IssueCommand {
  std::string uav;
  Request request;
  MissionTime expires;
  std::string asked_by = {};  ///< for people: "step detection", "operator end"
  /// It belongs to a change of degree, and is sent before the commands that wait for that change.
  bool ahead = false;
};
/// Ask MCS to send a request to each UAV.
struct IssueToAll {
  Request request;
  MissionTime expires;
  std::string asked_by = {};
};
/// Ask MCS to take a UAV in hand (degree 1) or to give it back (to its previous degree).
struct ChangeHands {
  enum class Way { kTake, kGiveBack };
  std::string uav;
  Way way = Way::kTake;
  bool interrupt = false;  ///< with kTake: running tasks are interrupted
  MissionTime expires;
  std::string asked_by = {};
};
/// ResumeHeld: start the plan that a UAV handed over; DropHeld: discard it.
struct ResumeHeld {
  std::string uav;
  std::vector<executive::TaskId> without;  ///< tasks to discard
  MissionTime expires;
  std::string asked_by = {};
};
struct DropHeld {
  std::string uav;
};
/// All commands that belong to a change of degree have been issued: those waiting may be sent.
struct ReleaseCommands {
  std::string uav;
};
/// Ask MCS to abort all tasks that are not terminal or whose START is pending, highest id first.
struct AbortEverything {
  std::string uav;
  MissionTime expires;
  std::string asked_by = {};
};
enum class CommandState { kIssued, kDelivered, kAcknowledged, kRefused, kExpired };
/// "issued", "delivered", "acknowledged", "refused", "expired".
std::string_view to_text(CommandState state);
/// Whether the state is final.
constexpr bool is_settled(CommandState state) {
  return state != CommandState::kIssued && state != CommandState::kDelivered;
}

/// Send a request to a UAV's MLE. Idempotent by number: an MLE that has handled the number since
/// its start repeats its answer and does nothing. The request must not be executed after `expires`.
struct SendRequest {
  CommandNumber command;
  std::string uav;
  Request request;
  MissionTime expires;
  std::string asked_by = {};
};
/// A command was issued, delivered or settled; for the journal.
struct CommandChanged {
  CommandNumber command;
  std::string uav;
  std::string what;  ///< "START 3 goto", "ABORT 3", "MISSION 2 (3 tasks)", "DEGREE 1", …
  CommandState state = CommandState::kIssued;
  std::string why = {};
  std::string asked_by = {};
  std::optional<executive::TaskId> task = {};  ///< of a START or an ABORT
};
/// The ground learnt a new state of a task. Emitted once for each state of a task.
struct TaskChanged {
  std::string uav;
  executive::TaskId task;
  executive::TaskState state = executive::TaskState::kScheduled;
};
/// The UAV's decision node restarted, and its open tasks are lost.
struct UavRestarted {
  std::string uav;
  std::vector<executive::TaskId> lost;
};
struct DegreeChanged {
  std::string uav;
  Degree degree = 3;
};
/// A UAV handed its plan over; after DegreeChanged, if the degree changed. A UAV does so by itself
/// when its contact-loss policy takes the plan from its supervisor, or interrupts tasks of an
/// operator's: those then.
struct HandedOver {
  std::string uav;
  mission::HandOver hand_over;
  bool resumes = false;  ///< the UAV continues the plan that it had handed over before
};
/// The change of degree that commands waited for has succeeded or failed.
struct ChangeSettled {
  std::string uav;
};
/// A high-level task of a UAV entered another state.
struct GoalChanged {
  std::string uav;
  mission::GoalId goal;
  mission::GoalState state = mission::GoalState::kReceived;
};
/// A unit mission came to a stage. Emitted once per stage between restarts of the UAV's node.
struct MissionChanged {
  std::string uav;
  mission::MissionId mission;
  MissionStage stage = MissionStage::kPlanned;
};
/// The standing of a task of a global mission in the team's book changed.
struct TeamTaskChanged {
  team::TaskStanding standing;
};
enum class GlobalStage { kRefused, kGiven, kDone };
/// "refused", "given", "done".
std::string_view to_text(GlobalStage stage);
/// A global mission was given to the team, or refused as invalid (`why`), or all of it is done.
struct GlobalMissionChanged {
  mission::MissionId mission;
  GlobalStage stage = GlobalStage::kGiven;
  std::string why;
};
/// Give a global mission to the team.
struct GiveGlobalMission {
  team::GlobalMission mission;
};
/// Play a role of a joint task at the ground for a UAV that does not deliberate; the id of `task`
/// is used as the id of a task of that UAV. An empty `asked_by` becomes the step's or the
/// operator's name. Source: spec 1.2, 7.3.
struct PlayRole {
  std::string uav;
  mission::HighLevelTask task;
  std::string asked_by = {};
};
/// Stop playing roles for the UAV: of one joint task, or of all.
struct StopRole {
  std::string uav;
  std::optional<executive::TaskId> task;  ///< absent: all
  std::string why;
};
/// A role that is played at the ground has a request for its UAV.
struct RoleAsks {
  std::string uav;
  Request request;
};
/// A joint task that is played at the ground is running, ended or aborted.
struct PlayedTaskChanged {
  std::string uav;
  executive::TaskEvent event;
};
/// The operator declares that a UAV is lost for good: its granted tasks are auctioned again.
struct DeclareLost {
  std::string uav;
};
/// The operator takes it back: the UAV is sold tasks again, and waited for.
struct DeclareFound {
  std::string uav;
};
enum class HeldState { kHeld, kResumed, kDropped };
/// "held", "resumed", "dropped".
std::string_view to_text(HeldState state);
/// Tasks of a plan that a UAV handed over were held, resumed or dropped; for the
/// journal.
struct HeldPlanChanged {
  std::string uav;
  std::size_t tasks = 0;  ///< how many
  HeldState state = HeldState::kHeld;
};
/// Send the present state of an alarm to one UAV again, or to all.
struct TellAlarm {
  Alarm alarm;
  std::string uav;  ///< empty: all
};
/// An unexpected input was ignored, or an action could not be done; for the log.
struct Anomaly {
  std::string why;
  std::string asked_by = {};  ///< who had asked for the action; empty: nobody
};

// ---- the mission ----

struct PhaseEntered {
  std::string name;
};
struct StepDone {
  std::string name;
};
struct OperatorDid {
  std::string does;
};
struct MissionFinished {};

// ---- degree 1: the ground runs the UAV's MLE ----

/// An elementary request to the functional layer, through the transparent decision node.
struct SendFunctional {
  std::string uav;
  functional::Request request;
  MissionTime expires = MissionTime::max();  ///< the UAV must not begin with it later
};
/// Send a synchronisation message to the MLE of `to`.
struct SendSync {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  executive::SyncWord word = executive::SyncWord::kThere;
  MissionTime said;  ///< when `from` said so
};
enum class SyncDirection { kSent, kReceived };
/// An MLE at the ground sent or received a synchronisation message; for the journal.
struct LocalSync {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  SyncDirection direction = SyncDirection::kSent;
  executive::SyncWord word = executive::SyncWord::kThere;
};
/// A task of an MLE at the ground entered a state; for the journal.
struct LocalTaskEvent {
  std::string uav;
  executive::TaskEvent event;
  executive::Parameters parameters;  ///< of the task
  bool functional = true;  ///< the functional layer executes it, so that the UAV knows of it
};
/// An MLE at the ground answered a request; for the journal.
struct LocalRequestAnswered {
  std::string uav;
  executive::Reply reply;
  executive::InsertionMode mode = executive::InsertionMode::kSeq;  ///< of a START
};

}  // namespace skein::ground_station
