// SPDX-License-Identifier: Apache-2.0
#include "passing_samples.hpp"

#include <algorithm>

#include "sessions/tombstone.hpp"
#include "skein/blackboard/transport.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::blackboard {
namespace {

bool is_the_same(const wire::Sample& one, const wire::Sample& other) {
  const wire::SampleHeader& a = wire::header_of(one);
  const wire::SampleHeader& b = wire::header_of(other);
  return wire::slot_of(one) == wire::slot_of(other) && a.incarnation == b.incarnation &&
         a.sequence_number == b.sequence_number;
}

}  // namespace

void PassingSamples::put(wire::Sample sample) {
  const wire::SampleHeader& header = wire::header_of(sample);
  const Ends ends{header.origin, header.destination};
  Pair& pair = pairs_[ends];
  if (wire::slot_of(sample) == wire::Slot::kHeartbeat) {
    if (!pair.heartbeat) beats_.push_back(ends);
    pair.heartbeat = std::move(sample);
    return;
  }
  const auto same = [&](const wire::Sample& one) { return is_the_same(one, sample); };
  if (const auto waits = std::ranges::find_if(pair.events, same); waits != pair.events.end())
    return void(*waits = std::move(sample));
  if (pair.events.empty()) turns_.push_back(ends);
  pair.events.push_back(std::move(sample));
  if (++events_ > kEventDepth) drop_one();
}

void PassingSamples::drop_one() {
  const auto fewer = [](const auto& a, const auto& b) {
    return a.second.events.size() < b.second.events.size();
  };
  std::ranges::max_element(pairs_, fewer)->second.events.pop_front();
  --events_;
  forget_empty();
}

void PassingSamples::drop_expired(MissionTime now) {
  const auto has_expired = [now](const wire::Sample& one) {
    const std::int64_t expires = wire::header_of(one).expires;
    return expires < now.count() && !places_kept(expires);
  };
  for (auto& [ends, pair] : pairs_) events_ -= std::erase_if(pair.events, has_expired);
  forget_empty();
}

void PassingSamples::forget_empty() {
  std::erase_if(turns_, [this](const Ends& ends) { return pairs_.at(ends).events.empty(); });
  std::erase_if(pairs_,
                [](const auto& one) { return one.second.events.empty() && !one.second.heartbeat; });
}

const wire::Sample* PassingSamples::first() const {
  if (empty()) return nullptr;
  if (has_heartbeat_next()) return &*pairs_.at(beats_.front()).heartbeat;
  return &pairs_.at(turns_.front()).events.front();
}

wire::Sample PassingSamples::take() {
  SKEIN_EXPECTS(!empty());
  beat_was_last_ = has_heartbeat_next();
  std::deque<Ends>& turns = beat_was_last_ ? beats_ : turns_;
  const Ends ends = turns.front();
  turns.pop_front();
  Pair& pair = pairs_.at(ends);
  wire::Sample first = beat_was_last_ ? std::move(*pair.heartbeat) : std::move(pair.events.front());
  if (beat_was_last_) {
    pair.heartbeat.reset();
  } else {
    pair.events.pop_front();
    --events_;
    if (!pair.events.empty()) turns_.push_back(ends);
  }
  forget_empty();
  return first;
}

void PassingSamples::clear() { *this = PassingSamples(); }

}  // namespace skein::blackboard
