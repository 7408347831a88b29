// SPDX-License-Identifier: Apache-2.0
#include "merging/air_orders.hpp"

namespace skein::decision_node {

supervisor::AirOrders air_orders(const std::string& uav, const std::optional<Waiting>& waiting,
                                 const std::optional<Portions>& portions, const VehicleAir& vehicle,
                                 const merging::Merger& merger) {
  supervisor::AirOrders orders;
  orders.uav = uav;
  const bool has_begun = portions && portions->running;
  if (waiting && !has_begun) orders.for_others = merger.awaited().to_leave();
  if (!orders.for_others.empty()) orders.waits = waiting->request.id;
  if (vehicle.flies()) {
    const functional::TaskId flown = vehicle.flown()->airway.request.id;
    const bool is_portion = portions && portions->flown == flown;
    orders.flies = is_portion ? portions->task() : flown;
  }
  for (const merging::Merger::Waiter& one : merger.waiters())
    (one.for_its_place ? orders.for_its_place : orders.for_its_way).push_back(one.peer);
  return orders;
}

}  // namespace skein::decision_node
