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

/// What one UAV has of the air and wants, to one other.
struct MergeMessage {
  SampleHeader header;
  std::uint64_t number = 0;
  std::vector<AirVolume> held;
  std::uint64_t request = 0;
  std::vector<AirVolume> wanted;
  std::vector<std::string> waits_for;
  bool keeps = false;  ///< to the ground station: it is to keep what is wanted for when nobody is in reach
  std::uint64_t answered = 0;
  bool granted = false;
  bool asks = false;
  std::string of;  ///< from the ground station: whose word it passes on; empty: its own
  bool operator==(const MergeMessage&) const = default;
};
SKEIN_WIRE_FIELDS(MergeMessage, header, number, held, request, wanted, waits_for, keeps, answered,
    granted, asks, of)

}  // namespace skein::wire
