// SPDX-License-Identifier: Apache-2.0
// The ground station as a member of the team.
#include "skein/foundation/joined.hpp"
#include "skein/ground/ground_node.hpp"
#include "skein/translation/team.hpp"
#include "skein/translation/team_lines.hpp"

namespace skein::ground {

namespace {

namespace gs = ground_station;

}  // namespace

// What makes no sense is as if it had not come: it is said again.
bool GroundNode::hear_team(const node::Input& input) {
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    const std::string peer = roster_.name_of(reach->peer);
    if (reach->reachable) {
      out_of_reach_.erase(peer);
    } else {
      out_of_reach_.insert(peer);
    }
  }
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr) return false;
  const auto* about = std::get_if<wire::TeamMessage>(&received->sample);
  const auto* sale = std::get_if<wire::TeamSale>(&received->sample);
  if (about == nullptr && sale == nullptr) return false;
  if (!team_ || !is_uav(received->from)) return true;
  auto message = about != nullptr ? translation::from_wire(*about) : translation::from_wire(*sale);
  if (message) {
    tell_team(gs::TeamHeard{roster_.name_of(received->from), std::move(*message)});
  } else {
    drop(*received, message.error());
  }
  return true;
}

void GroundNode::tell_control(const Input& input) {
  const auto effects = control_.handle(input, now_);
  happened_ = happened_ || !effects.empty();
  for (const auto& effect : effects) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
}

void GroundNode::tell_team(const gs::TeamDesk::Input& input) {
  if (!team_) return log(record("notice").with("text", "the ground station is in no team"));
  for (const auto& effect : team_->handle(input, now_)) {
    std::visit([this](const auto& one) { carry_out(one); }, effect);
  }
}

void GroundNode::carry_out(const gs::DeclareLost& effect) {
  log(record("lost-uav").with("uav", effect.uav));
  tell_team(effect);
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
  journal::Record line = record("global-mission")
                             .with("mission", effect.mission.value())
                             .with("state", gs::to_text(effect.stage));
  if (!effect.why.empty()) line.with("why", effect.why);
  log(line);
  tell_control(effect);
}

void GroundNode::carry_out(const gs::TeamSaleTold& effect) {
  for (journal::Record& line : translation::sale_lines(writer(), effect.what, team_->roster())) {
    log(std::move(line));
  }
}

void GroundNode::carry_out(const gs::TeamTokenChanged& effect) {
  log(translation::token_line(writer(), effect.held, effect.term));
}

}  // namespace skein::ground
