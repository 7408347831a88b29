// SPDX-License-Identifier: Apache-2.0
// Messages between UAVs that merge their plans, and between them and the witness.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/merging/volume.hpp"

namespace skein::merging {

/// All that a member holds and wants. Complete: a receiver needs only the latest one.
struct Claim {
  Volumes held;               ///< reserved: no other member may enter
  std::uint64_t request = 0;  ///< number of the open request, increasing; 0: none
  Volumes wanted;             ///< asked for by the request, or intended without one, at last (Want)
  std::vector<std::string> waits_for;  ///< members that hold some of `wanted`
  bool keeps = false;  ///< to the witness: the request is for air to be kept free (Standby)
  /// It has waited long (Limits::pressing), and one without whose word it gets nothing is out of
  /// its reach: it gains nothing if others let it go first.
  bool cannot_ask = false;
  bool operator==(const Claim&) const = default;
};

/// From one member (or the witness) to another.
struct Message {
  std::uint64_t number = 0;  ///< increases, also over restarts; an older one is ignored
  Claim claim;
  std::uint64_t answered = 0;  ///< the receiver's last request that is answered here; 0: none
  bool granted = false;        ///< the answer
  /// The sender expects an answer. To the witness without a request, or with one of a Standby: the
  /// sender expects the claims of those it waits for, now and whenever they change.
  bool asks = false;
  std::string of = {};  ///< from the witness: whose claim it forwards; empty: its own answer
  /// Number of the sender's first message to the receiver with this claim; 0: from or to the
  /// witness.
  std::uint64_t version = 0;
  std::uint64_t known = 0;  ///< version of the receiver's claim that the sender has; 0: none
  bool brief =
      false;  ///< `claim` is left out: the receiver has this version, or will when it comes
  bool lacks = false;  ///< the sender does not have the version that the receiver left out
  bool operator==(const Message&) const = default;
};

}  // namespace skein::merging
