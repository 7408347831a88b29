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

struct Received {
  std::string slot;
  MissionTime at;
};
using Arrivals = std::map<std::pair<Channel, std::int64_t>, Received>;

/// What the addressees have, by channel and number.
Arrivals received_messages(const std::vector<journal::Record>& records) {
  Arrivals received;
  for (const journal::Record& one : records) {
    if (one.kind() != "message" || one.text("direction") != "received") continue;
    const Channel channel{one.text("from"), one.text("to")};
    received.try_emplace({channel, static_cast<std::int64_t>(one.number("sequence"))},
                         Received{std::string(one.text("slot")), one.at()});
  }
  return received;
}

constexpr std::int64_t kMost = 32;  ///< messages that a node sends in one turn to one other

/// Numbers between two lines, one from about the death or before and one from about it or after.
std::vector<std::int64_t> missing_around(const Sent& sent, MissionTime death, Duration apart) {
  std::vector<std::int64_t> missing;
  for (auto one = sent.begin(); one != sent.end() && std::next(one) != sent.end(); ++one) {
    const auto [number, at] = *one;
    const auto [next_number, next_at] = *std::next(one);
    if (at > death + apart || next_at < death - apart || next_number - number > kMost) continue;
    for (std::int64_t i = number + 1; i < next_number; ++i) missing.push_back(i);
  }
  return missing;
}

/// Numbers after the last line of a channel on which nothing is sent any more, of what came by
/// then.
std::vector<std::int64_t> missing_at_end(const Channel& channel, const Sent& sent,
                                         const Arrivals& arrivals, MissionTime until) {
  std::vector<std::int64_t> missing;
  const std::int64_t last = sent.rbegin()->first;
  for (std::int64_t number = last + 1; number <= last + kMost; ++number) {
    const auto arrival = arrivals.find({channel, number});
    if (arrival == arrivals.end() || arrival->second.at > until) break;
    missing.push_back(number);
  }
  return missing;
}

/// When who died then has told all that was left of its last turn, at the latest.
MissionTime back_of(const std::vector<journal::Record>& records, const journal::Record& death) {
  const auto back = std::find_if(records.begin(), records.end(), [&](const auto& one) {
    return one.kind() == "resumed" && one.node() == death.text("target") && one.at() >= death.at();
  });
  return back == records.end() ? death.at() : back->at();
}

}  // namespace

std::vector<journal::Record> with_last_messages(std::vector<journal::Record> records, double rate,
                                                double apart) {
  const Duration limit = Duration::seconds(apart * rate);
  const auto sent = sent_messages(records);
  const Arrivals arrivals = received_messages(records);
  std::vector<journal::Record> added;
  const auto add = [&](const journal::Record& death, const Channel& channel, std::int64_t number) {
    const auto arrival = arrivals.find({channel, number});
    if (arrival == arrivals.end()) return;
    added.push_back(journal::Record(death.at(), channel.first, "message")
                        .with("slot", arrival->second.slot)
                        .with("from", channel.first)
                        .with("to", channel.second)
                        .with("sequence", number)
                        .with("direction", "sent"));
  };
  for (const journal::Record& death : records) {
    if (death.kind() != "fault" || death.text("what") != "kill") continue;
    const MissionTime told = back_of(records, death) + limit;
    for (const auto& [channel, numbers] : sent) {
      if (channel.first != death.text("target")) continue;
      for (const std::int64_t number : missing_around(numbers, death.at(), limit))
        add(death, channel, number);
      if (numbers.rbegin()->second > death.at() + limit) continue;
      for (const std::int64_t number : missing_at_end(channel, numbers, arrivals, told))
        add(death, channel, number);
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
