// SPDX-License-Identifier: Apache-2.0
// Queue of samples that are under way on a channel: being transmitted, or delayed by its latency.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "skein/blackboard/transport.hpp"

namespace skein::blackboard {

/// Ordered by due time (steady); samples of one channel keep their order.
class Delays {
 public:
  struct Delayed {
    std::size_t channel;
    wire::Sample sample;
    Duration transmitted;  ///< steady: its transmission ends
  };

  void add(std::size_t channel, wire::Sample&& sample, Duration transmitted, Duration latency) {
    if (channel >= last_.size()) last_.resize(channel + 1);
    Duration& last = last_[channel];
    last = std::max(last, transmitted + latency);
    // One after the other: what comes behind a long one is on the air after it.
    delayed_.emplace(last, Delayed{channel, std::move(sample), last - latency});
  }
  /// The channel is cut: what is being transmitted is lost. Cost: O(all that is under way).
  void cut(std::size_t channel, Duration now) {
    std::erase_if(delayed_, [&](const auto& one) {
      return one.second.channel == channel && one.second.transmitted > now;
    });
  }
  std::optional<Delayed> take_due(Duration now) {
    if (delayed_.empty() || delayed_.begin()->first > now) return std::nullopt;
    return std::move(delayed_.extract(delayed_.begin()).mapped());
  }
  std::optional<Duration> next_due() const {
    if (delayed_.empty()) return std::nullopt;
    return delayed_.begin()->first;
  }

 private:
  std::multimap<Duration, Delayed> delayed_;
  std::vector<Duration> last_;  ///< by channel
};

}  // namespace skein::blackboard
