// SPDX-License-Identifier: Apache-2.0
// The dynamics of one vehicle: a point mass within the limits of its model.
#pragma once

#include <optional>

#include "skein/world/terrain.hpp"
#include "skein/world/vehicle_model.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::sim {

/// The command of guidance for one step; the vehicle follows it within its limits.
struct Command {
  double speed = 0;   ///< horizontal airspeed [m/s]
  double course = 0;  ///< direction of motion [rad]
  double climb = 0;   ///< [m/s], up positive
  std::optional<double> heading =
      {};                  ///< of a vehicle that hovers; else it looks where it flies [rad]
  bool may_touch = false;  ///< touching the ground is meant (takeoff and landing)
};

/// Laws, relative to the air (the wind adds its drift): speed, acceleration, climb and descent
/// rates never exceed the model's; a vehicle that cannot hover never turns tighter than its radius
/// and, in flight, never falls below its least speed; energy never grows.
class Vehicle {
 public:
  Vehicle(const world::VehicleModel& model, const world::Vector3& position, double heading,
          double energy);

  /// Advances by `dt` [s] over the terrain. `wind`: motion of the air [m/s]. A vehicle that touches
  /// the ground without Command::may_touch has crashed, also while it climbs along a slope.
  void step(const Command& command, const world::Vector3& wind, const world::Terrain& terrain,
            double dt);

  const world::VehicleState& state() const { return state_; }
  world::VehicleState& state() { return state_; }
  /// Velocity through the air, scaled as if all drift were wind [m/s].
  const world::Vector3& air_velocity() const { return air_velocity_; }

  /// From now on the vehicle sinks to the ground and stays there.
  void break_engine() { engine_works_ = false; }
  bool engine_works() const { return engine_works_; }
  /// Whether the vehicle has crashed into the ground; its engine is then broken, too.
  bool crashed() const { return crashed_; }

 private:
  void roll(const Command& command, const world::Terrain& terrain, double dt);
  void accelerate_hovering(const Command& command, double dt);
  void accelerate_turning(const Command& command, double dt);
  void climb_towards(double climb, double dt);
  void draw_energy(double dt);
  void meet_ground(const world::Terrain& terrain, bool meant, double dt);
  void touch(const world::Terrain& terrain, bool meant, double dt);
  double ground_below(const world::Terrain& terrain) const;

  world::VehicleModel model_;
  world::VehicleState state_;
  world::Vector3 air_velocity_ = world::Vector3::Zero();
  bool engine_works_ = true;
  bool crashed_ = false;
};

}  // namespace skein::sim
