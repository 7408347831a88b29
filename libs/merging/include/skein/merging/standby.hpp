// SPDX-License-Identifier: Apache-2.0
// Air that the witness keeps free for one that it may lose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/merging/volume.hpp"

namespace skein::merging {

/// What a member takes without asking once it can ask nobody: its way home. It is a request that
/// stays open at the witness and is told to nobody else. The witness lets nobody have that air;
/// the member itself goes on granting it, and so knows of all who may have it. While the member is
/// in reach the witness asks it to do without as soon as another wants that air. Of several ways
/// one is kept: the first that the witness promises. Times never decrease. Source:
/// docs/decisions/0058-the-way-home-is-kept-free.md.
class Standby {
 public:
  /// One of these; empty: none any more. What was kept before is not kept any more.
  void need(std::vector<Volumes> choices, MissionTime now);
  /// The witness was told of another request, which stands in the place of this.
  void replace(MissionTime now);
  /// It is to be asked for now, under this number.
  void ask(std::uint64_t request, MissionTime now);
  /// The witness's answer to the request that is open. Refused, the next is asked for, and after
  /// the last the first again later.
  void answered(bool granted, MissionTime now);

  bool is_due(MissionTime now) const { return due_ && *due_ <= now; }
  /// When it is to be asked for; nothing: there is none, or it is kept.
  std::optional<MissionTime> due() const { return due_; }
  std::uint64_t request() const { return request_; }  ///< 0: none is open
  bool kept() const { return kept_; }
  const std::vector<Volumes>& choices() const { return choices_; }
  /// The one that is kept, or asked for. Precondition: there is one.
  const Volumes& volumes() const { return choices_[choice_]; }
  /// All of it is kept. Cost: O(product).
  bool keeps(const Volumes& air) const;

 private:
  std::vector<Volumes> choices_;
  std::size_t choice_ = 0;
  std::uint64_t request_ = 0;
  bool kept_ = false;
  std::optional<MissionTime> due_;
};

}  // namespace skein::merging
