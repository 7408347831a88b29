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
struct AirPlace {
  double x = 0;
  double y = 0;
  bool operator==(const AirPlace&) const = default;
};
SKEIN_WIRE_FIELDS(AirPlace, x, y)

/// Air of one width along a straight line, in pieces of one length that are given back one by one.
/// Source: decision 102.
struct AirRow {
  double radius = 0;
  double floor_z = 0;  ///< of the first piece
  double ceiling_z = 0;  ///< likewise
  double rise = 0;  ///< of each piece above the one before
  std::uint32_t pieces = 1;
  std::vector<AirPlace> line;  ///< where it begins and ends; one place: it ends there, and begins where the row before it ended (the first row: there too); none: all of it is there
  bool operator==(const AirRow&) const = default;
};
SKEIN_WIRE_FIELDS(AirRow, radius, floor_z, ceiling_z, rise, pieces, line)

/// One UAV's reserved and requested air, and its answer to the receiver. Source: decision 19.
struct MergeMessage {
  SampleHeader header;
  std::uint64_t number = 0;  ///< of the message; increases, also over restarts
  std::uint64_t request = 0;  ///< number of the open request; 0: none
  std::uint64_t answered = 0;  ///< number of the receiver's request that is answered; 0: none
  std::uint64_t version = 0;  ///< number of the first message to the receiver with this air and request; 0: by or to the ground station
  std::uint64_t known = 0;  ///< version of the receiver's that the sender has; 0: none
  bool granted = false;  ///< the answer
  bool asks = false;  ///< the sender expects an answer
  bool keeps = false;  ///< to the ground station: a request to keep `wanted` free in advance
  bool cannot_ask = false;  ///< the sender has waited long, but one without whose word it gets nothing is out of its reach: it takes no precedence
  bool brief = false;  ///< air, request and `waits_for` are left out: the receiver has this version
  bool lacks = false;  ///< the sender does not have the version that the receiver left out
  std::vector<AirRow> held;  ///< reserved air: no other UAV may enter
  std::vector<AirRow> wanted;  ///< air that the request asks for
  std::vector<std::string> waits_for;  ///< UAVs that hold some of `wanted`
  std::string of;  ///< from the ground station: the UAV whose message it forwards; empty: its own
  bool operator==(const MergeMessage&) const = default;
};
SKEIN_WIRE_FIELDS(MergeMessage, header, number, request, answered, version, known, granted, asks,
    keeps, cannot_ask, brief, lacks, held, wanted, waits_for, of)

}  // namespace skein::wire
