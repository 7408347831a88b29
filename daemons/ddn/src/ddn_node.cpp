// SPDX-License-Identifier: Apache-2.0
// Inputs to the decision node, and what it asks of the ground station, of others and of the
// runtime.
#include "skein/ddn/ddn_node.hpp"

#include "deliberation_lines.hpp"
#include "meeting_lines.hpp"
#include "merging_lines.hpp"
#include "node_lines.hpp"
#include "received.hpp"
#include "skein/foundation/fingerprint.hpp"
#include "skein/interaction/model_hash.hpp"
#include "skein/joint_lines/joint_lines.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "skein/team_translation/meetings.hpp"
#include "skein/team_translation/team.hpp"
#include "skein/team_translation/team_lines.hpp"
#include "skein/translation/joint_tasks.hpp"
#include "skein/translation/merging.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"
#include "team_lines.hpp"

namespace skein::ddn {

namespace lines = journal::lines;

namespace {

namespace dn = decision_node;
using translation::to_wire;

dn::Config decision_config(const DdnConfig& config, const node::Roster& roster) {
  dn::Config result = config;
  result.others = dn::OtherUavs(roster.uavs(), config.uav);
  return result;
}

wire::SyncMessage to_wire(const dn::SyncMessage& message) {
  return to_wire(executive::SendSync{message.id, message.to, message.word}, message.from,
                 message.said);
}

}  // namespace

namespace {

std::vector<wire::ModelVersion> versions_of(
    const std::shared_ptr<const interaction::Library>& library) {
  std::vector<wire::ModelVersion> versions;
  if (library == nullptr) return versions;
  for (const auto& [type, hash] : hashes_of(*library)) versions.push_back({type, hash.value});
  return versions;
}

}  // namespace

DdnNode::DdnNode(DdnConfig config, node::Roster roster)
    : uav_(config.uav),
      roster_(std::move(roster)),
      functional_(roster_.functional_of(roster_.find(uav_)->number)),
      degree_{
          .header = {}, .uav = uav_, .contact_policy = std::string(to_text(config.contact_policy))},
      jobs_(config.deliberation),
      team_(config.team ? config.team->roster : team::Roster()),
      models_(versions_of(config.interaction)),
      decision_(decision_config(config, roster_)) {}

node::Effects DdnNode::handle(const node::Input& input, MissionTime now) {
  now_ = now;
  out_.clear();
  if (const auto mine = input_of(input)) {
    for (const dn::Effect& effect : decision_.handle(*mine, now)) {
      std::visit([this](const auto& one) { carry_out(one); }, effect);
    }
  }
  return std::move(out_);
}

std::optional<dn::Input> DdnNode::input_of(const node::Input& input) {
  if (const auto* received = std::get_if<node::Received>(&input)) {
    const Sender sender{roster_.name_of(received->from), received->from == roster_.ground(),
                        received->from == functional_};
    const std::string why = why_not(received->sample, sender);
    if (why.empty()) {
      if (const auto* told = std::get_if<wire::PlanFrontier>(&received->sample))
        log(translation::frontier_heard(writer(), uav_, sender.name, told->uav));
      return ddn::input_of(received->sample, sender);
    }
    drop(*received, why);
  } else if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    note_reach(*reach);
    if (reach->peer == functional_ && reach->restarted) return dn::LayerForgot{};
    return dn::Contact{roster_.name_of(reach->peer), reach->peer == roster_.ground(),
                       reach->reachable};
  } else if (const auto* done = std::get_if<node::JobDone>(&input)) {
    return Jobs::input_of(*done);
  } else if (const auto* lost = std::get_if<node::Undelivered>(&input)) {
    note(*lost);
  } else if (const auto* started = std::get_if<node::Started>(&input)) {
    return dn::Started{started->first_life};
  } else if (std::holds_alternative<node::Restarted>(input)) {
    return dn::Resumed{};
  } else if (std::holds_alternative<node::Wakeup>(input)) {
    return dn::Tick{};
  }
  return std::nullopt;
}

// What negotiations say they say again by themselves; a word between executives is all that there
// is.
void DdnNode::note(const node::Undelivered& lost) {
  if (lost.slot != wire::Slot::kSyncMessage) return;
  log(lines::Notice{.uav = uav_,
                    .text = "a synchronisation message to " + roster_.name_of(lost.to) +
                            " was not delivered in its lifetime"});
}

void DdnNode::drop(const node::Received& received, const std::string& why) {
  const wire::Slot slot = wire::slot_of(received.sample);
  const auto count = dropped_.count({received.from, slot});
  if (!count) return;
  log(lines::Dropped{.slot = wire::slot_name(slot),
                     .origin = roster_.name_of(received.from),
                     .field = "header.origin",
                     .why = why + *count});
}

void DdnNode::note_reach(const node::Reachability& reach) {
  const node::Member* peer = roster_.find(reach.peer);
  if (peer == nullptr || peer->role != wire::Role::kDdn) return;
  if (!reach.reachable) {
    uavs_in_reach_.erase(reach.peer);
  } else if (uavs_in_reach_.insert(reach.peer).second || reach.restarted) {
    if (degree_.degree != 0) send(reach.peer, degree_);  // it has begun
  }
}

// ---- to the ground station ----

void DdnNode::carry_out(const dn::Answer& effect) {
  wire::RequestReply reply;
  reply.command = effect.key.number;
  reply.kind = translation::to_wire(effect.kind);
  reply.id = effect.id;
  reply.accepted = effect.accepted;
  reply.why = effect.why;
  send_to_ground(std::move(reply));
}

void DdnNode::carry_out(const dn::TaskChanged& effect) {
  log(translation::task_line(writer(), uav_, effect.event, effect.parameters));
  send_to_ground(to_wire(uav_, effect.event, now_));
}

void DdnNode::carry_out(const dn::StatusPassedOn& effect) {
  send_to_ground(to_wire(uav_, effect.status));
}

void DdnNode::carry_out(const dn::TelemetryPassedOn& effect) {
  send_to_ground(to_wire(effect.telemetry));
}

void DdnNode::carry_out(const dn::PerceptionPassedOn& effect) {
  const world::Perception& look = effect.perception;
  if (!look.detections.empty() && sightings_.take(look.device, now_)) {
    send_to_ground(translation::sighting_of(look));
  } else {
    send_to_ground(to_wire(look));
  }
}

void DdnNode::carry_out(const dn::SyncPassedOn& effect) { send_to_ground(to_wire(effect.message)); }

void DdnNode::carry_out(const dn::NegotiationPassedOn& effect) {
  send(roster_.ground(), to_wire(effect.message, uav_));
}

// Two partners may have given it the same number.
void DdnNode::carry_out(const dn::PartnerPassedOn& effect) {
  wire::JointTaskState sample = to_wire(effect.status);
  const auto print = Fingerprint().put(effect.status.uav).put(effect.status.task).value();
  sample.header.instance = static_cast<std::uint32_t>(print);
  send_to_ground(std::move(sample));
}

void DdnNode::carry_out(const dn::DegreeChanged& effect) {
  lines::Degree line{.uav = uav_, .degree = effect.degree, .by = effect.by};
  if (effect.held) line.held = static_cast<std::int64_t>(*effect.held);
  log(std::move(line));
  degree_.degree = static_cast<std::uint8_t>(effect.degree);
  send_to_ground(degree_);
  for (const node::NodeNumber uav : uavs_in_reach_) send(uav, degree_);
}

void DdnNode::carry_out(const dn::HandedOver& effect) {
  send_to_ground(to_wire(uav_, effect.hand_over));
}

void DdnNode::carry_out(const dn::BoardChanged& effect) {
  wire::PlanBoard board;
  board.uav = uav_;
  board.degree = static_cast<std::uint8_t>(effect.degree);
  board.airborne = effect.airborne;
  for (const executive::TaskStatus& task : effect.tasks) {
    board.tasks.push_back({task.id.value(), task.type, to_wire(task.state), task.reason});
  }
  board.models = models_;
  send_to_ground(board);
}

void DdnNode::carry_out(const supervisor::MissionDecided& effect) {
  log(outcome_line(writer(), effect.outcome));
  send_to_ground(to_wire(uav_, effect.outcome));
}

// Of the tasks of a revision, those are logged that were not so in the one before.
void DdnNode::carry_out(const supervisor::PlanChanged& effect) {
  const mission::PlanReport& report = effect.report;
  const wire::MissionPlan plan = to_wire(uav_, report);
  log(plan_line(writer(), report));
  std::map<std::uint64_t, wire::PlanEntry> logged;
  for (std::size_t i = 0; i < plan.tasks.size(); ++i) {  // in the order of the report
    const wire::PlanEntry& task = plan.tasks[i];
    const auto before = logged_plan_.find(task.id);
    if (before == logged_plan_.end() || before->second != task) {
      log(planned_line(writer(), plan.revision, task, report.tasks[i].task.parameters));
    }
    logged.emplace(task.id, task);
  }
  logged_plan_ = std::move(logged);
  send_to_ground(plan);
}

void DdnNode::carry_out(const supervisor::Decided& effect) {
  log(decision_line(writer(), effect.decision));
  send_to_ground(to_wire(uav_, effect.decision));
}

// ---- to others ----

void DdnNode::carry_out(const dn::ToVehicle& effect) {
  send(functional_, to_wire(uav_, effect.request));
}

void DdnNode::carry_out(const dn::SendSync& effect) {
  const executive::SendSync& message = effect.message;
  log(translation::sync_line(writer(), {message.id, uav_, message.to, true, message.word}));
  const node::NodeNumber next = effect.direct ? roster_.find(message.to)->number : roster_.ground();
  send(next, to_wire(message, uav_, now_), effect.expires);
}

// What is not there within the lifespan of its slot is said again.
void DdnNode::carry_out(const dn::SendNegotiation& effect) {
  send(roster_.find(effect.to)->number, to_wire(effect.message, effect.to));
}

void DdnNode::carry_out(const dn::SendTeam& effect) {
  send(roster_.find(effect.to)->number, to_wire(effect.message));
}

void DdnNode::carry_out(const dn::SendMerge& effect) {
  send(roster_.find(effect.to)->number, to_wire(effect.message));
}

void DdnNode::carry_out(const dn::SendFrontier& effect) {
  const node::NodeNumber to =
      effect.to.empty() ? roster_.ground() : roster_.find(effect.to)->number;
  log(translation::frontier_told(writer(), uav_, roster_.name_of(to), uav_, effect.frontier));
  send(to, to_wire(uav_, effect.frontier));
}

void DdnNode::carry_out(const dn::JointTaskChanged& effect) {
  log(joint_lines::line_of(writer(), uav_, effect.status));
  const wire::JointTaskState sample = to_wire(effect.status);
  send_to_ground(sample);
  for (const std::string& partner : effect.partners) send(roster_.find(partner)->number, sample);
}

// The ground writes what it plays; this node, what it has left in the ground's place.
void DdnNode::carry_out(const dn::SpokenFor& effect) {
  const wire::JointTaskState sample = to_wire(effect.status);
  if (effect.to_ground) send_to_ground(sample);
  if (!effect.to_partners) return;
  if (effect.to_ground) log(joint_lines::line_of(writer(), uav_, effect.status));
  for (const node::Member& member : roster_.members()) {
    if (member.role == wire::Role::kDdn && member.name != uav_) send(member.number, sample);
  }
}

void DdnNode::carry_out(const dn::ShareTelemetry& effect) {
  send(roster_.find(effect.partner)->number, to_wire(effect.telemetry));
}

// ---- for the journal, and jobs ----

template <class Noted>
void DdnNode::carry_out(const Noted& effect) {
  if constexpr (requires { jobs_.effect_of(effect); }) {
    out_.push_back(jobs_.effect_of(effect));
  } else if constexpr (requires { joint_lines::line_of(writer(), uav_, effect); }) {
    log(joint_lines::line_of(writer(), uav_, effect));
  } else {
    log(line_of(writer(), effect));
  }
}

void DdnNode::carry_out(const dn::SaleNoted& effect) {
  for (journal::Record& line : translation::sale_lines(writer(), effect.what, team_)) {
    log(std::move(line));
  }
}

// ---- what goes out ----

void DdnNode::send(node::NodeNumber to, wire::Sample sample, MissionTime expires) {
  out_.push_back(node::Send{to, std::move(sample), expires});
}

void DdnNode::log(journal::Record line) { out_.push_back(node::Log{std::move(line)}); }

}  // namespace skein::ddn
