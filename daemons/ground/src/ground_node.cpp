// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/ground_node.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/foundation/fingerprint.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/alarm_name.hpp"
#include "skein/translation/functional_layer.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;
using translation::for_journal;
using translation::from_wire;
using translation::to_wire;

wire::AlarmState wire_state(gs::AlarmState state) {
  switch (state) {
    case gs::AlarmState::kRaised:
      return wire::AlarmState::kRaised;
    case gs::AlarmState::kConfirmed:
      return wire::AlarmState::kConfirmed;
    case gs::AlarmState::kInfirmed:
      break;
  }
  return wire::AlarmState::kInfirmed;
}

}  // namespace

GroundNode::GroundNode(const gs::GroundConfig& config, world::Terrain terrain, node::Roster roster,
                       ReadRequest read_request, std::optional<team::Config> team,
                       std::vector<decision_node::Config> played)
    : terrain_(std::move(terrain)),
      roster_(std::move(roster)),
      read_request_(std::move(read_request)),
      control_(config, terrain_),
      roles_(std::move(played), roster_),
      dates_(roster_, config.dates),
      alarms_age_(config.pps.tell_again > Duration()) {
  if (!team || !team->roster.number_of("ground")) return;
  std::vector<std::string> uavs;
  for (const gs::GroundUav& uav : config.uavs) uavs.push_back(uav.name);
  team_.emplace(*team, "ground", config.missions, std::move(uavs));
}

node::Effects GroundNode::handle(const node::Input& input, MissionTime now) {
  now_ = now;
  out_.clear();
  happened_ = false;
  auto dates = dates_.hear(input, now);
  const bool of_dates = dates && std::holds_alternative<node::Received>(input);
  for (node::Effect& effect : dates.value_or(node::Effects())) out_.push_back(std::move(effect));
  const bool of_team = of_dates || hear_team(input);
  const bool of_partner = !of_team && hear_of_roles(input);
  const auto mine = of_team || of_partner ? std::nullopt : input_of(input);
  tell_control(mine.value_or(Input(gs::Tick{})));
  if (!of_team && team_ && team_->next_wakeup() && *team_->next_wakeup() <= now) {
    tell_team(gs::Tick{});
  }
  carry_out(roles_.time_passes(now));
  const bool located = mine && std::holds_alternative<gs::TelemetryReceived>(*mine);
  boards_.something_happened(mine || happened_, !located || happened_);
  if (boards_.is_due(now)) {
    for (wire::Sample& board : boards_.news(control_, team_ ? &*team_ : nullptr, roster_, now)) {
      out_.push_back(node::Publish{std::move(board)});
    }
  }
  return std::move(out_);
}

std::optional<MissionTime> GroundNode::next_wakeup() const {
  const auto wakeup =
      earliest(earliest(control_.next_wakeup(), boards_.next_wakeup()), roles_.next_wakeup());
  return team_ ? earliest(wakeup, team_->next_wakeup()) : wakeup;
}

// ---- what comes in ----

std::optional<GroundNode::Input> GroundNode::input_of(const node::Input& input) {
  if (const auto* received = std::get_if<node::Received>(&input)) {
    const std::string why = why_not(*received);
    if (why.empty()) return input_from(*received);
    drop(*received, {"header.origin", why});
  }
  if (const auto* delivered = std::get_if<node::Delivered>(&input)) {
    return gs::CommandDelivered{gs::CommandNumber(delivered->receipt)};
  }
  if (const auto* lost = std::get_if<node::Undelivered>(&input)) {
    // Of one that may have arrived the answer is waited for, as of any.
    if (lost->receipt == 0 || lost->may_have_arrived) return std::nullopt;
    return gs::CommandUndelivered{gs::CommandNumber(lost->receipt)};
  }
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    if (!is_uav(reach->peer)) return std::nullopt;
    return gs::PeerReachable{roster_.name_of(reach->peer), reach->reachable, reach->restarted};
  }
  return std::nullopt;
}

bool GroundNode::is_uav(node::NodeNumber number) const {
  const node::Member* member = roster_.find(number);
  return member != nullptr && member->role == wire::Role::kDdn;
}

std::string GroundNode::why_not(const node::Received& received) const {
  if (std::holds_alternative<wire::OperatorRequest>(received.sample)) {
    return received.from == roster_.operators() ? "" : "not an operator";
  }
  if (!is_uav(received.from)) return "not a UAV of this mission";
  if (const auto* reply = std::get_if<wire::RequestReply>(&received.sample)) {
    if (!is_addressee(reply->command, received.from)) return "the command was another UAV's";
  }
  return "";
}

bool GroundNode::is_addressee(std::uint64_t command, node::NodeNumber from) const {
  const auto addressee = addressees_.find(command);
  return addressee == addressees_.end() || addressee->second == from;
}

void GroundNode::drop(const node::Received& received, const wire::Violation& violation) {
  const wire::Slot slot = wire::slot_of(received.sample);
  if (!dropped_.emplace(received.from, slot).second) return;
  log(record("dropped")
          .with("slot", wire::slot_name(slot))
          .with("origin", roster_.name_of(received.from))
          .with("field", violation.field)
          .with("why", violation.why));
}

// A UAV is known by the node that sent the sample, whatever name the sample gives.
std::optional<GroundNode::Input> GroundNode::input_from(const node::Received& received) {
  const std::string uav = roster_.name_of(received.from);
  const wire::Sample& sample = received.sample;
  if (const auto* request = std::get_if<wire::OperatorRequest>(&sample)) {
    return request_from(*request);
  }
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) {
    world::Telemetry told = from_wire(*telemetry);
    told.uav = uav;
    return told;
  }
  if (const auto* report = std::get_if<wire::PerceptionReport>(&sample)) {
    world::Perception perception = from_wire(*report);
    perception.uav = uav;
    return gs::PerceptionReceived{std::move(perception)};
  }
  if (const auto* event = std::get_if<wire::TaskEvent>(&sample)) {
    return gs::TaskEventReceived{uav, executive::TaskId(event->id), event->type,
                                 from_wire(event->state), event->reason};
  }
  if (const auto* reply = std::get_if<wire::RequestReply>(&sample)) {
    return gs::RequestReplyReceived{gs::CommandNumber(reply->command), reply->accepted, reply->why};
  }
  if (const auto* status = std::get_if<wire::FunctionalStatus>(&sample)) {
    return gs::FunctionalStatusReceived{uav, from_wire(*status)};
  }
  if (const auto* sync = std::get_if<wire::SyncMessage>(&sample)) {
    const executive::SyncReceived message = from_wire(*sync);
    return gs::SyncReceived{message.id, message.from, sync->to, message.word, message.said};
  }
  if (const auto* board = std::get_if<wire::PlanBoard>(&sample)) {
    gs::PlanBoardReceived result = std::get<gs::PlanBoardReceived>(input_of(*board));
    result.uav = uav;
    return result;
  }
  return input_of_mission(uav, received);
}

GroundNode::Input GroundNode::request_from(const wire::OperatorRequest& request) const {
  gs::OperatorRequest asked{request.who, request.number,
                            Fingerprint().put(request.request).value()};
  if (!read_request_) {
    asked.problems = {"this ground station takes no requests"};
  } else if (auto deeds = read_request_(request.request)) {
    asked.deeds = std::move(*deeds);
  } else {
    asked.problems = std::move(deeds.error());
  }
  return asked;
}

std::optional<GroundNode::Input> GroundNode::input_of_mission(const std::string& uav,
                                                              const node::Received& received) {
  const wire::Sample& sample = received.sample;
  const auto at = MissionTime::nanoseconds(wire::header_of(sample).mission_time);
  if (const auto* plan = std::get_if<wire::MissionPlan>(&sample)) {
    const auto read = from_wire(*plan);
    if (read) return gs::MissionPlanReceived{uav, *read, at};
    drop(received, read.error());
  } else if (const auto* hand_over = std::get_if<wire::HandOver>(&sample)) {
    const auto read = from_wire(*hand_over);
    if (read) return gs::HandOverReceived{uav, *read, at};
    drop(received, read.error());
  } else if (const auto* decision = std::get_if<wire::Decision>(&sample)) {
    return gs::DecisionReceived{uav, from_wire(*decision)};
  } else if (const auto* outcome = std::get_if<wire::MissionOutcome>(&sample)) {
    return gs::MissionOutcomeReceived{uav, from_wire(*outcome)};
  }
  return std::nullopt;
}

GroundNode::Input GroundNode::input_of(const wire::PlanBoard& board) const {
  gs::PlanBoardReceived result{board.uav,
                               board.degree,
                               board.airborne,
                               {},
                               MissionTime::nanoseconds(board.header.mission_time),
                               {}};
  for (const wire::TaskEntry& task : board.tasks) {
    result.tasks.push_back({executive::TaskId(task.id), task.type, from_wire(task.state)});
  }
  for (const wire::ModelVersion& one : board.models) result.models[one.model] = one.version;
  return result;
}

// ---- what goes out ----

wire::Sample GroundNode::sample_of(const gs::SendRequest& effect) const {
  const auto numbered = [&](auto sample) -> wire::Sample {
    sample.command = effect.command.value();
    return sample;
  };
  return std::visit(
      Overloaded{
          [&](const mission::UnitMission& it) { return numbered(to_wire(it)); },
          [&](const mission::CancelGoals& it) { return numbered(to_wire(it, effect.asked_by)); },
          [&](const mission::ChangeDegree& it) { return numbered(to_wire(it, effect.asked_by)); },
          [&](const mission::ChangeWorld& it) { return numbered(to_wire(it)); },
          [&](const auto& it) { return numbered(to_wire(translation::Request(it))); }},
      effect.request);
}

void GroundNode::carry_out(const gs::SendRequest& effect) {
  addressees_.insert_or_assign(effect.command.value(), roster_.find(effect.uav)->number);
  send(effect.uav, sample_of(effect), effect.expires, effect.command.value());
  if (const auto* change = std::get_if<mission::ChangeWorld>(&effect.request)) {
    carry_out(roles_.tell(effect.uav, decision_node::PlaceTold{*change}, now_));
  }
}

void GroundNode::carry_out(const gs::SendFunctional& effect) {
  send(effect.uav, to_wire(effect.uav, effect.request));
}

void GroundNode::carry_out(const gs::SendSync& effect) {
  send(effect.to,
       to_wire(executive::SendSync{effect.id, effect.to, effect.word}, effect.from, effect.said));
}

void GroundNode::carry_out(const gs::TellAlarm& effect) {
  const gs::Alarm& alarm = effect.alarm;
  wire::Alarm sample;
  sample.id = alarm.id.value();
  sample.state = wire_state(alarm.state);
  sample.position = to_wire(alarm.position);
  sample.radius = alarm.radius;
  sample.belief = alarm.belief;
  if (alarms_age_) sample.seen = alarm.last_seen.count();
  for (const node::Member& member : roster_.members()) {
    const bool meant = effect.uav.empty() || member.name == effect.uav;
    if (member.role != wire::Role::kDdn || !meant) continue;
    send(member.name, sample);
    carry_out(
        roles_.tell(member.name, decision_node::PlaceTold{translation::change_of(sample)}, now_));
  }
  if (team_) tell_team(gs::PlaceKnown{mission::name_of_alarm(alarm.id.value())});
}

// What is followed is on the ground.
void GroundNode::carry_out(const gs::ObjectSeen& effect) {
  const double ground = terrain_.elevation(effect.position.x(), effect.position.y());
  const world::Vector3 at(effect.position.x(), effect.position.y(), ground);
  wire::SeenObject sample;
  sample.header.instance = translation::truth_instance(effect.name);
  sample.name = effect.name;
  sample.kind = effect.kind;
  sample.at = to_wire(at);
  sample.spread = effect.spread;
  sample.seen = effect.seen.count();
  for (const node::Member& member : roster_.members()) {
    if (member.role != wire::Role::kDdn) continue;
    send(member.name, sample);
    carry_out(
        roles_.tell(member.name, decision_node::PlaceTold{translation::change_of(sample)}, now_));
  }
  log(record("seen")
          .with("name", effect.name)
          .with("type", effect.kind)
          .with("position", for_journal(at))
          .with("spread", journal::rounded(effect.spread))
          .with("when", journal::rounded(effect.seen.to_seconds())));
}

void GroundNode::carry_out(const gs::AlarmEvent& effect) {
  const gs::Alarm& alarm = effect.alarm;
  carry_out(gs::TellAlarm{alarm, {}});
  log(record("alarm")
          .with("alarm", alarm.id.value())
          .with("state", to_text(alarm.state))
          .with("position", for_journal(alarm.position))
          .with("belief", journal::rounded(alarm.belief)));
}

// ---- the event log ----

void GroundNode::carry_out(const gs::OperatorAnswered& effect) {
  out_.push_back(node::Publish{operator_reply(effect)});
}

void GroundNode::carry_out(const gs::OperatorAsked& effect) {
  journal::Record line = record("asked")
                             .with("who", effect.who)
                             .with("number", effect.number)
                             .with("what", effect.what)
                             .with("accepted", effect.accepted);
  if (!effect.why.empty()) line.with("why", effect.why);
  log(line);
}

void GroundNode::carry_out(const gs::HandChanged& effect) {
  journal::Record line = record("hand").with("uav", effect.uav);
  if (!effect.hand.holder.empty()) line.with("holder", effect.hand.holder);
  if (!effect.hand.asker.empty()) line.with("asker", effect.hand.asker);
  log(line);
}

void GroundNode::carry_out(const gs::CommandChanged& effect) {
  journal::Record line = record("command")
                             .with("uav", effect.uav)
                             .with("command", effect.command.value())
                             .with("what", effect.what)
                             .with("state", to_text(effect.state));
  if (!effect.why.empty()) line.with("why", effect.why);
  log(line);
  const bool failed =
      effect.state == gs::CommandState::kRefused || effect.state == gs::CommandState::kExpired;
  if (!failed || !effect.task) return;
  carry_out(roles_.tell(effect.uav, decision_node::TaskRefused{*effect.task, effect.why}, now_));
}

void GroundNode::carry_out(const gs::LocalRequestAnswered& effect) {
  log(translation::request_line(writer(), effect.uav, effect.reply, effect.mode));
}

void GroundNode::carry_out(const gs::LocalTaskEvent& effect) {
  log(translation::task_line(writer(), effect.uav, effect.event, effect.parameters));
  // The UAV does not hear of these from its functional layer.
  if (!effect.functional || is_terminal(effect.event.state)) {
    send(effect.uav, to_wire(effect.uav, effect.event, now_));
  }
  carry_out(roles_.tell(effect.uav, effect.event, now_));
}

void GroundNode::carry_out(const gs::LocalSync& effect) {
  const bool sent = effect.direction == gs::SyncDirection::kSent;
  log(translation::sync_line(writer(), {effect.id, effect.from, effect.to, sent, effect.word}));
}

void GroundNode::carry_out(const gs::HeldPlanChanged& effect) {
  log(record("held")
          .with("uav", effect.uav)
          .with("tasks", static_cast<std::int64_t>(effect.tasks))
          .with("state", to_text(effect.state)));
}

void GroundNode::carry_out(const gs::PerceptionLogged& effect) {
  log(record("perception")
          .with("uav", effect.uav)
          .with("device", effect.device)
          .with("detections", static_cast<std::int64_t>(effect.detections)));
}

void GroundNode::carry_out(const gs::PhaseEntered& effect) {
  wire::MissionState state;
  state.phase = effect.name;
  out_.push_back(node::Publish{state});
  log(record("phase").with("name", effect.name));
}

void GroundNode::carry_out(const gs::StepDone& effect) {
  log(record("step").with("name", effect.name));
}

void GroundNode::carry_out(const gs::OperatorDid& effect) {
  log(record("operator").with("does", effect.does));
}

void GroundNode::carry_out(const gs::UavRestarted& effect) {
  log(record("notice")
          .with("uav", effect.uav)
          .with("text", "restarted; " + std::to_string(effect.lost.size()) + " tasks lost"));
}

void GroundNode::carry_out(const gs::Anomaly& effect) {
  log(record("notice").with("text", effect.why));
}

void GroundNode::carry_out(const gs::MissionFinished&) {
  wire::MissionState state;
  state.phase = control_.phase();
  state.finished = true;
  state.outcome = "finished";
  out_.push_back(node::Publish{state});
  log(record("mission").with("state", "finished"));
  out_.push_back(node::Finish{});
}

void GroundNode::send(const std::string& uav, wire::Sample sample, MissionTime expires,
                      std::uint64_t receipt) {
  const node::Member* to = roster_.find(uav);
  SKEIN_EXPECTS(to != nullptr);
  out_.push_back(node::Send{to->number, std::move(sample), expires, receipt});
}

void GroundNode::log(journal::Record line) { out_.push_back(node::Log{std::move(line)}); }

journal::Record GroundNode::record(const char* kind) const { return {now_, "ground", kind}; }

}  // namespace skein::ground
