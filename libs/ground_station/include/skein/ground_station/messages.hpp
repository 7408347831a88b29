// SPDX-License-Identifier: Apache-2.0
// What goes in and out of the ground station's components.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/foundation/id.hpp"
#include "skein/foundation/time.hpp"
#include "skein/ground_station/degree.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::ground_station {

/// What may be asked of an MLE. Source: T III.2.1, spec 2.3.
using Request = std::variant<executive::Start, executive::Abort, executive::ProcessMessage,
                             executive::UpdateConditions, executive::Suppress>;

/// Numbered from 1 in the order issued.
using CommandNumber = Id<struct CommandNumberTag, std::uint64_t>;

// ---- from the outside ----

/// Time passes.
struct Tick {};
/// A vehicle told of itself.
struct TelemetryReceived {
  std::string uav;
  world::VehicleState state;
  MissionTime at;  ///< when it was so
};
/// A task of a UAV entered a state: from its MLE.
struct TaskEventReceived {
  std::string uav;
  executive::TaskId task;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
  std::string reason = {};
};
/// The answer of a UAV's MLE to a command.
struct RequestReplyReceived {
  CommandNumber command;
  bool accepted = false;
  std::string why = {};
};
/// The command could not be delivered in its lifetime.
struct CommandUndelivered {
  CommandNumber command;
};
/// What the ground believes of its own radio contact with a UAV's decision node.
struct PeerReachable {
  std::string uav;
  bool reachable = false;
  bool restarted = false;  ///< it is a new incarnation, which has no plan
};
struct PlannedTaskStatus {
  executive::TaskId task;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
};
/// The plan a UAV's decision node holds. Repairs what events have not told; degree 1 nodes hold
/// none.
struct PlanBoardReceived {
  std::string uav;
  Degree degree = 3;
  bool airborne = false;
  std::vector<PlannedTaskStatus> tasks;
};
/// The functional layer's answer to what the ground itself dispatched (degree 1).
struct FunctionalStatusReceived {
  std::string uav;
  executive::FunctionalStatus status;
};
/// A synchronisation message that is not for direct delivery: to be relayed or used here.
struct SyncReceived {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
};
/// An operator acts by name: what the script's OnOperator waits for.
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

/// Ask MCS to send a request and see it through.
struct IssueCommand {
  std::string uav;
  Request request;
  MissionTime expires;
};
/// Ask MCS to abort all that is not terminal, or still on its way, highest id first.
struct AbortEverything {
  std::string uav;
  MissionTime expires;
};
enum class CommandState { kIssued, kAcknowledged, kRefused, kExpired };
/// "issued", "acknowledged", "refused", "expired".
std::string_view to_text(CommandState state);

/// A request is to go to a UAV's MLE. Idempotent by number: an MLE that already handled the number
/// in this life answers as before and does nothing. It must not be executed after `expires`.
struct SendRequest {
  CommandNumber command;
  std::string uav;
  Request request;
  MissionTime expires;
};
/// A command was issued or came to its end; for the journal.
struct CommandChanged {
  CommandNumber command;
  std::string uav;
  std::string what;  ///< "START 3 goto", "ABORT 3", …
  CommandState state = CommandState::kIssued;
  std::string why = {};
};
/// A task's state is news to the ground. Each state of a task is told once.
struct TaskChanged {
  std::string uav;
  executive::TaskId task;
  executive::TaskState state = executive::TaskState::kScheduled;
};
/// The UAV's decision node restarted; what it had in hand is lost.
struct UavRestarted {
  std::string uav;
  std::vector<executive::TaskId> lost;
};
struct DegreeChanged {
  std::string uav;
  Degree degree = 3;
};
/// Something that should not come, and was disregarded; for the log.
struct Anomaly {
  std::string why;
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

// ---- degree 1: what the ground does in place of a UAV's MLE ----

enum class FunctionalVerb { kDispatch, kInterrupt };
/// An elementary request to the functional layer, through the transparent decision node.
struct SendFunctional {
  std::string uav;
  FunctionalVerb verb = FunctionalVerb::kDispatch;
  executive::Task task;  ///< of an interrupt: id and type
};
/// A synchronisation message is to go to the MLE of `to`.
struct SendSync {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
};
enum class SyncDirection { kSent, kReceived };
/// An MLE at the ground sent or received a synchronisation message; for the journal.
struct LocalSync {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  SyncDirection direction = SyncDirection::kSent;
};
/// A task of an MLE at the ground entered a state; for the journal.
struct LocalTaskEvent {
  std::string uav;
  executive::TaskId task;
  std::string type;
  executive::TaskState state = executive::TaskState::kScheduled;
  std::string reason = {};
};
/// An MLE at the ground answered a request; for the journal.
struct LocalRequestAnswered {
  std::string uav;
  Request request;
  bool accepted = false;
  std::string why = {};
};

}  // namespace skein::ground_station
