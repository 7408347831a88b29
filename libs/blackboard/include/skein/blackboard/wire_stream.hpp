// SPDX-License-Identifier: Apache-2.0
// Slots of class stream: best effort, only the newest counts.
// Written by idl/generate_wire.py from idl/stream.idl: change that, and run it.
// clang-format off
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/blackboard/wire_common.hpp"

namespace skein::wire {

/// What a UAV says of itself. Not much longer than an event: on a slow channel events wait for what
/// is under way.
struct Telemetry {
  SampleHeader header;
  std::string uav;
  FloatVector3 position;
  FloatVector3 velocity;  ///< [m/s]
  float heading = 0;  ///< [rad]
  float energy = 0;  ///< share left, in [0, 1]
  bool airborne = false;
  std::string activity;
  std::vector<std::string> failed;  ///< devices that do not work; "engine" too
  bool operator==(const Telemetry&) const = default;
};
SKEIN_WIRE_FIELDS(Telemetry, header, uav, position, velocity, heading, energy, airborne, activity,
    failed)

/// One look through one device; also sent when it sees nothing, for that is evidence too. To the
/// ground station one that found something is a Sighting, while that is news.
struct PerceptionReport {
  SampleHeader header;
  std::string uav;
  std::string device;
  FloatVector3 viewpoint;
  FloatVector3 view_direction;  ///< unit vector
  float range = 0;  ///< [m]
  float aperture = 0;  ///< [rad] half angle of the cone of view
  std::vector<Detection> detections;
  bool operator==(const PerceptionReport&) const = default;
};
SKEIN_WIRE_FIELDS(PerceptionReport, header, uav, device, viewpoint, view_direction, range, aperture,
    detections)

/// Ground truth of one vehicle or object, from the simulator. World channel; the instance numbers
/// it.
struct Truth {
  SampleHeader header;
  std::string name;
  std::string kind;  ///< "uav", "fire", "vehicle", …
  Vector3 position;
  Vector3 velocity;  ///< [m/s]
  double heading = 0;  ///< [rad]
  double radius = 0;  ///< [m] of an object
  double energy = 0;  ///< of a UAV: share left, in [0, 1]
  bool active = false;  ///< UAV: airborne; object: there
  bool operator==(const Truth&) const = default;
};
SKEIN_WIRE_FIELDS(Truth, header, name, kind, position, velocity, heading, radius, energy, active)

/// Made and consumed by the blackboard itself on each channel that is not the world: reachability
/// and the acknowledgements of event sessions. Never given to a node.
struct Heartbeat {
  SampleHeader header;
  std::uint64_t events_from = 0;  ///< oldest event still held for this peer, or events_to + 1
  std::uint64_t events_to = 0;  ///< last event sent to this peer; 0: none
  std::uint64_t ack_incarnation = 0;  ///< of the peer, as heard now; 0: it is silent
  std::uint64_t ack_sequence = 0;  ///< all its events up to this one were handled
  bool operator==(const Heartbeat&) const = default;
};
SKEIN_WIRE_FIELDS(Heartbeat, header, events_from, events_to, ack_incarnation, ack_sequence)

/// A piece of an event that is too long to be said at once, and how much of the peer's there is. Made
/// and consumed by the blackboard itself; never given to a node.
struct Part {
  SampleHeader header;
  std::uint64_t number = 0;  ///< of the long event, among those of its sender to this peer; 0: none
  std::uint8_t of_slot = 0;  ///< that of the long event, as they are numbered in wire_slots.hpp
  std::uint32_t total = 0;  ///< [byte] of the long event, in CDR
  std::uint32_t offset = 0;  ///< [byte] of the content in it
  std::vector<std::uint8_t> content;
  std::uint64_t ack_incarnation = 0;  ///< of the peer, whose long event that is
  std::uint64_t ack_number = 0;  ///< of the peer's long event that is coming, or came last; 0: none
  std::uint32_t ack_bytes = 0;  ///< so much of it is there; all: it was handled
  bool ack_lacks = false;  ///< what follows these bytes was lost: later ones have come
  bool operator==(const Part&) const = default;
};
SKEIN_WIRE_FIELDS(Part, header, number, of_slot, total, offset, content, ack_incarnation,
    ack_number, ack_bytes, ack_lacks)

}  // namespace skein::wire
