// SPDX-License-Identifier: Apache-2.0
// The slot of class event by which UAVs merge their ways. What the fields mean is
// said where they come from: skein/merging/message.hpp. Source: spec 6.4.
// Written by idl/generate_wire.py from idl/event.idl: change that, and run it.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

/// [m] ENU.
struct AirVolume {
  double from_x = 0;
  double from_y = 0;
  double to_x = 0;
  double to_y = 0;
  double radius = 0;
  double floor_z = 0;
  double ceiling_z = 0;
  bool operator==(const AirVolume&) const = default;
};
SKEIN_WIRE_FIELDS(AirVolume, from_x, from_y, to_x, to_y, radius, floor_z, ceiling_z)

/// One UAV's reserved and requested air, and its answer to the receiver. Source: decision 19.
struct MergeMessage {
  SampleHeader header;
  std::uint64_t number = 0;  ///< of the message; increases, also over restarts
  std::vector<AirVolume> held;  ///< reserved volumes: no other UAV may enter
  std::uint64_t request = 0;  ///< number of the open request; 0: none
  std::vector<AirVolume> wanted;  ///< volumes that the request asks for
  std::vector<std::string> waits_for;  ///< UAVs that hold some of `wanted`
  bool keeps = false;  ///< to the ground station: a request to keep `wanted` free in advance
  std::uint64_t answered = 0;  ///< number of the receiver's request that is answered; 0: none
  bool granted = false;  ///< the answer
  bool asks = false;  ///< the sender expects an answer
  std::string of;  ///< from the ground station: the UAV whose message it forwards; empty: its own
  std::uint64_t version = 0;  ///< number of the first message to the receiver with this air and request; 0: by or to the ground station
  std::uint64_t known = 0;  ///< version of the receiver's that the sender has; 0: none
  bool brief = false;  ///< air, request and `waits_for` are left out: the receiver has this version
  bool operator==(const MergeMessage&) const = default;
};
SKEIN_WIRE_FIELDS(MergeMessage, header, number, held, request, wanted, waits_for, keeps, answered,
    granted, asks, of, version, known, brief)

}  // namespace skein::wire
