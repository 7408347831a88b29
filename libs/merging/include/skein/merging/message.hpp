// SPDX-License-Identifier: Apache-2.0
// What UAVs that merge their ways tell each other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/merging/volume.hpp"

namespace skein::merging {

/// What one has and wants, whole: whoever hears the last needs none before.
struct Claim {
  Volumes held;                        ///< nobody else may be there
  std::uint64_t request = 0;           ///< rises; 0: it asks for nothing now
  Volumes wanted;                      ///< with a request: that; without: what it would ask for
  std::vector<std::string> waits_for;  ///< who has what it wants
  bool keeps = false;  ///< to a witness: the request is for air that it is to keep (Standby)
  bool operator==(const Claim&) const = default;
};

/// From one to another.
struct Message {
  std::uint64_t number = 0;  ///< rises, over restarts too: an older one is not heard after a newer
  Claim claim;
  std::uint64_t answered = 0;  ///< the last request of the receiver's that was answered; 0: none
  bool granted = false;
  /// To be answered by a message; to a witness without a request, or with one for air to keep: by
  /// what those have for whom it waits, now and whenever that changes.
  bool asks = false;
  std::string of = {};  ///< from a witness: whose word it passes on, as told; empty: its own
  bool operator==(const Message&) const = default;
};

}  // namespace skein::merging
