// SPDX-License-Identifier: Apache-2.0
#include "interaction/companions.hpp"

namespace skein::decision_node {

std::vector<std::string> Companions::counted_on() const {
  std::vector<std::string> all;
  for (const auto& [uav, role] : my_.holders)
    if (uav != self_ && !ended_.contains(uav)) all.push_back(uav);
  return all;
}

bool Companions::all_have_ended() const { return counted_on().empty(); }

std::vector<Companions::Lost> Companions::lost(MissionTime now) const {
  std::vector<Lost> all;
  for (const std::string& uav : counted_on()) {
    const auto since = partners_.silent_since(uav);
    if (partners_.is_declared_lost(uav)) {
      all.push_back({uav, "'" + uav + "' is declared lost"});
    } else if (since && *since + kLostAfter <= now) {
      all.push_back({uav, partners_.silence_of(uav)});
    }
  }
  return all;
}

std::optional<MissionTime> Companions::next_loss() const {
  std::optional<MissionTime> next;
  for (const std::string& uav : counted_on())
    if (const auto since = partners_.silent_since(uav)) next = earliest(next, *since + kLostAfter);
  return next;
}

std::optional<MissionTime> Companions::next_given_up(MissionTime waits_since) const {
  std::optional<MissionTime> next;
  for (const std::string& uav : my_.joint.members)
    if (uav != self_) next = earliest(next, partners_.gives_up_at(uav, waits_since));
  return next;
}

}  // namespace skein::decision_node
