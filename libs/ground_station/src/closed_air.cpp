// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/closed_air.hpp"

namespace skein::ground_station {

void ClosedAir::note(const Request& request) {
  const auto* change = std::get_if<mission::ChangeWorld>(&request);
  if (change == nullptr || change->place || change->ground) return;
  if (change->remove) {
    volumes_.erase(change->volume.name);
  } else {
    volumes_.insert_or_assign(change->volume.name, change->volume);
  }
}

}  // namespace skein::ground_station
