// SPDX-License-Identifier: Apache-2.0
#include "sessions/long_states.hpp"

#include <algorithm>

#include "skein/blackboard/cdr.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

/// With what carries it on a channel.
std::size_t channel_bytes_of_part(std::size_t content) {
  wire::Part part;
  part.content.resize(content);
  return channel_bytes(part);
}

bool is_from(const wire::Sample& sample, std::uint32_t origin) {
  return wire::header_of(sample).origin == origin;
}

}  // namespace

bool LongStates::put(wire::Sample state) {
  told_.drop(state);
  const bool has_just_begun = written_ <= 1 && !was_replaced_;
  const bool replaces = (has_just_begun || parts_.all_written()) && is_under_way(state);
  was_replaced_ = was_replaced_ || (replaces && !parts_.all_written());
  if (replaces) end_current();
  return waiting_.put(std::move(state)) || replaces;
}

bool LongStates::drop(const wire::Sample& newer) {
  told_.drop(newer);
  if (is_under_way(newer)) end_current();
  return waiting_.drop(newer);
}

bool LongStates::is_under_way(const wire::Sample& like) const {
  return under_way_ && WaitingValues::are_alike(*under_way_, like);
}

void LongStates::end_current() {
  under_way_.reset();
  parts_.give_up(parts_.next_number() - 1);
}

void LongStates::drop_from(std::uint32_t origin) {
  if (under_way_ && is_from(*under_way_, origin)) end_current();
  for (WaitingValues* values : {&told_, &waiting_})
    for (wire::Sample& state : values->take(wire::SlotClass::kState))
      if (!is_from(state, origin)) values->put(std::move(state));
}

std::vector<wire::Sample> LongStates::let_go() {
  std::vector<wire::Sample> states = told_.take(wire::SlotClass::kState);
  if (under_way_) {
    states.push_back(std::move(*under_way_));
    end_current();
  }
  std::ranges::move(waiting_.take(wire::SlotClass::kState), std::back_inserter(states));
  return states;
}

void LongStates::begin_again() {
  for (wire::Sample& state : told_.take(wire::SlotClass::kState)) {
    if (!is_under_way(state) && !waiting_.has(state)) waiting_.put(std::move(state));
  }
  parts_.resend();
}

void LongStates::heard(std::uint64_t number, std::uint32_t bytes, bool lacks) {
  parts_.heard(number, bytes, lacks);
  if (!under_way_ || !parts_.empty()) return;
  if (!waiting_.has(*under_way_)) told_.put(std::move(*under_way_));
  under_way_.reset();
  was_replaced_ = false;
}

std::vector<std::pair<wire::Slot, std::size_t>> LongStates::due(Duration now,
                                                                std::uint32_t most_bytes,
                                                                Duration time_out) const {
  std::vector<std::pair<wire::Slot, std::size_t>> all;
  if (under_way_) {
    if (const auto part = parts_.next(now, most_bytes, time_out))
      all.emplace_back(wire::slot_of(*under_way_), channel_bytes_of_part(part->content.size()));
    return all;
  }
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
    const wire::Sample* first = waiting_.first(static_cast<wire::Slot>(i));
    if (first == nullptr) continue;
    const std::size_t content = std::min<std::size_t>(most_bytes, encoded_size(*first));
    all.emplace_back(static_cast<wire::Slot>(i), channel_bytes_of_part(content));
  }
  return all;
}

wire::Part LongStates::take(wire::Slot slot, std::uint32_t most_bytes, Duration now,
                            Duration time_out, Duration until) {
  if (!under_way_) {
    under_way_ = *waiting_.first(slot);
    waiting_.drop_first(slot);
    parts_.hold(*under_way_, 0);
    written_ = 0;
  }
  ++written_;
  const auto part = parts_.next(now, most_bytes, time_out);
  SKEIN_EXPECTS(part.has_value());
  parts_.written(*part, until);
  return *part;
}

std::optional<Duration> LongStates::next_due(std::uint32_t most_bytes, Duration time_out) const {
  if (under_way_) return parts_.next_due(most_bytes, time_out);
  if (waiting_.empty()) return std::nullopt;
  return Duration{};
}

}  // namespace skein::blackboard
