// SPDX-License-Identifier: Apache-2.0
// What goes into a decision node and what comes out.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "skein/decision_node/contact.hpp"
#include "skein/executive/effect.hpp"
#include "skein/executive/executive.hpp"
#include "skein/functional/port.hpp"
#include "skein/interaction/effect.hpp"
#include "skein/interaction/scm_monitor.hpp"
#include "skein/merging/message.hpp"
#include "skein/mission/request.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/modality.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::decision_node {

// ---- inputs ----

/// First input of its life.
struct Started {
  bool first_life = false;  ///< there was none before; else it may have forgotten one
};

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
/// The degree that another UAV is at.
struct DegreeTold {
  std::string from;
  mission::Degree degree = mission::kLeastDegree;
};
/// What is believed of the contact with another node.
struct Contact {
  std::string peer;
  bool ground = false;  ///< it is the ground station
  bool reachable = false;
};
/// The UAV's functional layer is back and has lost all that it knew: tasks that are under way to
/// this node are not to it.
struct LayerForgot {};
/// A partner of a joint task says where it is.
struct PartnerSeen {
  world::Telemetry telemetry;
};
/// Where another UAV stands in a joint task.
struct JointTaskTold {
  interaction::JointTaskStatus status;
  MissionTime at;  ///< when it was so
};
/// What the ground station says to another UAV in this one's name: it plays a role for it.
struct GroundNegotiates {
  std::string to;
  interaction::SessionMessage message;
};
/// Where this UAV stands in a joint task whose role the ground station plays.
struct GroundPlays {
  interaction::JointTaskStatus status;
};
/// What follows from the offers of a session, as StartReckoning asked for.
struct ReckoningFinished {
  std::uint64_t job = 0;
  Result<interaction::Rows, Failure> result;
};
/// A member of the team says something about the token, the ledger or a sale.
struct TeamTold {
  std::string from;
  auction::TeamMessage message;
};
/// Another UAV says what it has of the air, and what it wants.
struct MergeTold {
  std::string from;
  merging::Message message;
};
/// A UAV says what lies between the meetings of its plan, or the ground station says when it comes.
struct FrontierTold {
  std::string from;
  temporal::Frontier frontier;  ///< without fault
  bool by_ground = false;
};
/// Its instant has come, or time just passes.
struct Tick {};

using Input =
    std::variant<Started, Command, UnreadableCommand, PlaceTold, ElementaryRequest, GroundTaskSeen,
                 StatusTold, SyncMessage, DegreeTold, world::Telemetry, world::Perception, Contact,
                 LayerForgot, supervisor::JobFinished, interaction::SessionMessage, PartnerSeen,
                 JointTaskTold, GroundNegotiates, GroundPlays, ReckoningFinished, TeamTold,
                 MergeTold, FrontierTold, Tick>;

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
/// Of this UAV, or of a partner of a joint task that the ground plays for it.
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
/// What partners say about a joint task that the ground plays for this UAV.
struct NegotiationPassedOn {
  interaction::SessionMessage message;
};
struct PartnerPassedOn {
  interaction::JointTaskStatus status;
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
  /// To the UAV; else to the ground station, which relays it. See mission::synchronises_directly().
  bool direct = true;
  MissionTime expires;  ///< when it would count no more
};

/// A message of a negotiation.
struct SendNegotiation {
  std::string to;
  interaction::SessionMessage message;
};
/// Run interaction::reckon(terms, offers) as a job; its result comes back as ReckoningFinished.
struct StartReckoning {
  std::uint64_t job = 0;  ///< among those of reckonings
  interaction::Terms terms;
  interaction::Offers offers;
};
/// Nobody wants the result of this reckoning any more; it comes back all the same.
struct StopReckoning {
  std::uint64_t job = 0;
};
/// Where this UAV stands in a joint task, when that is not as it was: for partners and the ground.
struct JointTaskChanged {
  interaction::JointTaskStatus status;
  std::vector<std::string> partners;
};
/// Where this UAV stands in a joint task that the ground plays for it.
struct SpokenFor {
  interaction::JointTaskStatus status;
  bool to_ground = false;    ///< it was left here
  bool to_partners = false;  ///< all other UAVs: who is none knows nothing of it
};
/// Where this UAV is, for a partner of a joint task.
struct ShareTelemetry {
  std::string partner;
  world::Telemetry telemetry;
};

/// To another member of the team.
struct SendTeam {
  std::string to;
  auction::TeamMessage message;
};

/// To another UAV that merges its ways.
struct SendMerge {
  std::string to;
  merging::Message message;
};

/// To another UAV, or the ground station, in place of what it was told before.
struct SendFrontier {
  std::string to;  ///< empty: the ground station
  temporal::Frontier frontier;
};

// For the journal.

/// When those come whom this UAV is to meet, as it knows of it; none: it is not known any more.
struct MeetingNoted {
  temporal::MeetingId meeting = 0;
  std::optional<temporal::PartnerDates> dates;
};

/// Where a motion stands that needs air: "waits", "had" (it begins), "unasked" (it begins without,
/// since the energy lasts no longer), "aside" (the UAV gets out of a circle of waits).
struct AirNoted {
  functional::TaskId task;
  std::string type, state;
  std::vector<std::string> waits_for;  ///< "heliv to leave"
  double raised = 0;                   ///< flown so much higher than it was asked for [m]
  Duration waited;
  merging::Volumes air;  ///< that it has for the motion
};

/// What this UAV does with a task that it was granted: "begun", "done", "put-back", "kept".
struct TeamTaskNoted {
  auction::Claim claim;
  std::string state;
  mission::GoalId goal;  ///< as which its supervisor has it
  std::string statement;
  std::string why;
};
/// What this UAV offered for a task that had no owner.
struct BidNoted {
  auction::Claim claim;
  std::optional<double> added;  ///< the time that it adds to its route [s]; none: it does not bid
  std::string objection;
};
/// Of a sale that this UAV holds.
struct SaleNoted {
  auction::SaleEffect what;
};
/// The right to sell came here, or went.
struct TokenNoted {
  bool held = false;
  std::uint64_t term = 0;
};

/// A block, task or coordination action of a role entered a state.
struct ComponelChanged {
  std::string subject, role, componel;
  interaction::ComponelState state = interaction::ComponelState::kScheduled;
  std::string block;    ///< around it
  std::string because;  ///< the precondition of a block that is activated
};
/// A role asked for a task of the executive's.
struct RoleTaskGiven {
  std::string subject, role, block, componel;
  executive::TaskId task, of;  ///< `of`: the joint task
  std::string type;
  std::string because;  ///< the precondition of the block
};
/// A place of a role was computed, or could not be.
struct PlaceComputed {
  std::string subject, role, parameter, initialiser;
  std::optional<interaction::Position> at;
  std::string why;                ///< not
  std::vector<std::string> scms;  ///< that are to hold there
};
struct ScmNoted {
  std::string subject, role;
  interaction::ScmFound found;
};
/// "invited", "offered", "refused", "agreed", "failed", "undecided", "settled agreed", …
struct NegotiationNoted {
  interaction::Terms terms;
  std::string state;
  interaction::Rows rows;  ///< offer, or result
  std::string why;
  std::vector<std::string> unconfirmed;
};

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
using EffectVariant =
    std::variant<Answer, TaskChanged, StatusPassedOn, TelemetryPassedOn, PerceptionPassedOn,
                 SyncPassedOn, NegotiationPassedOn, PartnerPassedOn, SpokenFor, DegreeChanged,
                 HandedOver, BoardChanged, ToVehicle, SendSync, SendNegotiation, StartReckoning,
                 StopReckoning, SendTeam, SendMerge, SendFrontier, MeetingNoted, AirNoted,
                 TeamTaskNoted, BidNoted, SaleNoted, TokenNoted, JointTaskChanged, ShareTelemetry,
                 ComponelChanged, RoleTaskGiven, PlaceComputed, ScmNoted, NegotiationNoted,
                 RequestHandled, SyncHeard, PolicyCarriedOut, Notice, supervisor::MissionDecided,
                 supervisor::StartDeliberation, supervisor::StopDeliberation,
                 supervisor::PlanChanged, supervisor::GoalChanged, supervisor::Decided>;
/// An EffectVariant whose copies, moves and end are compiled once, not wherever effects are kept.
class Effect : public EffectVariant {
 public:
  using EffectVariant::EffectVariant;
  using EffectVariant::operator=;
  Effect();
  Effect(const Effect& other);
  Effect(Effect&& other) noexcept;
  Effect& operator=(const Effect& other);
  Effect& operator=(Effect&& other) noexcept;
  ~Effect();
};
using Effects = std::vector<Effect>;

}  // namespace skein::decision_node
