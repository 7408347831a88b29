// SPDX-License-Identifier: Apache-2.0
// Time by which a node counts the silence of others.
#pragma once

#include <algorithm>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::node {

/// Steady time without what the machine held the node up for: who did not run heard nobody, and
/// must not take the others for silent before it has listened again. It never decreases, and goes
/// on by a quarter of a heartbeat period at least whenever the node runs. What is less late than a
/// period counts as it is. Steady times are of this process and must not decrease.
/// Source: docs/decisions/0123-who-was-held-up-has-not-listened.md.
class WakefulTime {
 public:
  /// `period`: of heartbeats, steady.
  explicit WakefulTime(Duration period) : period_(period) {}

  /// The node runs now. `due`: when it was to run at the latest, in wakeful time; absent: when
  /// something would come.
  void run(Duration steady, std::optional<Duration> due) {
    if (last_ && due) {
      const Duration late = at(steady) - std::max(*due, *last_);
      if (late > period_) missed_ = missed_ + late - Duration::nanoseconds(period_.count() / 4);
    }
    last_ = at(steady);
  }
  /// Wakeful time.
  Duration at(Duration steady) const { return steady - missed_; }
  /// Steady time, as long as nothing more is missed.
  Duration steady_at(Duration wakeful) const { return wakeful + missed_; }

 private:
  Duration period_;
  Duration missed_;
  std::optional<Duration> last_;  ///< wakeful
};

}  // namespace skein::node
