// SPDX-License-Identifier: Apache-2.0
// When heartbeats to one peer are due.
#pragma once

#include <algorithm>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// One each period, one at once when there is a reason, and one soon as an acknowledgement, for
/// which the next one of the period may come too late. Steady times.
class HeartbeatTimes {
 public:
  explicit HeartbeatTimes(Duration period) : period_(period) {}

  void at_once(Duration now) { next_ = now; }
  /// An acknowledgement is owed, by then; by when one is owed already stays.
  void owe(Duration by) { acknowledge_ = acknowledge_.value_or(by); }
  bool due(Duration now) const { return now >= next(); }
  Duration next() const { return acknowledge_ ? std::min(next_, *acknowledge_) : next_; }
  void sent(Duration now) {
    next_ = now + Duration::nanoseconds(period_.count() * 19 / 20);
    acknowledge_.reset();
  }

 private:
  /// A little less than it is between two: after three of them a peer counts as lost, and the third
  /// heartbeat, on its way a little longer than those before it, has to be there by then. Else two
  /// that are lost in a row, 1 in 11 at 30 % loss, are a cut.
  Duration period_;
  Duration next_;
  std::optional<Duration> acknowledge_;
};

}  // namespace skein::blackboard
