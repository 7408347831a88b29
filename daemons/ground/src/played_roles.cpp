// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/played_roles.hpp"

#include "skein/joint_lines/joint_lines.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/translation/joint_tasks.hpp"
#include "skein/translation/sensing.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ground {

namespace {

namespace dn = decision_node;
namespace gs = ground_station;
using translation::from_wire;
using translation::to_wire;

std::optional<dn::StandInInput> input_of(const std::string& uav, const wire::Sample& sample) {
  if (const auto* message = std::get_if<wire::NegotiationMessage>(&sample)) {
    return from_wire(*message);
  }
  if (const auto* state = std::get_if<wire::JointTaskState>(&sample)) {
    const interaction::JointTaskStatus status = from_wire(*state);
    if (status.uav != uav) {
      return dn::JointTaskTold{status, MissionTime::nanoseconds(state->header.mission_time)};
    }
    const bool left = interaction::is_over(status.phase);
    if (left) return dn::StopPlaying{executive::TaskId(status.task), status.why};
  }
  if (const auto* telemetry = std::get_if<wire::Telemetry>(&sample)) {
    if (telemetry->uav != uav) return dn::PartnerSeen{from_wire(*telemetry)};
    return from_wire(*telemetry);
  }
  if (const auto* event = std::get_if<wire::TaskEvent>(&sample)) return from_wire(*event);
  return std::nullopt;
}

/// Of others than the UAV whose node sent it.
bool is_of_partner(const std::string& uav, const wire::Sample& sample) {
  const auto* telemetry = std::get_if<wire::Telemetry>(&sample);
  return telemetry != nullptr && telemetry->uav != uav;
}

/// What a stand-in says and notes, as samples for the node of its UAV and as lines.
class Said {
 public:
  Said(const std::string& uav, node::NodeNumber number, MissionTime now, node::Effects& out)
      : uav_(uav), number_(number), now_(now), out_(out) {}

  void carry_out(const dn::SendNegotiation& effect) {
    out_.push_back(node::Send{number_, to_wire(effect.message, effect.to)});
  }
  void carry_out(const dn::JointTaskChanged& effect) {
    log(joint_lines::line_of(writer(), uav_, effect.status));
    out_.push_back(node::Send{number_, to_wire(effect.status), MissionTime::max()});
  }
  void carry_out(const dn::Notice& effect) {
    log(writer().record(journal::lines::Notice{uav_, effect.text}));
  }
  template <class Other>
  void carry_out(const Other& effect) {
    if constexpr (requires { joint_lines::line_of(writer(), uav_, effect); }) {
      log(joint_lines::line_of(writer(), uav_, effect));
    }
  }

 private:
  translation::Writer writer() const { return {now_, "ground"}; }
  void log(journal::Record line) { out_.push_back(node::Log{std::move(line)}); }

  const std::string& uav_;
  node::NodeNumber number_;
  MissionTime now_;
  node::Effects& out_;
};

void add(PlayedRoles::Outcome one, PlayedRoles::Outcome& all) {
  all.out.insert(all.out.end(), one.out.begin(), one.out.end());
  all.control.insert(all.control.end(), one.control.begin(), one.control.end());
}

}  // namespace

PlayedRoles::PlayedRoles(std::vector<dn::Config> uavs, const node::Roster& roster)
    : roster_(roster) {
  for (dn::Config& uav : uavs) {
    const std::string name = uav.uav;
    uavs_.emplace(name, dn::StandIn(std::move(uav)));
  }
}

PlayedRoles::Outcome PlayedRoles::tell(const std::string& uav, const dn::StandInInput& input,
                                       MissionTime now) {
  const auto found = uavs_.find(uav);
  if (found == uavs_.end()) return {};
  return outcome_of(uav, found->second.handle(input, now), now);
}

PlayedRoles::Outcome PlayedRoles::declare_lost(const std::string& lost, MissionTime now) {
  Outcome all;
  for (auto& [uav, stand_in] : uavs_)
    if (stand_in.plays())
      add(outcome_of(uav, stand_in.handle(dn::PartnerLost{lost}, now), now), all);
  return all;
}

PlayedRoles::Heard PlayedRoles::hear(const std::string& uav, const wire::Sample& sample,
                                     MissionTime now) {
  const auto found = uavs_.find(uav);
  const auto input = found == uavs_.end() ? std::nullopt : input_of(uav, sample);
  if (!input) return {{}, is_of_partner(uav, sample)};
  return {outcome_of(uav, found->second.handle(*input, now), now), is_of_partner(uav, sample)};
}

PlayedRoles::Outcome PlayedRoles::time_passes(MissionTime now) {
  Outcome all;
  for (auto& [uav, stand_in] : uavs_) {
    const auto next = stand_in.next_wakeup();
    if (!next || *next > now) continue;
    add(outcome_of(uav, stand_in.handle(dn::Tick{}, now), now), all);
  }
  return all;
}

std::optional<MissionTime> PlayedRoles::next_wakeup() const {
  std::optional<MissionTime> next;
  for (const auto& [uav, stand_in] : uavs_) next = earliest(next, stand_in.next_wakeup());
  return next;
}

PlayedRoles::Outcome PlayedRoles::outcome_of(const std::string& uav,
                                             const dn::StandInEffects& effects,
                                             MissionTime now) const {
  Outcome outcome;
  Said said(uav, roster_.find(uav)->number, now, outcome.out);
  for (const dn::Effect& effect : effects.said) {
    std::visit([&](const auto& one) { said.carry_out(one); }, effect);
  }
  for (const mission::Request& request : effects.asked) {
    outcome.control.emplace_back(gs::RoleAsks{uav, request});
  }
  for (const executive::TaskEvent& event : effects.changed) {
    outcome.control.emplace_back(gs::PlayedTaskChanged{uav, event});
  }
  return outcome;
}

}  // namespace skein::ground
