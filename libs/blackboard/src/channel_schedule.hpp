// SPDX-License-Identifier: Apache-2.0
// Who may write next on a channel of limited capacity.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "skein/blackboard/slot_share.hpp"
#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// A channel carries one sample after the other. Flows that have something to send share it: each
/// has a bucket that fills with its reserved fraction of the capacity. Whoever has enough in its
/// bucket goes before who has not; among these, and among those, the greater priority goes first,
/// then who waited longer. So no flow gets less than its fraction while it has something to send,
/// what others leave goes by priority, and what goes first waits at most for the sample that is
/// under way and for those with credit of a greater priority.
/// Deterministic. Cost: the number of flows. Source: spec 1.3 (bandwidth).
class ChannelSchedule {
 public:
  explicit ChannelSchedule(std::vector<SlotShare> flows);
  /// The first flow has so many bytes to send every `period`, and gets at least the fraction that
  /// takes, at the expense of the others.
  ChannelSchedule(std::vector<SlotShare> flows, std::size_t bytes, Duration period);

  /// Steady; 0: unlimited. The sample that is under way is not touched.
  void set_capacity(double bits_per_second, Duration now);
  double capacity() const { return capacity_; }
  bool limited() const { return capacity_ > 0; }
  /// How long the channel is taken by so many bytes.
  Duration airtime(std::size_t bytes) const;

  /// From when on the next sample may be written.
  Duration free_at() const { return free_at_; }
  /// The flow that goes next: `waiting` has, for each, the bytes of its first sample, 0 if it has
  /// none. None if nothing waits.
  std::optional<std::size_t> pick(std::span<const std::size_t> waiting, Duration now);
  /// The first sample of the flow is being written; gives when that ends.
  Duration write(std::size_t flow, std::size_t bytes, Duration now);

 private:
  struct Flow {
    SlotShare share;       ///< as declared
    double fraction = 0;   ///< as it is
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
