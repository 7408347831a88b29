// SPDX-License-Identifier: Apache-2.0
// The ground station as a member of the team.
#include "ground_lines.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/ground/ground_node.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/team.hpp"
#include "skein/mission/lost_uav.hpp"
#include "skein/team_translation/team.hpp"
#include "skein/team_translation/team_lines.hpp"

namespace skein::ground {

namespace lines = journal::lines;

namespace {

namespace gs = ground_station;

/// Who is out of reach for so long is not told any more that another one is lost.
constexpr Duration kStillNews = Duration::milliseconds(600'000);

}  // namespace

// What makes no sense is as if it had not come: it is said again.
bool GroundNode::hear_team(const node::Input& input) {
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    const std::string peer = roster_.name_of(reach->peer);
    if (reach->reachable) {
      out_of_reach_.erase(peer);
      tell_if_lost(peer);
    } else {
      out_of_reach_.insert(peer);
    }
  }
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr) return false;
  const auto* about = std::get_if<wire::TeamMessage>(&received->sample);
  const auto* sale = std::get_if<wire::TeamSale>(&received->sample);
  if (about == nullptr && sale == nullptr) return false;
  if (!team_ || !inbox_.is_uav(received->from)) return true;
  auto message = about != nullptr ? translation::from_wire(*about) : translation::from_wire(*sale);
  if (message) {
    tell_team(gs::TeamHeard{roster_.name_of(received->from), std::move(*message)});
  } else {
    log(inbox_.refuse(*received, message.error(), now_));
  }
  return true;
}

// What has a line of its own is only logged.
template <class Effect>
void GroundNode::tell_or_do(const Effect& effect) {
  const auto one_way = [this](const auto& one) {
    if constexpr (requires { line_of(writer(), one); }) {
      log(line_of(writer(), one));
    } else {
      carry_out(one);
    }
  };
  std::visit(one_way, effect);
}

void GroundNode::tell_control(const Input& input) {
  const auto effects = control_.handle(input, now_);
  happened_ = happened_ || !effects.empty();
  for (const auto& effect : effects) {
    tell_or_do(effect);
    const auto* degree = std::get_if<gs::DegreeChanged>(&effect);
    if (degree != nullptr && team_) tell_team(*degree);
  }
}

void GroundNode::tell_team(const gs::TeamDesk::Input& input) {
  if (!team_) return log(lines::Notice{.text = "the ground station is in no team"});
  for (const auto& effect : team_->handle(input, now_)) tell_or_do(effect);
}

void GroundNode::carry_out(const gs::GiveGlobalMission& effect) {
  if (team_) return tell_team(effect);
  carry_out(gs::GlobalMissionChanged{effect.mission.id, gs::GlobalStage::kRefused,
                                     "the ground station is in no team"});
}

void GroundNode::carry_out(const gs::DeclareLost& effect) {
  log(lines::LostUav{effect.uav});
  declared_lost_.insert(effect.uav);
  if (team_) tell_team(effect);
  tell_others(effect.uav, mission::lost_message(effect.uav));
  carry_out(roles_.declare_lost(effect.uav, now_));
}

void GroundNode::carry_out(const gs::DeclareFound& effect) {
  log(lines::FoundUav{effect.uav});
  declared_lost_.erase(effect.uav);
  if (team_) tell_team(effect);
  tell_others(effect.uav, mission::found_message(effect.uav));
}

void GroundNode::tell_if_lost(const std::string& uav) {
  if (!declared_lost_.contains(uav)) return;
  log(lines::Notice{.text = "'" + uav +
                            "' is heard, though it was declared lost: it gets no work of the team "
                            "until declare_found takes that back"});
}

void GroundNode::tell_others(const std::string& uav, const std::string& message) {
  for (const auto& [number, name] : roster_.names()) {
    if (!inbox_.is_uav(number) || name == uav) continue;
    tell_control(gs::OperatorCommand{name, executive::ProcessMessage{message}, kStillNews});
  }
}

void GroundNode::carry_out(const gs::TeamTell& effect) {
  if (out_of_reach_.contains(effect.to)) return;
  send(effect.to, translation::to_wire(effect.message));
}

void GroundNode::carry_out(const gs::TeamTaskChanged& effect) {
  log(translation::owner_line(writer(), effect.standing));
  happened_ = true;
  tell_control(effect);
}

void GroundNode::carry_out(const gs::GlobalMissionChanged& effect) {
  log(lines::GlobalMission{
      .mission = effect.mission.value(), .state = gs::to_text(effect.stage), .why = effect.why});
  tell_control(effect);
}

void GroundNode::carry_out(const gs::TeamSaleTold& effect) {
  for (journal::Record& line : translation::sale_lines(writer(), effect.what, team_->roster())) {
    log(std::move(line));
  }
}

}  // namespace skein::ground
