// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/kept_syncs.hpp"

namespace skein::ground_station {

executive::SyncReceived KeptSyncs::note(const SyncReceived& sync, MissionTime now) {
  const executive::SyncReceived message{sync.id, sync.from, sync.word, sync.said.value_or(now)};
  const auto [last, is_new] = last_[sync.to].try_emplace({sync.id, sync.from}, message);
  if (!is_new && *last->second.said <= *message.said) last->second = message;
  return message;
}

std::vector<executive::SyncReceived> KeptSyncs::of(const std::string& receiver) const {
  std::vector<executive::SyncReceived> messages;
  const auto found = last_.find(receiver);
  if (found == last_.end()) return messages;
  for (const auto& [key, last] : found->second) messages.push_back(last);
  return messages;
}

std::vector<SendSync> KeptSyncs::for_sending(const std::string& receiver) const {
  std::vector<SendSync> messages;
  for (const executive::SyncReceived& last : of(receiver)) {
    messages.push_back({last.id, last.from, receiver, last.word, *last.said});
  }
  return messages;
}

}  // namespace skein::ground_station
