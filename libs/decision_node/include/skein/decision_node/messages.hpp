// SPDX-License-Identifier: Apache-2.0
// Inputs and effects of a decision node.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/auction/team_member.hpp"
#include "skein/decision_node/contact.hpp"
#include "skein/decision_node/way_search.hpp"
#include "skein/executive/effect.hpp"
#include "skein/executive/executive.hpp"
#include "skein/functional/port.hpp"
#include "skein/interaction/effect.hpp"
#include "skein/interaction/scm_monitor.hpp"
#include "skein/merging/message.hpp"
#include "skein/mission/request.hpp"
#include "skein/negotiation/joint_task_status.hpp"
#include "skein/negotiation/modality.hpp"
#include "skein/supervisor/detours.hpp"
#include "skein/supervisor/supervisor.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"

namespace skein::decision_node {

// ---- inputs ----

/// The first input of every life of the node.
struct Started {
  bool first_life = false;  ///< no life before this one; false: memory of one may be lost
};

/// The first input of a life that has the memory of those before: nothing was heard until now, and
/// what came meanwhile is yet to be told.
struct Resumed {};

/// Identifies a command: its number within one life of the ground station.
struct CommandKey {
  std::uint64_t incarnation = 0;
  std::uint64_t number = 0;
  auto operator<=>(const CommandKey&) const = default;
};
/// A command of the ground station: executed once, answered as often as it arrives.
struct Command {
  CommandKey key;
  mission::Request request;
  std::string asked_by = {};  ///< for people
};
/// A command that cannot be read: refused with the reason.
struct UnreadableCommand {
  CommandKey key;
  mission::RequestKind kind = mission::RequestKind::kStart;
  std::uint64_t id = 0;
  std::string why;
};
/// A place that missions may refer to by name (of an alarm), from the ground station.
struct PlaceTold {
  mission::ChangeWorld place;
};
/// An elementary request of the ground station to the functional layer: at degree 1.
struct ElementaryRequest {
  functional::Request request;
};
/// The state of a task that the ground station's executive runs for this UAV (degree 1).
struct GroundTaskSeen {
  executive::TaskEvent event;
};
/// A status of the UAV's functional layer.
struct StatusTold {
  functional::Status status;
};
/// A synchronisation message of another UAV to this one.
struct SyncMessage {
  std::uint64_t id = 0;
  std::string from;
  std::string to;
  executive::SyncWord word = executive::SyncWord::kThere;
  MissionTime said;  ///< when the message was sent
};
/// The degree of another UAV.
struct DegreeTold {
  std::string from;
  mission::Degree degree = mission::kLeastDegree;
};
/// Whether another node is in reach: a UAV, the ground station, or this UAV's functional layer.
struct Contact {
  std::string peer;
  bool ground = false;  ///< the node is the ground station
  bool reachable = false;
};
/// The UAV's functional layer has restarted without its memory: tasks that run for this node are
/// unknown to it.
struct LayerForgot {};
/// The position of a partner in a joint task.
struct PartnerSeen {
  world::Telemetry telemetry;
};
/// The progress of another UAV in a joint task.
struct JointTaskTold {
  interaction::JointTaskStatus status;
  MissionTime at;  ///< the instant of that progress
};
/// A negotiation message of the ground station in this UAV's name, since it plays its role, to
/// another UAV.
struct GroundNegotiates {
  std::string to;
  interaction::SessionMessage message;
};
/// The progress of this UAV in a joint task whose role the ground station plays.
struct GroundPlays {
  interaction::JointTaskStatus status;
};
/// The result of the job that StartReckoning asked for.
struct ReckoningFinished {
  std::uint64_t job = 0;
  Result<interaction::Rows, Failure> result;
};
/// The result of the job that StartDetours asked for.
struct DetoursPlanned {
  std::uint64_t job = 0;
  std::vector<supervisor::Detour> detours;  ///< of the first legs, in their order
};
/// The result of the job that StartWaySearch asked for.
struct WaySearched {
  std::uint64_t job = 0;
  std::optional<refiners::Path> path;  ///< none: no way is known
};
/// A message of another team member about the token, the ledger or a sale.
struct TeamTold {
  std::string from;
  auction::TeamMessage message;
};
/// A message of another UAV about its air reservations and requests.
struct MergeTold {
  std::string from;
  merging::Message message;
};
/// A UAV's plan between its meetings (the frontier of its temporal network), or the ground
/// station's forecast in its place.
struct FrontierTold {
  std::string from;
  temporal::Frontier frontier;  ///< without fault
  bool by_ground = false;
};
/// Time passes; sent at least at the instant of the next wake-up.
struct Tick {};

using Input =
    std::variant<Started, Command, UnreadableCommand, PlaceTold, ElementaryRequest, GroundTaskSeen,
                 StatusTold, SyncMessage, DegreeTold, world::Telemetry, world::Perception, Contact,
                 LayerForgot, supervisor::JobFinished, interaction::SessionMessage, PartnerSeen,
                 JointTaskTold, GroundNegotiates, GroundPlays, ReckoningFinished, DetoursPlanned,
                 WaySearched, TeamTold, MergeTold, FrontierTold, Tick, Resumed>;

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
/// A status of a task that the ground station itself had dispatched.
struct StatusPassedOn {
  functional::Status status;
};
/// Telemetry of this UAV, or of a partner in a joint task whose role the ground plays.
struct TelemetryPassedOn {
  world::Telemetry telemetry;
};
struct PerceptionPassedOn {
  world::Perception perception;
};
/// A synchronisation message, unchanged, for the ground's executive, which waits for it.
struct SyncPassedOn {
  SyncMessage message;
};
/// A partner's message about a joint task whose role the ground plays for this UAV.
struct NegotiationPassedOn {
  interaction::SessionMessage message;
};
struct PartnerPassedOn {
  interaction::JointTaskStatus status;
};
/// The degree changed.
struct DegreeChanged {
  int degree = 3;
  std::string by;                   ///< who changed it; empty at the start
  std::optional<std::size_t> held;  ///< number of tasks in hand at the change
};
struct HandedOver {
  mission::HandOver hand_over;
};
/// The executive's tasks, whenever they change.
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
  /// Send to the UAV; false: to the ground station, which relays. See
  /// mission::synchronises_directly().
  bool direct = true;
  MissionTime expires;  ///< from then on the message has no effect
};

/// A message of a negotiation.
struct SendNegotiation {
  std::string to;
  interaction::SessionMessage message;
};
/// Run interaction::reckon(terms, offers) as a job; its result is returned by ReckoningFinished.
struct StartReckoning {
  std::uint64_t job = 0;  ///< number of the job, unique among reckonings
  interaction::Terms terms;
  interaction::Offers offers;
};
/// The result of this reckoning is not needed any more; it is returned nevertheless.
struct StopReckoning {
  std::uint64_t job = 0;
};
/// This UAV's progress in a joint task, whenever it changes: for partners and the ground.
struct JointTaskChanged {
  interaction::JointTaskStatus status;
  std::vector<std::string> partners;
};
/// This UAV's progress in a joint task whose role the ground plays.
struct SpokenFor {
  interaction::JointTaskStatus status;
  bool to_ground = false;    ///< the task was left on board, tell the ground
  bool to_partners = false;  ///< to all other UAVs; those that are no partners ignore it
};
/// This UAV's position, for a partner in a joint task.
struct ShareTelemetry {
  std::string partner;
  world::Telemetry telemetry;
};

/// Run supervisor::plan_detours(request) as a job in the second lane, which no deliberation waits
/// for; its result is returned by DetoursPlanned.
struct StartDetours {
  std::uint64_t job = 0;  ///< number of the job, unique among these
  supervisor::DetourRequest request;
};

/// Run search_way(search) as a job in the second lane; its result is returned by WaySearched.
struct StartWaySearch {
  std::uint64_t job = 0;  ///< number of the job, unique among these
  WaySearch search;
};

/// A message to another member of the team.
struct SendTeam {
  std::string to;
  auction::TeamMessage message;
};

/// A message of plan merging to another UAV or the witness.
struct SendMerge {
  std::string to;
  merging::Message message;
};

/// The frontier of this UAV's temporal network; replaces the last one sent to that node.
struct SendFrontier {
  std::string to;  ///< empty: the ground station
  temporal::Frontier frontier;
};

// For the journal.

/// The foreseen arrivals of those that this UAV is to meet; none: not known any more.
struct MeetingNoted {
  temporal::MeetingId meeting = 0;
  std::optional<temporal::PartnerDates> dates;
};

/// The state of a motion that needs a reservation of air: "waits", "had" (granted, it begins),
/// "unasked" (it begins without a reservation, since the energy lasts no longer), "aside" (the UAV
/// moves aside to break a circle of waits).
struct AirNoted {
  functional::TaskId task;
  std::string type, state;
  std::vector<std::string> waits_for;  ///< "heliv to leave"
  double raised = 0;                   ///< how much higher it is flown than was asked for [m]
  Duration waited;
  merging::Volumes air;  ///< reserved for the motion; of "waits": what others are to leave
};

/// What this UAV did with a task that it owns: "begun", "done", "put-back", "kept".
struct TeamTaskNoted {
  auction::Claim claim;
  std::string state;
  mission::GoalId goal;  ///< its number in this UAV's supervisor
  std::string statement;
  std::string why;
};
/// This UAV's bid for a task without an owner.
struct BidNoted {
  auction::Claim claim;
  std::optional<double> added;  ///< time that the task adds to its route [s]; none: no bid
  std::string objection;
};
/// An event of a sale held by this UAV.
struct SaleNoted {
  auction::SaleEffect what;
};
/// This UAV got the auctioneer's token, or lost it.
struct TokenNoted {
  bool held = false;
  std::uint64_t term = 0;
};

/// A componel (block, task or coordination action) of a role entered a state.
struct ComponelChanged {
  std::string subject, role, componel;
  interaction::ComponelState state = interaction::ComponelState::kScheduled;
  std::string block;    ///< the enclosing block
  std::string because;  ///< precondition by which a block was activated
};
/// A role started a task of the executive.
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
  std::string why;                ///< why there is none
  std::vector<std::string> scms;  ///< spatial constraints that hold there
};
struct ScmNoted {
  std::string subject, role;
  interaction::ScmFound found;
};
/// "invited", "offered", "refused", "agreed", "failed", "undecided", "settled agreed", …
struct NegotiationNoted {
  interaction::Terms terms;
  std::string state;
  interaction::Rows rows;  ///< of the offer, or of the result
  std::string why;
  std::vector<std::string> unconfirmed;
};

struct RequestHandled {
  executive::Reply reply;
  executive::InsertionMode mode = executive::InsertionMode::kSeq;  ///< of a START request
};
struct SyncHeard {
  SyncMessage message;
};
struct PolicyCarriedOut {
  ContactPolicy policy = ContactPolicy::kHold;
  std::string why;  ///< empty: contact was lost
};
struct Notice {
  std::string text;
};

/// The supervisor's effects are passed through unchanged.
using EffectVariant =
    std::variant<Answer, TaskChanged, StatusPassedOn, TelemetryPassedOn, PerceptionPassedOn,
                 SyncPassedOn, NegotiationPassedOn, PartnerPassedOn, SpokenFor, DegreeChanged,
                 HandedOver, BoardChanged, ToVehicle, SendSync, SendNegotiation, StartReckoning,
                 StopReckoning, StartDetours, StartWaySearch, SendTeam, SendMerge, SendFrontier,
                 MeetingNoted, AirNoted, TeamTaskNoted, BidNoted, SaleNoted, TokenNoted,
                 JointTaskChanged, ShareTelemetry, ComponelChanged, RoleTaskGiven, PlaceComputed,
                 ScmNoted, NegotiationNoted, RequestHandled, SyncHeard, PolicyCarriedOut, Notice,
                 supervisor::MissionDecided, supervisor::StartDeliberation,
                 supervisor::StopDeliberation, supervisor::PlanChanged, supervisor::GoalChanged,
                 supervisor::Decided>;
/// An EffectVariant with out-of-line special members, so that they are compiled only once.
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
