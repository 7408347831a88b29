// SPDX-License-Identifier: Apache-2.0
// Which channels the transport should have connected, and what it is given to write.
#include "connections.hpp"

#include <algorithm>

namespace skein::blackboard {

void Connections::set_up(std::size_t channel, bool up, Duration now, std::vector<Incoming>& out) {
  Wanted wanted{up, now, false};
  ask(channel, wanted, now, out);
}

void Connections::update(Duration now, std::vector<Incoming>& out) {
  for (auto [channel, wanted] : std::map(refused_))
    if (wanted.due <= now) ask(channel, wanted, now, out);
}

void Connections::ask(std::size_t channel, Wanted& wanted, Duration now,
                      std::vector<Incoming>& out) {
  const auto answer = transport_.set_up(channel, wanted.up);
  if (answer) {
    refused_.erase(channel);
    return;
  }
  if (!wanted.named) out.emplace_back(TransportRefused{channels_[channel], answer.error().why});
  refused_.insert_or_assign(channel, Wanted{wanted.up, now + again_, true});
}

std::optional<Duration> Connections::next_due() const {
  const auto sooner = [](const auto& a, const auto& b) { return a.second.due < b.second.due; };
  const auto first = std::ranges::min_element(refused_, sooner);
  if (first == refused_.end()) return std::nullopt;
  return first->second.due;
}

void Connections::write(std::size_t channel, const wire::Sample& sample,
                        std::vector<Incoming>& out) {
  const wire::Slot slot = wire::slot_of(sample);
  const bool written = transport_.write(channel, sample);
  wrote(channel, slot, written, out);
  if (wire::slot_class(slot) != wire::SlotClass::kState) return;
  const wire::SampleHeader& header = wire::header_of(sample);
  const StateKey key{channel, slot, header.origin, header.destination, header.instance};
  if (written) {
    unwritten_.erase(key);
  } else {
    unwritten_.insert_or_assign(key, sample);
  }
}

void Connections::write_again() {
  std::erase_if(unwritten_, [this](const auto& entry) {
    return transport_.write(std::get<0>(entry.first), entry.second);
  });
}

void Connections::wrote(std::size_t channel, wire::Slot slot, bool taken,
                        std::vector<Incoming>& out) {
  if (taken) {
    if (!not_taken_.empty()) not_taken_.erase({channel, slot});
    return;
  }
  if (!not_taken_.emplace(channel, slot).second) return;
  out.emplace_back(TransportRefused{
      channels_[channel], "a sample of " + std::string(wire::slot_name(slot)) + " was not taken"});
}

}  // namespace skein::blackboard
