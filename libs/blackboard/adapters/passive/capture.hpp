// SPDX-License-Identifier: Apache-2.0
// Captured samples, attributed to topics by the discovery of their writers.
#pragma once

#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "message_data.hpp"
#include "skein/blackboard/observer.hpp"

namespace skein::blackboard::passive {

/// A datagram may pass by before its writer is found, and before anybody asks for what it writes:
/// of a writer that is not known a sample waits for kPatience turns, else for kTurns; kMostHeld at
/// once, of more the oldest goes.
class Capture {
 public:
  static constexpr int kTurns = 2, kPatience = 50;
  static constexpr std::size_t kMostHeld = 4096;

  void read(const Subscription& subscription) { subscriptions_.push_back(subscription); }
  /// Of participants and endpoints.
  void note(const Sighting& sighting);
  /// `heard`: when it passed by [ns since 1970].
  void take(std::span<const std::uint8_t> datagram, std::int64_t heard);
  /// What was asked for. A turn has passed since the last call; it is `now`, steady.
  std::vector<SampleSeen> turn(Duration now);

 private:
  struct Held {
    SampleData data;
    std::int64_t heard = 0;
    int turns = 0;
  };
  bool is_asked_for(const Endpoint& writer) const;

  MessageData messages_;
  std::vector<Subscription> subscriptions_;
  std::map<std::string, Endpoint> writers_;  ///< by guid
  std::deque<Held> held_;
};

}  // namespace skein::blackboard::passive
