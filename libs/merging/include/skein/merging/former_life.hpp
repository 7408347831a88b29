// SPDX-License-Identifier: Apache-2.0
// What a member may have promised before it restarted without its memory.
#pragma once

#include <cstdint>
#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::merging {

/// Without a witness a restarted member asks everybody before it has anything, and need not know;
/// with one, another may go by a promise of a life before this. Requests have the time at which
/// they were opened. A value. Source: docs/decisions/0052-two-of-three.md.
class FormerLife {
 public:
  /// Clocks of two members differ by this at the most.
  static constexpr Duration kClocksApart = Duration::milliseconds(1'000);

  explicit FormerLife(bool with_witness) : with_witness_(with_witness) {}

  /// This life goes on at `now`; it began at the first one.
  void lives(MissionTime now) {
    if (!begun_) begun_ = now;
  }
  void was_none() { was_none_ = true; }
  /// Whether this request may have been granted before this life. Precondition: it has begun.
  bool may_have_granted(std::uint64_t request) const;

 private:
  bool with_witness_;
  bool was_none_ = false;
  std::optional<MissionTime> begun_;
};

}  // namespace skein::merging
