// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/ground_node.hpp"

#include "skein/foundation/contract.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/mission/alarm_name.hpp"
#include "skein/translation/functional_layer.hpp"
#include "skein/translation/missions.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ground {

namespace lines = journal::lines;

namespace {

namespace gs = ground_station;
using translation::for_journal;
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
      inbox_(roster_, std::move(read_request)),
      control_(config, terrain_),
      roles_(std::move(played), roster_),
      dates_(roster_, config.dates),
      alarms_age_(config.pps.tell_again > Duration()) {
  if (!team || !team->roster.number_of("ground")) return;
  std::vector<std::string> uavs;
  for (const gs::GroundUav& uav : config.uavs) uavs.push_back(uav.name);
  team_.emplace(*team, "ground", config.missions, std::move(uavs));
  for (const gs::GroundUav& uav : config.uavs)
    team_->handle(gs::DegreeChanged{uav.name, uav.degree}, MissionTime());
}

node::Effects GroundNode::handle(const node::Input& input, MissionTime now) {
  now_ = now;
  out_.clear();
  if (std::holds_alternative<node::Restarted>(input)) {
    tell_control(gs::Resumed{});
    return std::move(out_);
  }
  happened_ = false;
  auto dates = dates_.hear(input, now);
  const bool of_dates = dates && std::holds_alternative<node::Received>(input);
  for (node::Effect& effect : dates.value_or(node::Effects())) out_.push_back(std::move(effect));
  auto air = air_ ? air_->hear(input, now) : std::nullopt;
  for (node::Effect& effect : air.value_or(node::Effects())) out_.push_back(std::move(effect));
  const bool of_team = of_dates || air || hear_team(input);
  const bool of_partner = !of_team && hear_of_roles(input);
  auto [mine, refusal] = of_team || of_partner ? Inbox::Read() : inbox_.read(input, now);
  log(std::move(refusal));
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

node::Effects GroundNode::end_recall() {
  node::Effects boards;
  for (wire::Sample& board : boards_.be_read(control_, team_ ? &*team_ : nullptr, roster_))
    boards.emplace_back(node::Publish{std::move(board)});
  return boards;
}

std::optional<MissionTime> GroundNode::next_wakeup() const {
  const auto wakeup =
      earliest(earliest(control_.next_wakeup(), boards_.next_wakeup()), roles_.next_wakeup());
  return team_ ? earliest(wakeup, team_->next_wakeup()) : wakeup;
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
  inbox_.sent(effect.command.value(), roster_.find(effect.uav)->number);
  send(effect.uav, sample_of(effect), effect.expires, effect.command.value());
  if (const auto* change = std::get_if<mission::ChangeWorld>(&effect.request)) {
    carry_out(roles_.tell(effect.uav, decision_node::PlaceTold{*change}, now_));
  }
}

void GroundNode::carry_out(const gs::SendFunctional& effect) {
  send(effect.uav, to_wire(effect.uav, effect.request), effect.expires);
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
  log(lines::Seen{.name = effect.name,
                  .type = effect.kind,
                  .position = for_journal(at),
                  .spread = journal::rounded(effect.spread),
                  .when = journal::rounded(effect.seen.to_seconds())});
}

void GroundNode::carry_out(const gs::AlarmEvent& effect) {
  const gs::Alarm& alarm = effect.alarm;
  carry_out(gs::TellAlarm{alarm, {}});
  log(lines::Alarm{.alarm = alarm.id.value(),
                   .state = to_text(alarm.state),
                   .position = for_journal(alarm.position),
                   .belief = journal::rounded(alarm.belief)});
}

// ---- the event log ----

void GroundNode::carry_out(const gs::OperatorAnswered& effect) {
  out_.push_back(node::Publish{operator_reply(effect)});
}

void GroundNode::carry_out(const gs::CommandChanged& effect) {
  log(lines::Command{.uav = effect.uav,
                     .command = effect.command.value(),
                     .what = effect.what,
                     .state = to_text(effect.state),
                     .why = effect.why});
  const bool failed =
      effect.state == gs::CommandState::kRefused || effect.state == gs::CommandState::kExpired;
  if (!failed || !effect.task) return;
  carry_out(roles_.tell(effect.uav, decision_node::TaskRefused{*effect.task, effect.why}, now_));
}

void GroundNode::carry_out(const gs::LocalTaskEvent& effect) {
  log(translation::task_line(writer(), effect.uav, effect.event, effect.parameters));
  // The UAV does not hear of these from its functional layer.
  if (!effect.functional || is_terminal(effect.event.state)) {
    send(effect.uav, to_wire(effect.uav, effect.event, now_));
  }
  carry_out(roles_.tell(effect.uav, effect.event, now_));
}

void GroundNode::carry_out(const gs::PhaseEntered& effect) {
  wire::MissionState state;
  state.phase = effect.name;
  out_.push_back(node::Publish{state});
  log(lines::Phase{effect.name});
}

void GroundNode::carry_out(const gs::MissionFinished&) {
  wire::MissionState state;
  state.phase = control_.phase();
  state.finished = true;
  state.outcome = "finished";
  out_.push_back(node::Publish{state});
  log(lines::Mission{"finished"});
  out_.push_back(node::Finish{});
}

void GroundNode::send(const std::string& uav, wire::Sample sample, MissionTime expires,
                      std::uint64_t receipt) {
  const node::Member* to = roster_.find(uav);
  SKEIN_EXPECTS(to != nullptr);
  out_.push_back(node::Send{to->number, std::move(sample), expires, receipt});
}

void GroundNode::log(std::optional<journal::Record> line) {
  if (line) out_.push_back(node::Log{std::move(*line)});
}

}  // namespace skein::ground
