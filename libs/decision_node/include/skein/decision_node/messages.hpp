// SPDX-License-Identifier: Apache-2.0
// What goes into a decision node and what comes out.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/decision_node/contact.hpp"
#include "skein/executive/effect.hpp"
#include "skein/executive/executive.hpp"
#include "skein/functional/port.hpp"
#include "skein/mission/request.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::decision_node {

// ---- inputs ----

/// First input of its life.
struct Started {};

/// A command of the ground station's, in one life of it.
struct CommandKey {
  std::uint64_t incarnation = 0;
  std::uint64_t number = 0;
  auto operator<=>(const CommandKey&) const = default;
};
/// A command: executed once, answered as often as it comes.
struct Command {
  CommandKey key;
  mission::Request request;
  std::string asked_by = {};  ///< for people
};
/// A command that makes no sense: refused with its reason.
struct UnreadableCommand {
  CommandKey key;
  mission::RequestKind kind = mission::RequestKind::kStart;
  std::uint64_t id = 0;
  std::string why;
};
/// A place that missions may name, told by the ground station (an alarm's).
struct PlaceTold {
  mission::ChangeWorld place;
};
/// Of the ground station, for the vehicle: at degree 1.
struct ElementaryRequest {
  functional::Request request;
};
/// A task that the ground station's executive has in this UAV's place (degree 1).
struct GroundTaskSeen {
  executive::TaskEvent event;
};
/// From the UAV's functional layer.
struct StatusTold {
  functional::Status status;
};
/// Of another UAV, for this one.
struct SyncMessage {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  executive::SyncWord word = executive::SyncWord::kThere;
  MissionTime said;  ///< when it was sent
};
/// What is believed of the contact with another node.
struct Contact {
  std::string peer;
  bool ground = false;  ///< it is the ground station
  bool reachable = false;
};
/// Its instant has come, or time just passes.
struct Tick {};

using Input = std::variant<Started, Command, UnreadableCommand, PlaceTold, ElementaryRequest,
                           GroundTaskSeen, StatusTold, SyncMessage, world::Telemetry,
                           world::Perception, Contact, supervisor::JobFinished, Tick>;

// ---- effects, to be carried out in their order ----

// To the ground station.

/// The answer to a command.
struct Answer {
  CommandKey key;
  mission::RequestKind kind = mission::RequestKind::kStart;
  std::uint64_t id = 0;
  bool accepted = false;
  std::string why;
};
struct TaskChanged {
  executive::TaskEvent event;
  functional::Parameters parameters;
};
/// Of a task that the ground station had dispatched itself.
struct StatusPassedOn {
  functional::Status status;
};
struct TelemetryPassedOn {
  world::Telemetry telemetry;
};
struct PerceptionPassedOn {
  world::Perception perception;
};
/// A synchronisation message as it came: the executive that waits for it is at the ground.
struct SyncPassedOn {
  SyncMessage message;
};
/// The degree is this from now on.
struct DegreeChanged {
  int degree = 3;
  std::string by;                   ///< at the start empty
  std::optional<std::size_t> held;  ///< tasks that were in hand at a change
};
struct HandedOver {
  mission::HandOver hand_over;
};
/// What the executive has, when that is not as it was.
struct BoardChanged {
  int degree = 3;
  bool airborne = false;
  std::vector<executive::TaskStatus> tasks;
  bool operator==(const BoardChanged&) const = default;
};

// To others.

struct ToVehicle {
  functional::Request request;
};
/// A synchronisation message of this UAV's executive.
struct SendSync {
  executive::SendSync message;
  bool direct = true;   ///< to the UAV; else to the ground station, which relays it
  MissionTime expires;  ///< when it would count no more
};

// For the journal.

struct RequestHandled {
  executive::Reply reply;
  executive::InsertionMode mode = executive::InsertionMode::kSeq;  ///< of a START
};
struct SyncHeard {
  SyncMessage message;
};
struct PolicyCarriedOut {
  ContactPolicy policy = ContactPolicy::kHold;
  std::string why;  ///< empty: contact is lost
};
struct Notice {
  std::string text;
};

/// Those of the supervisor mean what they mean there.
using Effect =
    std::variant<Answer, TaskChanged, StatusPassedOn, TelemetryPassedOn, PerceptionPassedOn,
                 SyncPassedOn, DegreeChanged, HandedOver, BoardChanged, ToVehicle, SendSync,
                 RequestHandled, SyncHeard, PolicyCarriedOut, Notice, supervisor::MissionDecided,
                 supervisor::StartDeliberation, supervisor::StopDeliberation,
                 supervisor::PlanChanged, supervisor::GoalChanged, supervisor::Decided>;
using Effects = std::vector<Effect>;

}  // namespace skein::decision_node
