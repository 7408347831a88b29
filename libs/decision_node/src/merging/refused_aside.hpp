// SPDX-License-Identifier: Apache-2.0
// Flights out of the way that the vehicle refused.
#pragma once

#include "skein/foundation/time.hpp"
#include "skein/functional/port.hpp"

namespace skein::decision_node {

/// After each flight out of the way that the vehicle aborted before it ran, the next one waits
/// twice as long: from 10 s to 80 s. One that runs begins anew.
class RefusedAside {
 public:
  static constexpr Duration kFirst = Duration::milliseconds(10'000);
  static constexpr Duration kMost = Duration::milliseconds(80'000);

  /// Of such a flight.
  void told(const functional::Status& status, MissionTime now);
  bool may_try(MissionTime now) const { return now >= next_; }

 private:
  MissionTime next_;
  Duration pause_ = kFirst;
  functional::TaskId running_{0};  ///< the last that ran
};

}  // namespace skein::decision_node
