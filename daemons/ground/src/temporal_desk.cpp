// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/temporal_desk.hpp"

#include "skein/team_translation/meetings.hpp"

namespace skein::ground {

namespace {

std::vector<std::string> uavs_of(const node::Roster& roster) {
  std::vector<std::string> uavs;
  for (const node::Member& member : roster.members())
    if (member.role == wire::Role::kDdn) uavs.push_back(member.name);
  return uavs;
}

}  // namespace

TemporalDesk::TemporalDesk(const node::Roster& roster, bool supervises) : roster_(roster) {
  if (supervises) supervisor_.emplace(uavs_of(roster));
}

// Each speaks of itself; what makes no sense is as if it had not come.
std::optional<node::Effects> TemporalDesk::hear(const node::Input& input, MissionTime now) {
  if (const auto* reach = std::get_if<node::Reachability>(&input)) {
    if (!supervisor_) return std::nullopt;
    const auto since = reach->reachable ? std::nullopt : std::optional(now);
    return tell(supervisor_->out_of_reach(roster_.name_of(reach->peer), since), now);
  }
  const auto* received = std::get_if<node::Received>(&input);
  if (received == nullptr) return std::nullopt;
  const auto* told = std::get_if<wire::PlanFrontier>(&received->sample);
  if (told == nullptr) return std::nullopt;
  const std::string from = roster_.name_of(received->from);
  const auto whole = translation::from_wire(*told);
  if (!supervisor_ || !whole || told->uav != from) return node::Effects{};
  node::Effects effects{
      node::Log{translation::frontier_heard({now, "ground"}, "ground", from, from)}};
  for (node::Effect& effect : tell(supervisor_->hear(from, *whole), now))
    effects.push_back(std::move(effect));
  return effects;
}

node::Effects TemporalDesk::tell(const std::vector<temporal::TeamSupervisor::Word>& words,
                                 MissionTime now) const {
  node::Effects effects;
  for (const temporal::TeamSupervisor::Word& word : words) {
    effects.push_back(node::Log{
        translation::frontier_told({now, "ground"}, "ground", word.to, word.about, word.frontier)});
    wire::PlanFrontier sample = translation::to_wire(word.about, word.frontier);
    sample.header.instance = roster_.find(word.about)->number.value();
    effects.push_back(node::Send{roster_.find(word.to)->number, std::move(sample)});
  }
  return effects;
}

}  // namespace skein::ground
