// SPDX-License-Identifier: Apache-2.0
// The slot of class state by which plans are kept consistent in time. What the
// fields mean is said where they come from: skein/temporal/frontier.hpp. Source: spec 5.3.
// Written by idl/generate_wire.py from idl/state.idl: change that, and run it.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

struct SharedMeeting {
  std::uint64_t id = 0;
  std::vector<std::string> senders;
  std::vector<std::string> receivers;
  bool operator==(const SharedMeeting&) const = default;
};
SKEIN_WIRE_FIELDS(SharedMeeting, id, senders, receivers)

/// [ns]; the greatest and the least of the type are infinite.
struct FrontierArc {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::int64_t soonest = 0;
  std::int64_t slowest = 0;
  std::int64_t latest = 0;
  bool operator==(const FrontierArc&) const = default;
};
SKEIN_WIRE_FIELDS(FrontierArc, from, to, soonest, slowest, latest)

/// A node rests on the end of a meeting at one of those who receive there.
struct FrontierBasis {
  std::uint32_t node = 0;
  std::string agent;
  std::uint64_t meeting = 0;
  bool operator==(const FrontierBasis&) const = default;
};
SKEIN_WIRE_FIELDS(FrontierBasis, node, agent, meeting)

/// What others need to know of the network of a UAV's plan. From the ground station, which tells of
/// several, the instance is the UAV's node number.
struct PlanFrontier {
  SampleHeader header;
  std::string uav;
  std::vector<SharedMeeting> meetings;
  std::vector<FrontierArc> arcs;
  std::vector<FrontierBasis> bases;
  bool operator==(const PlanFrontier&) const = default;
};
SKEIN_WIRE_FIELDS(PlanFrontier, header, uav, meetings, arcs, bases)

}  // namespace skein::wire
