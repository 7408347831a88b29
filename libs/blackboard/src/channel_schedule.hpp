// SPDX-License-Identifier: Apache-2.0
// Scheduling of the flows on a channel of limited capacity.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "skein/blackboard/slot_share.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// A channel carries one sample after the other. The flows with waiting samples share it by token
/// buckets: each bucket fills with the flow's reserved fraction of the capacity. Flows with enough
/// credit for their first sample go before flows without; within both groups the greater priority
/// goes first, then the longer wait. So a flow gets at least its fraction while it has samples to
/// send, unused capacity is given out by priority, and a flow with credit waits at most for the
/// sample under way and for flows of greater priority with credit.
/// Deterministic. Cost: the number of flows. Source: spec 1.3 (bandwidth).
class ChannelSchedule {
 public:
  explicit ChannelSchedule(std::vector<SlotShare> flows);
  /// The first flow sends `bytes` every `period`; its fraction is at least what this takes, at the
  /// expense of the others.
  ChannelSchedule(std::vector<SlotShare> flows, std::size_t bytes, Duration period);

  /// 0: unlimited. `now`: steady. The sample under way is not affected.
  void set_capacity(double bits_per_second, Duration now);
  double capacity() const { return capacity_; }
  bool limited() const { return capacity_ > 0; }
  /// The time to transmit this many bytes.
  Duration airtime(std::size_t bytes) const;

  /// Steady time from which on the next sample may be written.
  Duration free_at() const { return free_at_; }
  /// The flow that goes next: `waiting` has, for each, the bytes of its first sample, 0 if it has
  /// none. None if nothing waits.
  std::optional<std::size_t> pick(std::span<const std::size_t> waiting, Duration now);
  /// Notes that the first sample of the flow is written now. Returns when its transmission ends.
  Duration write(std::size_t flow, std::size_t bytes, Duration now);

 private:
  struct Flow {
    SlotShare share;       ///< as declared
    double fraction = 0;   ///< in force, see share_out()
    double credit = 0;     ///< [byte]
    Duration last_served;  ///< or when it began to wait
    bool waits = false;
  };
  void share_out();
  void fill(Duration now);
  double depth(const Flow& flow) const;
  bool has_credit(const Flow& flow, std::size_t bytes) const;

  std::vector<Flow> flows_;
  std::size_t first_bytes_;
  Duration first_period_;
  double capacity_ = 0;  ///< [bit/s]
  Duration filled_;
  Duration free_at_;
};

}  // namespace skein::blackboard
