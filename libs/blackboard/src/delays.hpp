// SPDX-License-Identifier: Apache-2.0
// Queue of arrived samples that are delayed by the latency of their channel.
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
  };

  void add(std::size_t channel, wire::Sample&& sample, Duration due) {
    if (channel >= last_.size()) last_.resize(channel + 1);
    Duration& last = last_[channel];
    last = std::max(last, due);
    delayed_.emplace(last, Delayed{channel, std::move(sample)});
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
