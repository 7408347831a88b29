// SPDX-License-Identifier: Apache-2.0
#include "capture.hpp"

#include <algorithm>
#include <utility>

namespace skein::blackboard::passive {

void Capture::note(const Sighting& sighting) {
  if (const auto* seen = std::get_if<EndpointSeen>(&sighting)) {
    if (seen->endpoint.writer) writers_.insert_or_assign(seen->endpoint.guid, seen->endpoint);
  } else if (const auto* gone = std::get_if<EndpointGone>(&sighting)) {
    writers_.erase(gone->guid);
  }
}

void Capture::take(std::span<const std::uint8_t> datagram, std::int64_t heard) {
  for (SampleData& data : messages_.take(datagram)) {
    if (held_.size() == kMostHeld) held_.pop_front();
    held_.push_back({std::move(data), heard, 0});
  }
}

bool Capture::is_asked_for(const Endpoint& writer) const {
  return std::ranges::any_of(subscriptions_, [&](const Subscription& one) {
    return one.topic == writer.topic && one.type == writer.type &&
           partitions_meet(one.partitions, writer.partitions);
  });
}

std::vector<SampleSeen> Capture::turn(Duration now) {
  std::vector<SampleSeen> samples;
  std::deque<Held> held;
  for (Held& one : std::exchange(held_, {})) {
    const auto writer = writers_.find(one.data.writer);
    const bool known = writer != writers_.end();
    if (known && is_asked_for(writer->second)) {
      const Endpoint& by = writer->second;
      samples.push_back({by.topic, by.guid, by.partitions.empty() ? "" : by.partitions.front(),
                         one.data.sent, one.heard, now, std::move(one.data.bytes)});
    } else if (++one.turns < (known ? kTurns : kPatience)) {
      held.push_back(std::move(one));
    }
  }
  held_ = std::move(held);
  return samples;
}

}  // namespace skein::blackboard::passive
