// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/healing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "radio_limits.hpp"
#include "skein/journal/hand_on.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"
#include "told_links.hpp"
#include "ways.hpp"

namespace skein::laws {

namespace {

namespace lines = journal::lines;

using journal::Record;
using journal::Written;

/// Beyond three heartbeats, until the silence of a cut is noticed.
constexpr Duration kSilenceIsSeen = Duration::milliseconds(2'000);
/// Events from this number on are long: on a narrow channel they go in parts, after everything
/// else.
constexpr std::uint64_t kFirstLong = std::uint64_t{1} << 50U;
/// Who is told that a link is up has what waited by then.
constexpr Duration kTold = Duration::milliseconds(1'000);

using Channel = std::pair<std::string, std::string>;  ///< from, to

Channel reversed(const Channel& channel) { return {channel.second, channel.first}; }
std::string to_text(const Channel& channel) { return channel.first + " > " + channel.second; }

/// From when on something is so.
struct Change {
  MissionTime at;
  bool so = false;
};

struct Message {
  MissionTime sent;
  std::optional<MissionTime> settled;  ///< received, expired or lost
  std::string slot;
};

class Judge {
 public:
  explicit Judge(const HealingLimits& limits) : limits_(limits) {}

  std::vector<std::string> judge(const std::vector<Record>& records) {
    for (const Record& record : records) {
      const bool read = journal::hand_on<lines::Link, lines::Reach, lines::Message, lines::Route,
                                         lines::Expired, lines::Lost, lines::Fault>(record, *this);
      if (!read) breach(record.at(), "a line lacks something: " + to_json(record));
    }
    if (!records.empty()) end_ = records.back().at();
    if (mortal_.contains("sim")) return {};
    for (const std::string& dead : mortal_) relays_.erase(dead);
    for (const auto& [channel, changes] : links_)
      if (channel < reversed(channel)) judge_pair(channel);
    for (const auto& [channel, messages] : messages_) judge_end(channel, messages);
    return std::move(breaches_);
  }

  void hear(const lines::Link& line, const Written& when) {
    if (line.from == kEveryLink) return void(others_are_up_ = line.up);
    links_[{line.from, line.to}].push_back({when.at, line.up});
  }
  void hear(const lines::Reach& line, const Written& when) {
    reach_[{line.peer, when.node}].push_back({when.at, line.reachable});
  }
  void hear(const lines::Message& line, const Written& when) {
    const Channel channel{line.from, line.to};
    if (line.direction == "received") return settle(channel, line.sequence, when.at);
    Message& message = messages_[channel][line.sequence];
    message.sent = when.at;
    message.slot = line.slot;
  }
  void hear(const lines::Route& line, const Written& when) {
    relayed_[{when.node, line.peer}].push_back({when.at, !line.via.empty()});
    if (!line.via.empty()) relays_.insert(line.via);
  }
  void hear(const lines::Expired& line, const Written& when) {
    settle({line.from, line.to}, line.sequence, when.at);
  }
  void hear(const lines::Lost& line, const Written& when) {
    for (std::uint64_t one = line.sequence; one <= line.last; ++one)
      settle({line.from, when.node}, one, when.at);
  }
  void hear(const lines::Fault& line, const Written&) {
    if (line.what == "kill") mortal_.insert(line.target);
  }

 private:
  // Over DDS what was received may be told before what was sent, by a moment.
  void settle(const Channel& channel, std::uint64_t sequence, MissionTime at) {
    std::optional<MissionTime>& settled = messages_[channel][sequence].settled;
    if (!settled) settled = at;
  }

  bool is_up(const Channel& channel, MissionTime at) const {
    return state(links_, channel, at, others_are_up_);
  }

  static bool state(const std::map<Channel, std::vector<Change>>& of, const Channel& channel,
                    MissionTime at, bool otherwise) {
    const auto found = of.find(channel);
    if (found == of.end()) return otherwise;
    bool so = otherwise;
    for (const Change& change : found->second)
      if (change.at <= at) so = change.so;
    return so;
  }

  /// At some instant; heartbeats that are lost by chance may end it again.
  bool reached_within(const Channel& channel, MissionTime from, MissionTime until) const {
    if (state(reach_, channel, from, true)) return true;
    const std::vector<Change>& changes = reach_.at(channel);
    return std::any_of(changes.begin(), changes.end(), [&](const Change& change) {
      return change.so && change.at >= from && change.at <= until;
    });
  }

  /// Every instant at which the pair is whole again, having been broken for so long, and stays so.
  void judge_pair(const Channel& channel) {
    std::set<MissionTime> instants;
    for (const Channel& one : {channel, reversed(channel)}) {
      const auto found = links_.find(one);
      if (found == links_.end()) continue;
      for (const Change& change : found->second) instants.insert(change.at);
    }
    std::optional<MissionTime> broken;
    for (auto at = instants.begin(); at != instants.end(); ++at) {
      const bool whole = is_up(channel, *at) && is_up(reversed(channel), *at);
      if (!whole) {
        if (!broken) broken = *at;
        continue;
      }
      const bool one_way = broken && was_one_way(channel, *std::prev(at));
      const MissionTime until =
          *at + limits_.healing + (one_way ? limits_.next_heartbeat : Duration());
      const bool stays =
          until < end_ && (std::next(at) == instants.end() || *std::next(at) > until);
      if (broken && *at - *broken >= limits_.noticed && stays)
        judge_return(channel, *broken, *at, until);
      if (stays) broken.reset();
    }
  }

  bool was_one_way(const Channel& channel, MissionTime at) const {
    return is_up(channel, at) != is_up(reversed(channel), at);
  }

  void judge_return(const Channel& channel, MissionTime broken, MissionTime healed,
                    MissionTime until) {
    for (const Channel& one : {channel, reversed(channel)}) {
      if (mortal_.contains(one.first) || mortal_.contains(one.second)) continue;
      if (!reached_within(one, healed, until))
        breach(until, to_text(one) + ": the link is whole since " + skein::to_text(healed) +
                          " s, and " + one.second + " does not reach " + one.first);
      judge_what_waited(one, broken, healed);
    }
  }

  /// One after the other: each is later by what went before it. Who has a way past a relay keeps it
  /// until the link is steady, and shares it with others.
  void judge_what_waited(const Channel& channel, MissionTime broken, MissionTime healed) {
    const bool is_relayed = state(relayed_, channel, healed, false);
    MissionTime by = healed + (is_relayed ? limits_.rerouting : limits_.healing);
    for (const auto& [sequence, message] : messages_[channel]) {
      const bool waited = message.sent < healed && message.sent != MissionTime() &&
                          (!message.settled || *message.settled > healed);
      if (!waited) continue;
      const bool in_parts = sequence >= kFirstLong && limits_.each > Duration();
      by = by + takes(message) - limits_.each;
      const MissionTime due = in_parts ? by + limits_.rerouting : by;
      const bool late = !message.settled || *message.settled > due;
      if (late && stays_whole(channel, healed, due))
        breach(due, to_text(channel) + ": " + message.slot + " " + std::to_string(sequence) +
                        " of " + skein::to_text(message.sent) +
                        " s has not come since the link is whole, " + skein::to_text(healed) +
                        " s, after a cut since " + skein::to_text(broken) + " s");
      by = by + limits_.each;
    }
  }

  /// A hand-over says a whole mission.
  Duration takes(const Message& message) const {
    const Duration each = limits_.each;
    return message.slot == "HandOver" ? each + each + each + each : each;
  }

  /// Neither direction changes between these, and both are before the log's end.
  bool stays_whole(const Channel& channel, MissionTime from, MissionTime until) const {
    const auto changes = [&](const Channel& one) {
      const auto found = links_.find(one);
      return found != links_.end() &&
             std::any_of(found->second.begin(), found->second.end(), [&](const Change& change) {
               return change.at > from && change.at <= until;
             });
    };
    return until < end_ && !changes(channel) && !changes(reversed(channel));
  }

  /// They come one after the other: what waits for one before it is not under way yet.
  void judge_end(const Channel& channel, const std::map<std::uint64_t, Message>& messages) {
    if (mortal_.contains(channel.first) || mortal_.contains(channel.second)) return;
    MissionTime last = end_ - limits_.healing;
    if (!stays_up(channel, last)) {
      last = end_ - limits_.rerouting;
      if (!keeps_a_way(channel, last) || !keeps_a_way(reversed(channel), last)) return;
    }
    MissionTime sent_by = last;
    std::map<bool, MissionTime> settled;  // the one before it, of long ones and of others
    for (const auto& [sequence, message] : messages) {
      MissionTime& before = settled[sequence >= kFirstLong];
      before = std::max(before, message.settled.value_or(MissionTime()));
      if (message.settled) continue;
      if (std::max(message.sent, before) < sent_by)
        breach(end_, to_text(channel) + ": " + message.slot + " " + std::to_string(sequence) +
                         " of " + skein::to_text(message.sent) +
                         " s never came, and nobody said why");
      sent_by = sent_by - limits_.each;
    }
  }

  /// In both directions, without a change from then on.
  bool stays_up(const Channel& channel, MissionTime from) const {
    for (const Channel& one : {channel, reversed(channel)}) {
      if (!is_up(one, from)) return false;
      const auto found = links_.find(one);
      if (found != links_.end() && found->second.back().at > from) return false;
    }
    return true;
  }

  /// The same way, whichever it is: none of its links changes from then on.
  bool keeps_a_way(const Channel& channel, MissionTime from) const {
    return has_way(channel.first, channel.second, relays_, relays_.size() + 1,
                   [&](const std::string& one, const std::string& other) {
                     return stays_up({one, other}, from);
                   });
  }

  void breach(MissionTime at, const std::string& what) {
    breaches_.push_back(skein::to_text(at) + " s: " + what);
  }

  HealingLimits limits_;
  MissionTime end_;
  bool others_are_up_ = true;  ///< links that no line is about
  std::map<Channel, std::vector<Change>> links_;
  std::map<Channel, std::vector<Change>> reach_;    ///< from: who is reached; to: who says so
  std::map<Channel, std::vector<Change>> relayed_;  ///< whether its samples go past a relay
  std::map<Channel, std::map<std::uint64_t, Message>> messages_;
  std::set<std::string> mortal_;  ///< who was killed
  std::set<std::string> relays_;  ///< past whom somebody has told that its samples go
  std::vector<std::string> breaches_;
};

}  // namespace

HealingLimits healing_limits(const scenario::Scenario& scenario) {
  const scenario::RadioSpec& radio = scenario.radio;
  const double loss = greatest_loss(scenario);
  const Duration latency = greatest_latency(scenario);
  HealingLimits limits;
  const Duration beats = radio.heartbeat + radio.heartbeat + radio.heartbeat;
  limits.noticed = std::max(limits.noticed, beats + kSilenceIsSeen);
  if (loss == 0 && !scenario::narrowest(radio) && !radio.silent) {
    limits.healing = kTold + latency + latency;
    limits.next_heartbeat = std::max(Duration(), radio.heartbeat - kTold);
    return limits;
  }
  limits.each = airtime_of_an_event(radio);
  const double heartbeats = std::max(3.0, 2 + tries(loss));
  limits.healing = Duration::seconds(heartbeats * radio.heartbeat.to_seconds()) + latency + latency;
  return limits;
}

std::vector<std::string> broken_healing(const std::vector<Record>& records,
                                        const HealingLimits& limits) {
  return Judge(limits).judge(records);
}

}  // namespace skein::laws
