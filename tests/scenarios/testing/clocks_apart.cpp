// SPDX-License-Identifier: Apache-2.0
#include "testing/clocks_apart.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include "skein/laws/protocol.hpp"

namespace skein::testing {

namespace {

journal::Record moved(const journal::Record& record, Duration by) {
  journal::Record later(record.at() + by, record.node(), record.kind());
  for (const auto& [key, value] : record.fields()) later.with(key, value);
  return later;
}

using Channel = std::pair<std::string, std::string>;
/// When the sender wrote a line of each, by number.
using Sent = std::map<std::int64_t, MissionTime>;

std::map<Channel, Sent> sent_messages(const std::vector<journal::Record>& records) {
  std::map<Channel, Sent> sent;
  for (const journal::Record& one : records) {
    if (one.kind() != "message" || one.text("direction") != "sent") continue;
    const Channel channel{one.text("from"), one.text("to")};
    sent[channel].emplace(static_cast<std::int64_t>(one.number("sequence")), one.at());
  }
  return sent;
}

/// Slots of what the addressees have, by channel and number.
std::map<std::pair<Channel, std::int64_t>, std::string> slots_received(
    const std::vector<journal::Record>& records) {
  std::map<std::pair<Channel, std::int64_t>, std::string> slots;
  for (const journal::Record& one : records) {
    if (one.kind() != "message" || one.text("direction") != "received") continue;
    const Channel channel{one.text("from"), one.text("to")};
    slots.try_emplace({channel, static_cast<std::int64_t>(one.number("sequence"))},
                      one.text("slot"));
  }
  return slots;
}

/// Numbers between two lines, one from about the death or before and one from about it or after.
std::vector<std::int64_t> missing_around(const Sent& sent, MissionTime death, Duration apart) {
  constexpr std::int64_t kMost = 32;  // that a node sends in one turn
  std::vector<std::int64_t> missing;
  for (auto one = sent.begin(); one != sent.end() && std::next(one) != sent.end(); ++one) {
    const auto [number, at] = *one;
    const auto [next_number, next_at] = *std::next(one);
    if (at > death + apart || next_at < death - apart || next_number - number > kMost) continue;
    for (std::int64_t i = number + 1; i < next_number; ++i) missing.push_back(i);
  }
  return missing;
}

}  // namespace

std::vector<journal::Record> with_last_messages(std::vector<journal::Record> records, double rate,
                                                double apart) {
  const Duration limit = Duration::seconds(apart * rate);
  const auto sent = sent_messages(records);
  const auto slots = slots_received(records);
  std::vector<journal::Record> added;
  for (const journal::Record& death : records) {
    if (death.kind() != "fault" || death.text("what") != "kill") continue;
    for (const auto& [channel, numbers] : sent) {
      if (channel.first != death.text("target")) continue;
      for (const std::int64_t number : missing_around(numbers, death.at(), limit)) {
        const auto slot = slots.find({channel, number});
        if (slot == slots.end()) continue;
        added.push_back(journal::Record(death.at(), channel.first, "message")
                            .with("slot", slot->second)
                            .with("from", channel.first)
                            .with("to", channel.second)
                            .with("sequence", number)
                            .with("direction", "sent"));
      }
    }
  }
  records.insert(records.end(), added.begin(), added.end());
  return records;
}

std::string breaches_beyond_clocks(const std::vector<journal::Record>& records, double rate,
                                   double apart) {
  const Duration limit = Duration::seconds(apart * rate);
  std::vector<journal::Record> all = records;
  for (journal::Record& record : all) {
    // Of a command all lines are the ground station's, and so of one clock.
    const bool sent = record.text("direction") == "sent" || record.kind() == "command";
    const bool cut = record.kind() == "link" && !record.truth("up");
    if (!sent) record = moved(record, limit);
    if (cut) record = moved(record, limit);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return laws::to_text(laws::broken_protocol(all));
}

}  // namespace skein::testing
