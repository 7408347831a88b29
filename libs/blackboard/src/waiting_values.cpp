// SPDX-License-Identifier: Apache-2.0
#include "waiting_values.hpp"

namespace skein::blackboard {

WaitingValues::Key WaitingValues::key_of(const wire::Sample& value) {
  const wire::SampleHeader& header = wire::header_of(value);
  return {wire::slot_of(value), {header.origin, header.destination, header.instance}};
}

bool WaitingValues::put(wire::Sample value) {
  const Key key = key_of(value);
  const bool is_new = values_.insert_or_assign(key, std::move(value)).second;
  if (is_new) order_[key.first].push_back(key.second);
  return !is_new;
}

bool WaitingValues::drop(const wire::Sample& like) {
  const Key key = key_of(like);
  if (values_.erase(key) == 0) return false;
  const auto order = order_.find(key.first);
  std::erase(order->second, key.second);
  if (order->second.empty()) order_.erase(order);
  return true;
}

const wire::Sample* WaitingValues::first(wire::Slot slot) const {
  const auto order = order_.find(slot);
  return order == order_.end() ? nullptr : &values_.at({slot, order->second.front()});
}

void WaitingValues::drop_first(wire::Slot slot) {
  const auto order = order_.find(slot);
  if (order == order_.end()) return;
  values_.erase({slot, order->second.front()});
  order->second.pop_front();
  if (order->second.empty()) order_.erase(order);
}

std::vector<wire::Sample> WaitingValues::take(wire::SlotClass which) {
  std::vector<wire::Sample> taken;
  for (auto order = order_.begin(); order != order_.end();) {
    const wire::Slot slot = (order++)->first;
    if (wire::slot_class(slot) != which) continue;
    for (const wire::Sample* next = first(slot); next != nullptr; next = first(slot)) {
      taken.push_back(*next);
      drop_first(slot);
    }
  }
  return taken;
}

}  // namespace skein::blackboard
