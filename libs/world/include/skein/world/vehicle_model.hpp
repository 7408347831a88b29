// SPDX-License-Identifier: Apache-2.0
// Performance figures of vehicle types.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::world {

enum class VehicleKind { kHelicopter, kBlimp, kFixedWing, kGround };
/// "helicopter", "blimp", "fixed-wing", "ground": the names used in model files.
std::string_view to_text(VehicleKind kind);

struct EnergyModel {
  double capacity = 0;      ///< when full [J], > 0
  double ground_power = 0;  ///< drawn on the ground [W]
  double hover_power =
      0;  ///< drawn in the air at rest (when it cannot hover: at its least speed) [W]
  double cruise_power = 0;  ///< drawn at cruise speed; with the square of the speed in between [W]
  double climb_power = 0;   ///< drawn on top while climbing at the full rate, in proportion [W]
  double reserve = 0.1;     ///< fraction that no way may use, [0, 1)
  bool operator==(const EnergyModel&) const = default;
};

/// The person who flies a teleoperated vehicle. Source: spec 8.2 (Heliv).
struct PilotModel {
  Duration reaction;  ///< mean reaction time, from an order to its effect
  Duration
      reaction_spread;  ///< standard deviation of it; a reaction is never below a fifth of the mean
  double position_imprecision =
      0;  ///< standard deviation of what is flown around what is meant, per axis [m]
  double heading_imprecision = 0;  ///< standard deviation [rad]
  Duration attention_period;       ///< between two corrections, > 0
  bool operator==(const PilotModel&) const = default;
};

/// Additional figures of a ground vehicle.
struct GroundModel {
  double steepest = 0;  ///< steepest slope that it drives on [rad], (0, π/2)
  double mast = 0;      ///< height of its antenna and its sensors above the ground [m]
  bool operator==(const GroundModel&) const = default;
};

/// A vehicle type. Speeds are airspeeds; of ground vehicles, ground speeds on the map.
/// Source: spec 4.1 (vehicle), 8.2.
struct VehicleModel {
  std::string name;
  VehicleKind kind = VehicleKind::kHelicopter;
  bool hovers = true;          ///< can stand still in the air; else it waits in orbits
  double min_speed = 0;        ///< least horizontal speed in flight [m/s]; 0 when it hovers
  double cruise_speed = 0;     ///< horizontal, when nothing else is asked [m/s]
  double max_speed = 0;        ///< horizontal [m/s], >= cruise_speed
  double climb_rate = 0;       ///< greatest [m/s], > 0
  double descent_rate = 0;     ///< greatest, as a positive figure [m/s]
  double acceleration = 0;     ///< greatest, horizontal and vertical each [m/s²]
  double yaw_rate = 0;         ///< greatest turn of the heading [rad/s], for vehicles that hover
  double min_turn_radius = 0;  ///< [m]; 0 when it hovers
  double orbit_radius =
      0;               ///< of its waiting circle [m], >= 1.1 × min_turn_radius; 0 when it hovers
  double ceiling = 0;  ///< greatest height above the ground below [m]
  double body_radius = 1;         ///< of its bounding sphere, for collisions [m], > 0
  double position_precision = 0;  ///< standard deviation of its own navigation, per axis [m]
  double wind_drift = 0;          ///< fraction of the wind that it does not compensate, [0, 1]
  EnergyModel energy;
  std::optional<PilotModel> pilot;  ///< present: teleoperated
  /// Present: a ground vehicle, which never takes off or lands and stands still without orders. It
  /// then counts as hovering, wind does not move it, its ceiling is 0, and its climb and descent
  /// rates are those on the steepest slope.
  std::optional<GroundModel> ground;
  std::vector<SensorModel> sensors;
  /// Further figures that tasks may ask for, by name (`payload`), in units that its users agree on.
  std::map<std::string, double> abilities;

  bool operator==(const VehicleModel&) const = default;
};

/// The sensor with this device name, or null.
const SensorModel* find_sensor(const VehicleModel& model, std::string_view device);

/// Position of the antenna and the sensors of a vehicle at `position`.
Vector3 eye_of(const VehicleModel& model, const Vector3& position);

/// Power drawn in the air, or driving, [W] at an horizontal speed through the air and a vertical
/// speed [m/s].
double flight_power(const VehicleModel& model, double speed, double vertical_speed);

/// Standard deviation of the flown position around the intended one, per axis [m]: navigation and
/// pilot together.
double tracking_spread(const VehicleModel& model);

}  // namespace skein::world
