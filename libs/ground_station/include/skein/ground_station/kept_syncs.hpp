// SPDX-License-Identifier: Apache-2.0
// Synchronisation messages that passed the ground.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "skein/executive/executive.hpp"
#include "skein/ground_orders/messages.hpp"

namespace skein::ground_station {

/// By receiver, the last word of each sender about each meeting: what was said last counts, not
/// what came last. Whoever has lost touch is told it again, and so is an executive that takes over.
/// Deterministic. A value; not safe to share between threads. Cost of note(): O(log n) in messages.
class KeptSyncs {
 public:
  /// Returns the message for an executive; one that does not tell when it was said was said now.
  executive::SyncReceived note(const SyncReceived& sync, MissionTime now);
  /// By meeting and sender.
  std::vector<executive::SyncReceived> of(const std::string& receiver) const;
  /// The same, to be sent.
  std::vector<SendSync> for_sending(const std::string& receiver) const;

 private:
  using Key = std::pair<std::uint64_t, std::string>;  ///< meeting and sender
  std::map<std::string, std::map<Key, executive::SyncReceived>> last_;
};

}  // namespace skein::ground_station
