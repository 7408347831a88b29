// SPDX-License-Identifier: Apache-2.0
// The way home that the witness keeps free for a UAV that may get out of reach.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/merging/volume.hpp"

namespace skein::merging {

/// A member's side of a standing reservation: its way home, which it may take without asking once
/// it can ask nobody. It is a request that stays open at the witness and is told to nobody else.
/// The witness grants that air to nobody; the member itself may still grant it, and then knows who
/// may be there. While the member is in reach, the witness asks it to give the air up as soon as
/// another member wants it. Of several ways the first one that the witness grants is kept. Times
/// never decrease. Source: docs/decisions/0058-the-way-home-is-kept-free.md.
class Standby {
 public:
  /// Sets the ways of which one is to be kept; empty: none. Ends what was kept before.
  void need(std::vector<Volumes> choices, MissionTime now);
  /// Another request of this member has replaced this one at the witness.
  void replace(MissionTime now);
  /// The request is sent now, under this number.
  void ask(std::uint64_t request, MissionTime now);
  /// The witness's answer to the open request. After a refusal the next way is asked for, after the
  /// last one the first again, later.
  void answered(bool granted, MissionTime now);

  bool is_due(MissionTime now) const { return due_ && *due_ <= now; }
  /// When the next request is to be sent; nothing: no way is needed, or one is kept already.
  std::optional<MissionTime> due() const { return due_; }
  std::uint64_t request() const { return request_; }  ///< number of the open request; 0: none
  bool kept() const { return kept_; }
  const std::vector<Volumes>& choices() const { return choices_; }
  /// The way that is kept, or asked for. Precondition: there is one.
  const Volumes& volumes() const { return choices_[choice_]; }
  /// Whether all of `air` is kept. Cost: O(product).
  bool keeps(const Volumes& air) const;

 private:
  std::vector<Volumes> choices_;
  std::size_t choice_ = 0;
  std::uint64_t request_ = 0;
  bool kept_ = false;
  std::optional<MissionTime> due_;
};

}  // namespace skein::merging
