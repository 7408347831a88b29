// SPDX-License-Identifier: Apache-2.0
// What a new writer of a stream said before anybody could read it.
#include "first_words.hpp"

namespace skein::blackboard::rtps {

bool FirstWords::is_new(const Stream& stream, Clock::time_point now) {
  return !stream.found || now - stream.made < kNew;
}

void FirstWords::begin(wire::Slot slot, Clock::time_point now) {
  streams_.insert_or_assign(slot, Stream{now, false, {}});
}

void FirstWords::keep(const wire::Sample& sample, Clock::time_point now) {
  const auto stream = streams_.find(wire::slot_of(sample));
  if (stream == streams_.end()) return;
  if (!is_new(stream->second, now)) {
    streams_.erase(stream);
    return;
  }
  const wire::SampleHeader& header = wire::header_of(sample);
  stream->second.last.insert_or_assign(Key{header.origin, header.destination, header.instance},
                                       sample);
}

void FirstWords::found(wire::Slot slot, Clock::time_point now,
                       const std::function<void(const wire::Sample&)>& use) {
  const auto stream = streams_.find(slot);
  if (stream == streams_.end()) return;
  const bool old = !is_new(stream->second, now);
  stream->second.found = true;
  if (!old)
    for (const auto& [key, sample] : stream->second.last) use(sample);
  if (old || !is_new(stream->second, now)) streams_.erase(stream);
}

}  // namespace skein::blackboard::rtps
