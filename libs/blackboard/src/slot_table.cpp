// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/slot_table.hpp"

#include <algorithm>

#include "shipped_slots.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

constexpr std::array<std::string_view, kParties> kNames{"ground",   "uav",    "functional", "sim",
                                                        "operator", "others", "world"};

template <class Wanted>
std::vector<wire::Slot> slots_that(const Wanted& wanted) {
  std::vector<wire::Slot> slots;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
    const auto slot = static_cast<wire::Slot>(i);
    if (wanted(i)) slots.push_back(slot);
  }
  return slots;
}

constexpr auto kHeartbeat = static_cast<std::size_t>(wire::Slot::kHeartbeat);

}  // namespace

std::string_view name_of(Party party) { return kNames[static_cast<std::size_t>(party)]; }

const SlotTable& SlotTable::shipped() {
  static const SlotTable table = [] {
    auto read = read_slot_table(shipped_slots(), "slots.yaml", SlotTable());
    SKEIN_EXPECTS(read.has_value());
    return std::move(*read);
  }();
  return table;
}

std::vector<wire::Slot> SlotTable::between(Party from, Party to) const {
  const bool is_world = from == Party::kWorld || to == Party::kWorld;
  return slots_that([&](std::size_t i) {
    return flows_[i].contains({from, to}) && (is_world || i != kHeartbeat);
  });
}

std::vector<wire::Slot> SlotTable::relayed() const {
  return slots_that([&](std::size_t i) { return relayed_[i] && i != kHeartbeat; });
}

std::vector<wire::Slot> SlotTable::of_world() const {
  return slots_that([&](std::size_t i) {
    for (const auto& [from, to] : flows_[i])
      if (from == Party::kWorld || to == Party::kWorld) return true;
    return false;
  });
}

SlotTable SlotTable::with_lifespan(wire::Slot slot, Duration at_least) const {
  SlotTable other = *this;
  auto& lifespan = other.lifespans_[static_cast<std::size_t>(slot)];
  if (lifespan) lifespan = std::max(*lifespan, at_least);
  return other;
}

}  // namespace skein::blackboard
