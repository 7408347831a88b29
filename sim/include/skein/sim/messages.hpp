// SPDX-License-Identifier: Apache-2.0
// Inputs and effects of the simulator.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "skein/foundation/time.hpp"
#include "skein/functional/port.hpp"
#include "skein/world/fire.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/telemetry.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::sim {

// ---- inputs ----

/// A request from a decision node to the functional layer of its vehicle. Task types and
/// parameters: README.
struct FunctionalRequest {
  std::string uav;
  functional::Request request;
};

/// Time passes.
struct Tick {};

enum class FaultKind {
  kEngine,  ///< for good: the vehicle sinks to the ground, its tasks abort
  kSensor,  ///< for good: `device` fails, its task aborts
  kSlow,    ///< takeoff, landing and goto are flown at 1/`factor` of their speed, for `lasts`
  kAbort,   ///< the task of `type` that runs aborts, or else the next one that could begin; with
            ///< `lasts`, it and every one that could begin within that time
  kEnergy   ///< what is left becomes `left`, if that is less
};

/// A fault on board.
struct Fault {
  std::string uav;
  FaultKind kind = FaultKind::kEngine;
  std::string device = {};
  double factor = 1;  ///< >= 1; one that cannot hover stays at its least speed
  Duration lasts = {};
  std::string type = {};
  double left = 0;  ///< [0, 1]
};

/// The reason of aborts by faults of kind kAbort.
inline constexpr const char* kAbortedByFault = "aborted by the functional layer";

/// A vehicle has lost the contact to its decision node, or regained it; or (`forgotten`) the
/// decision node has restarted without knowledge of the vehicle's tasks.
struct ContactLost {
  std::string uav;
  bool lost = true;
  bool forgotten = false;
};

/// The position of a vehicle that another node simulates, for the radio.
struct VehicleElsewhere {
  std::string uav;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
};

/// The functional layers of all vehicles here have lost their memory of requests and statuses. The
/// vehicles stay where they are; their active tasks are over, and they come to rest.
struct LayerForgot {};

using Input =
    std::variant<Tick, FunctionalRequest, Fault, ContactLost, VehicleElsewhere, LayerForgot>;

// ---- effects, in the order they happen ----

/// Telemetry of a vehicle, once per telemetry period.
using world::Telemetry;

/// The answer to a FunctionalRequest.
struct FunctionalStatus {
  std::string uav;
  functional::Status status;
  MissionTime at;
  bool operator==(const FunctionalStatus&) const = default;
};

/// One look of one sensor, also when it detected nothing.
struct PerceptionOut {
  world::Perception perception;
  bool operator==(const PerceptionOut&) const = default;
};

/// As both ends of a LinkChange: every link that no other one is about.
inline constexpr const char* kEveryLink = "*";

/// The radio from one node to another has changed; at the first step, the initial condition of all
/// links, in pairs of both directions. If most of them are down then, that is said once for
/// kEveryLink, and of the others one by one.
struct LinkChange {
  std::string from;
  std::string to;
  bool up = false;
  Duration latency;
  double loss = 0;  ///< [0, 1]
  MissionTime at;
  double capacity = 0;  ///< [bit/s]; 0: unlimited
  bool operator==(const LinkChange&) const = default;
};

/// The true state of a vehicle, together with its telemetry; for the log and the runner, not for
/// decisions.
struct VehicleTruth {
  std::string uav;
  world::VehicleState state;
  MissionTime at;
  bool operator==(const VehicleTruth&) const = default;
};

/// The true state of an object: when it appears, when it disappears, each telemetry period while it
/// moves, and once per object period.
struct ObjectTruth {
  std::string name;
  std::string kind;
  world::Vector3 position = world::Vector3::Zero();
  double radius = 0;
  bool active = false;
  MissionTime at;
  /// Of a spreading fire; then `position` is its centre and `radius` half its length.
  std::optional<world::FireFront> front = {};
  bool operator==(const ObjectTruth&) const = default;
};

using Effect =
    std::variant<FunctionalStatus, Telemetry, PerceptionOut, LinkChange, VehicleTruth, ObjectTruth>;

}  // namespace skein::sim
