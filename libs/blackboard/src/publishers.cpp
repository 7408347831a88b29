// SPDX-License-Identifier: Apache-2.0
#include "publishers.hpp"

#include <algorithm>

namespace skein::blackboard {
namespace {

constexpr Duration kSilence = Duration::milliseconds(3'000);

Config settings_of(const Config& config) {
  Config settings;
  settings.self = config.self;
  settings.incarnation = config.incarnation;
  settings.heartbeat_period = kPublishedHeartbeat;
  return settings;
}

}  // namespace

Publishers::Publishers(const Config& config) : config_(settings_of(config)) {}

Publishers::Publisher& Publishers::of(const wire::SampleHeader& header) {
  return publishers_.try_emplace(NodeNumber(header.origin), config_).first->second;
}

bool Publishers::is_heard(const Publisher& publisher, Duration now) {
  return now - publisher.lives.present().last_heard < kSilence;
}

std::optional<wire::Violation> Publishers::hear(const wire::Heartbeat& heartbeat, Duration now,
                                                std::vector<Incoming>& out) {
  Publisher& from = of(heartbeat.header);
  Lives& lives = from.lives;
  const std::uint64_t incarnation = heartbeat.header.incarnation;
  if (lives.was_refused(incarnation) && is_heard(from, now)) {
    lives.refused(now);
    return kOfSecond;
  }
  if (incarnation > lives.present().incarnation) follow(from, incarnation, now, out);
  from.has_heartbeats = true;
  const bool is_older = incarnation < lives.present().incarnation;
  if (is_older && !is_heard(from, now)) lives.consider_older(incarnation, kSilence, now);
  if (is_older && !lives.is_former(incarnation)) {
    if (++from.older_words < Rival::kWords) return std::nullopt;  // the first may only be late
    return kOfOlderSecond;
  }
  if (lives.note(heartbeat) != Novelty::kNew) return std::nullopt;
  if (lives.is_former(incarnation)) {
    if (!lives.former_goes_on(kSilence, now)) return std::nullopt;
    tell_states(from, out);
    return kOfSecond;
  }
  lives.present().last_heard = now;
  lives.forget_silent_rival(kSilence, now);
  return std::nullopt;
}

std::optional<wire::Violation> Publishers::take(wire::Sample sample, Duration now,
                                                std::vector<Incoming>& out) {
  const wire::Slot slot = wire::slot_of(sample);
  const wire::SampleHeader header = wire::header_of(sample);
  Publisher& from = of(header);
  Lives& lives = from.lives;
  const bool is_refused =
      from.has_heartbeats && lives.was_refused(header.incarnation) && is_heard(from, now);
  const bool is_later = header.incarnation > lives.present().incarnation;
  if (is_later && !is_refused) follow(from, header.incarnation, now, out);
  Word* word = word_of(from, {slot, header.instance}, header.incarnation);
  if (word == nullptr || header.sequence_number <= word->sequence) return std::nullopt;
  word->sequence = header.sequence_number;
  const wire::SlotClass kind = wire::slot_class(slot);
  if (kind == wire::SlotClass::kState) word->state = sample;
  if (is_refused) {
    lives.refused(now);
    return kOfSecond;
  }
  const bool is_present = !from.has_heartbeats || header.incarnation == lives.present().incarnation;
  if (is_present) lives.present().last_heard = now;
  if (is_present || kind == wire::SlotClass::kEvent)
    out.emplace_back(Received{NodeNumber(header.origin), ChannelKind::kWorld, std::move(sample)});
  return std::nullopt;
}

Publishers::Word* Publishers::word_of(Publisher& publisher, const Key& key,
                                      std::uint64_t incarnation) {
  std::vector<Word>& words = publisher.words[key];
  const auto known = std::ranges::find(words, incarnation, &Word::incarnation);
  if (known != words.end()) return &*known;
  const Lives& lives = publisher.lives;
  const auto is_over = [&](const Word& one) {
    if (!publisher.has_heartbeats) return one.incarnation < incarnation;
    return one.incarnation != lives.present().incarnation && !lives.is_former(one.incarnation) &&
           !lives.was_refused(one.incarnation);
  };
  std::erase_if(words, is_over);
  const Word fresh{.incarnation = incarnation, .sequence = 0, .state = {}};
  const bool is_outdated = publisher.has_heartbeats ? is_over(fresh) : !words.empty();
  return is_outdated ? nullptr : &words.emplace_back(fresh);
}

// Of a life whose heartbeats are not known yet silence says nothing: it has from now on to be
// heard.
void Publishers::follow(Publisher& publisher, std::uint64_t incarnation, Duration now,
                        std::vector<Incoming>& out) {
  if (!publisher.has_heartbeats) publisher.lives.present().last_heard = now;
  const bool has_waited = publisher.lives.was_refused(incarnation);
  publisher.lives.follow(incarnation, is_heard(publisher, now), now);
  publisher.lives.present().last_heard = now;
  publisher.older_words = 0;
  if (has_waited) tell_states(publisher, out);
}

void Publishers::tell_states(const Publisher& publisher, std::vector<Incoming>& out) {
  for (const auto& [key, words] : publisher.words)
    for (const Word& word : words)
      if (word.incarnation == publisher.lives.present().incarnation && word.state)
        out.emplace_back(Received{NodeNumber(wire::header_of(*word.state).origin),
                                  ChannelKind::kWorld, *word.state});
}

}  // namespace skein::blackboard
