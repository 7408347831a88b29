// SPDX-License-Identifier: Apache-2.0
#include "passing_samples.hpp"

#include <algorithm>

#include "outgoing_events.hpp"
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
  const auto [found, is_new] = pairs_.try_emplace(ends);
  if (is_new) turns_.push_back(ends);
  Pair& pair = found->second;
  if (wire::slot_of(sample) == wire::Slot::kHeartbeat) {
    pair.heartbeat = std::move(sample);
    return;
  }
  const auto same = [&](const wire::Sample& one) { return is_the_same(one, sample); };
  if (const auto waits = std::ranges::find_if(pair.events, same); waits != pair.events.end())
    return void(*waits = std::move(sample));
  pair.events.push_back(std::move(sample));
  if (++events_ > kEventDepth) drop_one();
}

void PassingSamples::drop_one() {
  const auto fewer = [](const auto& a, const auto& b) {
    return a.second.events.size() < b.second.events.size();
  };
  const auto most = std::ranges::max_element(pairs_, fewer);
  most->second.events.pop_front();
  --events_;
  forget_if_empty(most->first);
}

void PassingSamples::drop_expired(MissionTime now) {
  for (const Ends& ends : std::deque<Ends>(turns_)) {
    events_ -= std::erase_if(pairs_.at(ends).events, [&](const wire::Sample& one) {
      const std::int64_t expires = wire::header_of(one).expires;
      return expires < now.count() && expires != kLongAgo;
    });
    forget_if_empty(ends);
  }
}

void PassingSamples::forget_if_empty(Ends ends) {
  const Pair& pair = pairs_.at(ends);
  if (!pair.events.empty() || pair.heartbeat) return;
  std::erase(turns_, ends);
  pairs_.erase(ends);
}

const wire::Sample* PassingSamples::first() const {
  if (turns_.empty()) return nullptr;
  const Pair& pair = pairs_.at(turns_.front());
  return pair.heartbeat ? &*pair.heartbeat : &pair.events.front();
}

wire::Sample PassingSamples::take() {
  SKEIN_EXPECTS(!empty());
  const Ends ends = turns_.front();
  turns_.pop_front();
  Pair& pair = pairs_.at(ends);
  wire::Sample first = pair.heartbeat ? std::move(*pair.heartbeat) : std::move(pair.events.front());
  if (pair.heartbeat) {
    pair.heartbeat.reset();
  } else {
    pair.events.pop_front();
    --events_;
  }
  if (pair.events.empty()) {
    pairs_.erase(ends);
  } else {
    turns_.push_back(ends);
  }
  return first;
}

void PassingSamples::clear() { *this = PassingSamples(); }

}  // namespace skein::blackboard
