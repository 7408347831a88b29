// SPDX-License-Identifier: Apache-2.0
// Typed records of a run's event log, one struct per kind of line.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein::report {

/// A point of the local frame: east, north, up [m].
struct Position {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  bool operator==(const Position&) const = default;
};

/// Fields common to all lines.
struct Stamp {
  MissionTime at;
  std::string node;      ///< the node that wrote the line
  std::size_t line = 0;  ///< from 1 in the file; 0: not read from a file
  std::string extra;     ///< the keys this version does not know, as one JSON object; else empty
  bool operator==(const Stamp&) const = default;
};

enum class TaskState : std::uint8_t { kScheduled, kStarted, kRunning, kAborting, kEnded, kAborted };
enum class Direction : std::uint8_t { kSent, kReceived };
enum class CommandState : std::uint8_t { kIssued, kDelivered, kAcknowledged, kRefused, kExpired };
enum class AlarmState : std::uint8_t { kRaised, kConfirmed, kInfirmed };

/// A task of a UAV's executive entered a state. Source: spec 2.1.
struct TaskRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t task = 0;  ///< unique within the UAV
  std::string type;
  TaskState state = TaskState::kScheduled;
  std::string reason;  ///< empty: none given
};

/// An executive answered a request. Source: spec 2.3.
struct RequestRecord {
  Stamp stamp;
  std::string uav;
  std::string request;  ///< START, ABORT, …
  std::string mode;     ///< of a START; empty otherwise
  std::optional<std::uint64_t> task;
  bool accepted = true;
  std::string why;
};

/// A command of the ground station to a UAV.
struct CommandRecord {
  Stamp stamp;
  std::string uav;
  std::uint64_t command = 0;
  std::string what;
  CommandState state = CommandState::kIssued;
  std::string why;
};

/// A synchronisation message left or arrived. Source: spec 2.6.
struct SyncRecord {
  Stamp stamp;
  std::string id;
  std::string from;
  std::string to;
  Direction direction = Direction::kSent;
};

/// Names a session of a negotiation.
struct SessionName {
  std::string subject, opener;
  double opened = 0;  ///< mission time [s]
  auto operator<=>(const SessionName&) const = default;
};

/// An event-class sample left or arrived on a radio channel. Source: spec 1.3.
struct MessageRecord {
  Stamp stamp;
  std::string slot;
  std::string from;
  std::string to;
  std::uint64_t sequence = 0;
  Direction direction = Direction::kSent;
  std::optional<SessionName> session = {};  ///< the negotiation that the message belongs to
};

/// The radio link from one node to another is truly up or down.
struct LinkRecord {
  Stamp stamp;
  std::string from;
  std::string to;
  bool up = true;
};

/// The writing node believes a peer to be in or out of reach.
struct ReachRecord {
  Stamp stamp;
  std::string peer;
  bool reachable = true;
};

/// The writing node sends to a peer via a relay from now on, or (`via` empty) directly.
struct RouteRecord {
  Stamp stamp;
  std::string peer;
  std::string via;
};

/// The true state of a UAV, from the simulator.
struct TelemetryRecord {
  Stamp stamp;
  std::string uav;
  Position position;
  Position velocity;     ///< [m/s]
  double heading = 0.0;  ///< [rad], counter-clockwise from east
  double energy = 1.0;   ///< remaining share of the capacity, in [0, 1]
  bool airborne = false;
};

/// The true state of an object of the world, from the simulator.
struct ObjectRecord {
  Stamp stamp;
  std::string name;
  std::string type;
  Position position;
  double radius = 0.0;  ///< [m]
  bool active = true;
  /// Half the breadth [m] of a spreading fire, whose half length is `radius`, around `position`.
  std::optional<double> breadth = {};
  std::optional<Position> ignition = {};
};

/// The ground station received detections of a UAV's sensor.
struct PerceptionRecord {
  Stamp stamp;
  std::string uav;
  std::string device;
  std::uint64_t detections = 0;
};

struct AlarmRecord {
  Stamp stamp;
  std::uint64_t alarm = 0;
  AlarmState state = AlarmState::kRaised;
  Position position;    ///< as estimated
  double belief = 0.0;  ///< in [0, 1]
};

struct PhaseRecord {
  Stamp stamp;
  std::string name;
};

struct OperatorRecord {
  Stamp stamp;
  std::string does;
};

struct DegreeRecord {
  Stamp stamp;
  std::string uav;
  std::int64_t degree = 0;
};

struct FaultRecord {
  Stamp stamp;
  std::string what;
  std::string target;
};

struct ProcessRecord {
  Stamp stamp;
  std::string name;
  std::string state;  ///< started, ready, exited, crashed, restarted
  std::string why;
};

/// Malformed content that a node refused to take from a slot.
struct DroppedRecord {
  Stamp stamp;
  std::string slot;
  std::string origin;
  std::string field;
  std::string why;
};

/// An event sample that was never delivered: expired at the sender, or lost.
struct UndeliveredRecord {
  Stamp stamp;
  bool expired = true;
  std::string slot;
  std::string to;
  std::uint64_t sequence = 0;
};

struct MissionRecord {
  Stamp stamp;
  std::string state;  ///< started, finished, time-limit
};

struct ExpectationRecord {
  Stamp stamp;
  std::string name;
  bool passed = false;
  std::string seen;
};

/// A line in the form in which it was written (skein/journal/lines), with its stamp.
template <class Line>
struct Told {
  Stamp stamp;
  Line line;
};

/// A line of a kind that no view shows.
struct OtherRecord {
  Stamp stamp;  ///< `extra` holds every other key
  std::string kind;
};

}  // namespace skein::report
