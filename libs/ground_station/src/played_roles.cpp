// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/played_roles.hpp"

#include <algorithm>

namespace skein::ground_station {

void PlayedRoles::play(const PlayRole& play) {
  played_.emplace(play.uav, executive::TaskId(play.task.id.value()));
}

TaskEventReceived PlayedRoles::note(const PlayedTaskChanged& changed) {
  const executive::TaskEvent& event = changed.event;
  if (executive::is_terminal(event.state)) played_.erase({changed.uav, event.id});
  return {changed.uav, event.id, event.type, event.state, event.reason, true};
}

std::optional<StopRole> PlayedRoles::stop(const std::string& uav, const std::string& why) const {
  const bool plays = std::any_of(played_.begin(), played_.end(),
                                 [&](const auto& one) { return one.first == uav; });
  if (!plays) return std::nullopt;
  return StopRole{uav, std::nullopt, why};
}

std::optional<StopRole> PlayedRoles::stop(const SendRequest& request) const {
  const auto* abort = std::get_if<executive::Abort>(&request.request);
  if (abort == nullptr || !played_.contains({request.uav, abort->id})) return std::nullopt;
  return StopRole{request.uav, abort->id, "interrupted by " + request.asked_by};
}

}  // namespace skein::ground_station
