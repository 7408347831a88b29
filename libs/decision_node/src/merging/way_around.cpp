// SPDX-License-Identifier: Apache-2.0
#include "merging/way_around.hpp"

#include <utility>

#include "core.hpp"
#include "skein/supervisor/way_home.hpp"

namespace skein::decision_node {

void WayAround::search(const functional::Request& request, const merging::Volumes& taken,
                       const AirwaySituation& situation) {
  if (for_) return;
  auto query = query_around(request, taken, *core_.config().merging, situation);
  if (!query) return;
  for_ = request.id;
  core_.bus().emit(StartWaySearch{++searches_, {std::move(*query), core_.deliberation().world()}});
}

std::optional<functional::TaskId> WayAround::over(const WaySearched& done) {
  return done.job == searches_ ? std::exchange(for_, std::nullopt) : std::nullopt;
}

std::optional<Airway> WayAround::along(const refiners::Path& path,
                                       const functional::Request& request,
                                       const merging::Volumes& taken,
                                       const AirwaySituation& situation) const {
  auto around = airway_along(request, path, taken, *core_.config().merging, situation);
  if (!around) return std::nullopt;
  const double home = supervisor::least_to_come_home(
      *core_.config().knowledge, *core_.deliberation().world(), core_.bus().now(), *around->end);
  return around->energy + home > situation.state.energy ? std::nullopt : around;
}

}  // namespace skein::decision_node
