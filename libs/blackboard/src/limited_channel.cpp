// SPDX-License-Identifier: Apache-2.0
#include "limited_channel.hpp"

#include <algorithm>

#include "skein/blackboard/transport.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

constexpr std::size_t kHeartbeats = 0, kEvents = 1, kParts = 2, kFirstValue = 3;

bool is_value(wire::Slot slot) {
  return slot != wire::Slot::kHeartbeat && slot != wire::Slot::kPart &&
         wire::slot_class(slot) != wire::SlotClass::kEvent;
}

std::vector<wire::Slot> values_among(const std::vector<wire::Slot>& slots) {
  std::vector<wire::Slot> values;
  std::copy_if(slots.begin(), slots.end(), std::back_inserter(values), is_value);
  return values;
}

const SlotShare& share_of(const SlotShares& shares, wire::Slot slot) {
  return shares[static_cast<std::size_t>(slot)];
}

std::vector<SlotShare> flows_of(const std::vector<wire::Slot>& slots, const SlotShares& shares) {
  const bool parts = std::ranges::find(slots, wire::Slot::kPart) != slots.end();
  std::vector<SlotShare> flows{share_of(shares, wire::Slot::kHeartbeat),
                               {},
                               parts ? share_of(shares, wire::Slot::kPart) : SlotShare{}};
  for (const wire::Slot slot : slots) {
    const SlotShare& share = share_of(shares, slot);
    if (is_value(slot)) {
      flows.push_back(share);
    } else if (wire::slot_class(slot) == wire::SlotClass::kEvent) {
      flows[kEvents].fraction += share.fraction;
      flows[kEvents].priority = std::max(flows[kEvents].priority, share.priority);
    }
  }
  return flows;
}

}  // namespace

LimitedChannel::LimitedChannel(const std::vector<wire::Slot>& slots, const SlotShares& shares,
                               Duration heartbeat_period)
    : slots_(values_among(slots)),
      schedule_(flows_of(slots, shares), heartbeat_bytes(), heartbeat_period) {}

std::optional<LimitedChannel::Turn> LimitedChannel::next(const Waiting& first, Duration now) {
  if (now < schedule_.free_at()) return std::nullopt;
  std::vector<std::size_t> waiting{first.heartbeat, first.event, first.part};
  std::vector<bool> is_long;
  for (const wire::Slot slot : slots_) {
    const wire::Sample* value = values_.first(slot);
    const auto part =
        std::ranges::find(first.long_states, slot, &std::pair<wire::Slot, std::size_t>::first);
    const bool has_part = part != first.long_states.end();
    is_long.push_back(has_part && (value == nullptr || turn_of_long_));
    const std::size_t bytes = value == nullptr ? 0 : channel_bytes(*value);
    waiting.push_back(is_long.back() ? part->second : bytes);
  }
  const auto flow = schedule_.pick(waiting, now);
  if (!flow) return std::nullopt;
  Turn turn{Turn::Of::kHeartbeat, wire::Slot::kHeartbeat, *flow, waiting[*flow]};
  if (*flow == kEvents) turn.of = Turn::Of::kEvents;
  if (*flow == kParts) turn.of = Turn::Of::kPart;
  if (*flow >= kFirstValue) {
    turn_of_long_ = !is_long[*flow - kFirstValue];
    turn.of = turn_of_long_ ? Turn::Of::kValue : Turn::Of::kLongState;
    turn.slot = slots_[*flow - kFirstValue];
  }
  return turn;
}

std::vector<wire::Sample> LimitedChannel::let_go() {
  std::vector<wire::Sample> states = values_.take(wire::SlotClass::kState);
  values_.take(wire::SlotClass::kStream);
  passing_.clear();
  return states;
}

wire::Sample LimitedChannel::take(const Turn& turn) {
  SKEIN_EXPECTS(turn.of == Turn::Of::kValue);
  wire::Sample value = *values_.first(turn.slot);
  values_.drop_first(turn.slot);
  return value;
}

}  // namespace skein::blackboard
