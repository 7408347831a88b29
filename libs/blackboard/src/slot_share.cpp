// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/slot_share.hpp"

namespace skein::blackboard {
namespace {

constexpr double kForEvents = 0.5;
constexpr double kForStates = 0.2;
constexpr double kForHeartbeats = 0.1;
constexpr double kForStreams = 0.2;

double count_of(wire::SlotClass which) {
  double count = 0;
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
    const auto slot = static_cast<wire::Slot>(i);
    if (slot != wire::Slot::kHeartbeat && wire::slot_class(slot) == which) ++count;
  }
  return count;
}

SlotShare share_of(wire::Slot slot) {
  if (slot == wire::Slot::kHeartbeat) return {kForHeartbeats, 5};
  switch (wire::slot_class(slot)) {
    case wire::SlotClass::kEvent:
      return {kForEvents / count_of(wire::SlotClass::kEvent), 6};
    case wire::SlotClass::kState:
      return {kForStates / count_of(wire::SlotClass::kState), 4};
    case wire::SlotClass::kStream:
      break;
  }
  const std::uint8_t priority = slot == wire::Slot::kTelemetry ? 3 : 2;
  return {kForStreams / count_of(wire::SlotClass::kStream), priority};
}

}  // namespace

SlotShares default_shares() {
  SlotShares shares;
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = share_of(static_cast<wire::Slot>(i));
  return shares;
}

double reserved(const SlotShares& shares) {
  double sum = 0;
  for (const SlotShare& share : shares) sum += share.fraction;
  return sum;
}

}  // namespace skein::blackboard
