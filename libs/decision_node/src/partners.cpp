// SPDX-License-Identifier: Apache-2.0
#include "partners.hpp"

#include <algorithm>
#include <cmath>

namespace skein::decision_node {

void Partners::resume(MissionTime now) {
  start(now);
  for (auto& [uav, since] : silent_since_)
    if (since) since = now;
}

void Partners::contact(const Contact& contact, MissionTime now) {
  if (contact.ground) {
    if (hears_ground_ && !contact.reachable) ground_silent_since_ = now;
    hears_ground_ = contact.reachable;
    return;
  }
  if (contact.reachable) {
    silent_since_[contact.peer].reset();
    given_up_.erase(contact.peer);
    lost_.erase(contact.peer);
  } else {
    silent_since_[contact.peer] = silent_since(contact.peer).value_or(now);
  }
}

std::optional<MissionTime> Partners::silent_since(const std::string& uav) const {
  const auto known = silent_since_.find(uav);
  return known == silent_since_.end() ? born_ : known->second;
}

std::optional<MissionTime> Partners::gives_up_at(const std::string& uav, MissionTime waits) const {
  if (lost_.contains(uav)) return waits;
  const auto silent = silent_since(uav);
  if (!silent) return std::nullopt;
  return given_up_.contains(uav) ? waits : std::max(*silent, waits) + lease_;
}

std::optional<MissionTime> Partners::gives_up_past_ground_at(const std::string& uav,
                                                             MissionTime waits) const {
  const auto alone = gives_up_at(uav, waits);
  if (!alone || hears_ground_) return std::nullopt;
  return std::max(*alone, ground_silent_since_ + lease_);
}

std::optional<std::string> Partners::given_up(const std::string& uav, MissionTime waits,
                                              MissionTime now) {
  const auto at = gives_up_at(uav, waits);
  if (!at || *at > now) return std::nullopt;
  if (lost_.contains(uav)) return "'" + uav + "' is declared lost";
  given_up_.insert(uav);
  return silence_of(uav);
}

std::string Partners::silence_of(const std::string& uav) const {
  const MissionTime since = *silent_since(uav);
  return "no contact with '" + uav + "' since " + std::to_string(std::lround(since.to_seconds())) +
         (since == born_ ? " s, when this node began" : " s");
}

}  // namespace skein::decision_node
