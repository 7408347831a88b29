// SPDX-License-Identifier: Apache-2.0
// What goes into the simulator and what comes out.
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

/// From a decision node to the functional layer of its vehicle. Task types and parameters: README.
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

/// Something goes wrong on board.
struct Fault {
  std::string uav;
  FaultKind kind = FaultKind::kEngine;
  std::string device = {};
  double factor = 1;  ///< >= 1; one that cannot hover stays at its least speed
  Duration lasts = {};
  std::string type = {};
  double left = 0;  ///< [0, 1]
};

/// Why a task aborts that a fault of kind kAbort met.
inline constexpr const char* kAbortedByFault = "aborted by the functional layer";

/// The decision node of a vehicle can no longer be heard by it (lost), or again; or it comes back
/// and knows nothing of what its vehicle does.
struct ContactLost {
  std::string uav;
  bool lost = true;
  bool forgotten = false;
};

/// Where a vehicle is that another node plays: for the radio.
struct VehicleElsewhere {
  std::string uav;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
};

/// The functional layer of every vehicle here has lost all that it knew: what it was asked, what it
/// told. The vehicles are where they are; each task under way is over, and comes to rest.
struct LayerForgot {};

using Input =
    std::variant<Tick, FunctionalRequest, Fault, ContactLost, VehicleElsewhere, LayerForgot>;

// ---- effects, in the order they happen ----

/// What the vehicle tells of itself, once per telemetry period.
using world::Telemetry;

/// The answer.
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

/// The radio from one node to another changed; at the first step, how it is, in pairs, one for each
/// direction.
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

/// Where a vehicle really is, with the telemetry; for the log and the runner, not for decisions.
struct VehicleTruth {
  std::string uav;
  world::VehicleState state;
  MissionTime at;
  bool operator==(const VehicleTruth&) const = default;
};

/// An object of the world, when it appears, disappears, each telemetry period while it moves, and
/// once per object period.
struct ObjectTruth {
  std::string name;
  std::string kind;
  world::Vector3 position = world::Vector3::Zero();
  double radius = 0;
  bool active = false;
  MissionTime at;
  /// Of a fire that spreads; its middle is `position`, half its length `radius`.
  std::optional<world::FireFront> front = {};
  bool operator==(const ObjectTruth&) const = default;
};

using Effect =
    std::variant<FunctionalStatus, Telemetry, PerceptionOut, LinkChange, VehicleTruth, ObjectTruth>;

}  // namespace skein::sim
