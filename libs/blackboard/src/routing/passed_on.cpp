// SPDX-License-Identifier: Apache-2.0
#include "passed_on.hpp"

namespace skein::blackboard::routing {

bool PassedOn::is_held_by_its_sender(const wire::SampleHeader& header) const {
  const auto found = held_from_.find({header.origin, header.destination});
  return found == held_from_.end() ||
         Version{header.incarnation, header.sequence_number} >= found->second;
}

bool PassedOn::admit(const wire::Sample& sample) {
  const wire::SampleHeader& header = wire::header_of(sample);
  const wire::Slot slot = wire::slot_of(sample);
  if (wire::slot_class(slot) == wire::SlotClass::kEvent) return is_held_by_its_sender(header);
  const Version version{header.incarnation, header.sequence_number};
  Version& newest = newest_[{header.destination, slot, header.origin, header.instance}];
  if (version <= newest) return false;
  newest = version;
  if (const auto* heartbeat = std::get_if<wire::Heartbeat>(&sample)) {
    held_from_[{header.origin, header.destination}] = {header.incarnation, heartbeat->events_from};
  }
  return true;
}

void PassedOn::keep(const wire::Sample& state) {
  const wire::SampleHeader& header = wire::header_of(state);
  states_.insert_or_assign(
      Key{header.destination, wire::slot_of(state), header.origin, header.instance}, state);
}

void PassedOn::forget(std::uint32_t origin) {
  const auto is_of = [&](const auto& one) { return std::get<2>(one.first) == origin; };
  std::erase_if(newest_, is_of);
  std::erase_if(states_, is_of);
  std::erase_if(held_from_, [&](const auto& one) { return one.first.first == origin; });
}

std::vector<wire::Sample> PassedOn::states_for(NodeNumber destination) const {
  std::vector<wire::Sample> states;
  for (auto one = states_.lower_bound({destination.value(), wire::Slot{}, 0, 0});
       one != states_.end() && std::get<0>(one->first) == destination.value(); ++one) {
    states.push_back(one->second);
  }
  return states;
}

}  // namespace skein::blackboard::routing
