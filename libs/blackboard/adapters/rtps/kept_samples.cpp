// SPDX-License-Identifier: Apache-2.0
// What the writers of a channel must say again when they are made anew.
#include "kept_samples.hpp"

namespace skein::blackboard::rtps {

void KeptSamples::keep(const wire::Sample& sample, Clock::time_point now) {
  const wire::Slot slot = wire::slot_of(sample);
  switch (wire::slot_class(slot)) {
    case wire::SlotClass::kState: {
      const wire::SampleHeader& header = wire::header_of(sample);
      states_.insert_or_assign(StateKey{slot, header.origin, header.destination, header.instance},
                               sample);
      return;
    }
    case wire::SlotClass::kEvent: {
      std::deque<Event>& kept = events_[slot];
      kept.push_back({now, sample});
      const auto too_old = [&] { return now - kept.front().at >= kEventLifespan; };
      while (kept.size() > kEventDepth || too_old()) kept.pop_front();
      return;
    }
    case wire::SlotClass::kStream:
      return;
  }
}

void KeptSamples::for_each(Clock::time_point now,
                           const std::function<void(const wire::Sample&)>& use) const {
  for (const auto& [key, state] : states_) use(state);
  for (const auto& [slot, kept] : events_) {
    for (const Event& event : kept)
      if (now - event.at < kEventLifespan) use(event.sample);
  }
}

}  // namespace skein::blackboard::rtps
