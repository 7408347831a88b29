// SPDX-License-Identifier: Apache-2.0
// The ground station as one who plays roles for UAVs.
#include "skein/ground/ground_node.hpp"
#include "skein/translation/journal_lines.hpp"

namespace skein::ground {

namespace {

namespace dn = decision_node;
namespace gs = ground_station;

}  // namespace

void GroundNode::carry_out(PlayedRoles::Outcome outcome) {
  for (node::Effect& one : outcome.out) out_.push_back(std::move(one));
  for (const Input& one : outcome.control) {
    if (const auto* changed = std::get_if<gs::PlayedTaskChanged>(&one)) {
      log(translation::task_line(writer(), changed->uav, changed->event, {}));
    }
    tell_control(one);
  }
}

bool GroundNode::hear_of_roles(const node::Input& input) {
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr || !inbox_.is_uav(received->from)) return false;
  PlayedRoles::Heard heard = roles_.hear(roster_.name_of(received->from), received->sample, now_);
  carry_out(std::move(heard.outcome));
  return heard.only_here;
}

void GroundNode::carry_out(const gs::PlayRole& effect) {
  carry_out(roles_.tell(effect.uav, dn::PlayJointTask{effect.task}, now_));
}

void GroundNode::carry_out(const gs::StopRole& effect) {
  carry_out(roles_.tell(effect.uav, dn::StopPlaying{effect.task, effect.why}, now_));
}

}  // namespace skein::ground
