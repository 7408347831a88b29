// SPDX-License-Identifier: Apache-2.0
#include "vehicle.hpp"

#include <algorithm>
#include <cmath>

namespace skein::sim {

using world::Vector2;
using world::Vector3;

Vehicle::Vehicle(const world::VehicleModel& model, const Vector3& position, double heading,
                 double energy)
    : model_(model) {
  state_.position = position;
  state_.heading = world::wrapped(heading);
  state_.energy = energy;
}

void Vehicle::step(const Command& command, const Vector3& wind, const world::Terrain& terrain,
                   double dt) {
  Command allowed = command;
  if (model_.ground) return roll(allowed, terrain, dt);
  if (!engine_works_) allowed = {0, state_.heading, -model_.descent_rate, std::nullopt, true};
  if (!state_.airborne && allowed.climb <= 0) {
    touch(terrain, true, dt);
    draw_energy(dt);
    return;
  }
  if (!state_.airborne) state_.position.z() = std::max(state_.position.z(), ground_below(terrain));
  state_.airborne = true;
  (model_.hovers) ? accelerate_hovering(allowed, dt) : accelerate_turning(allowed, dt);
  climb_towards(allowed.climb, dt);
  state_.velocity = air_velocity_ + model_.wind_drift * wind;
  state_.position += state_.velocity * dt;
  meet_ground(terrain, allowed.may_touch, dt);
  draw_energy(dt);
}

double Vehicle::ground_below(const world::Terrain& terrain) const {
  return terrain.elevation(state_.position.x(), state_.position.y());
}

/// One that takes off up a slope rises with it; all others are down, or have crashed.
void Vehicle::meet_ground(const world::Terrain& terrain, bool meant, double dt) {
  const double ground = ground_below(terrain);
  if (state_.position.z() > ground) return;
  if (meant && air_velocity_.z() > 0)
    state_.position.z() = ground;
  else
    touch(terrain, meant, dt);
}

/// On its wheels or tracks, wherever the ground leads up or down.
void Vehicle::roll(const Command& command, const world::Terrain& terrain, double dt) {
  Command allowed = command;
  if (!engine_works_) allowed.speed = 0;
  accelerate_hovering(allowed, dt);
  air_velocity_.z() = 0;
  state_.position.head<2>() += air_velocity_.head<2>() * dt;
  const double ground = ground_below(terrain);
  const double rise = (ground - state_.position.z()) / dt;
  state_.velocity = Vector3(air_velocity_.x(), air_velocity_.y(), rise);
  state_.position.z() = ground;
  draw_energy(dt);
}

void Vehicle::accelerate_hovering(const Command& command, double dt) {
  const double speed = std::clamp(command.speed, 0.0, model_.max_speed);
  const Vector2 wanted(speed * std::cos(command.course), speed * std::sin(command.course));
  const Vector2 now = air_velocity_.head<2>();
  const Vector2 change = wanted - now;
  const double most = model_.acceleration * dt;
  const double size = change.norm();
  air_velocity_.head<2>() = size <= most ? wanted : Vector2(now + change * (most / size));

  const double to = command.heading.value_or(command.speed > 1 ? command.course : state_.heading);
  const double turn = world::wrapped(to - state_.heading);
  const double limit = model_.yaw_rate * dt;
  state_.heading = world::wrapped(state_.heading + std::clamp(turn, -limit, limit));
}

void Vehicle::accelerate_turning(const Command& command, double dt) {
  const double now = air_velocity_.head<2>().norm();
  const double wanted = std::clamp(command.speed, model_.min_speed, model_.max_speed);
  const double most = model_.acceleration * dt;
  const double speed = now + std::clamp(wanted - now, -most, most);
  const double turn = world::wrapped(command.course - state_.heading);
  const double limit = speed * dt / model_.min_turn_radius;
  state_.heading = world::wrapped(state_.heading + std::clamp(turn, -limit, limit));
  air_velocity_.x() = speed * std::cos(state_.heading);
  air_velocity_.y() = speed * std::sin(state_.heading);
}

void Vehicle::climb_towards(double climb, double dt) {
  const double wanted = std::clamp(climb, -model_.descent_rate, model_.climb_rate);
  const double most = model_.acceleration * dt;
  air_velocity_.z() += std::clamp(wanted - air_velocity_.z(), -most, most);
}

/// Down, or staying down: what is left of the way is rolled out within the acceleration.
void Vehicle::touch(const world::Terrain& terrain, bool meant, double dt) {
  if (state_.airborne && !meant) {
    crashed_ = true;
    engine_works_ = false;
    air_velocity_.setZero();
  }
  state_.airborne = false;
  const double speed = air_velocity_.head<2>().norm();
  const double left = std::max(0.0, speed - model_.acceleration * dt);
  const Vector2 along = speed > 0 ? Vector2(air_velocity_.head<2>() / speed) : Vector2::Zero();
  air_velocity_ = Vector3(along.x() * left, along.y() * left, 0);
  state_.velocity = air_velocity_;
  state_.position.head<2>() += air_velocity_.head<2>() * dt;
  state_.position.z() = ground_below(terrain);
}

void Vehicle::draw_energy(double dt) {
  if (!engine_works_) return;
  const bool moves = state_.airborne || model_.ground;
  const double rise = model_.ground ? state_.velocity.z() : air_velocity_.z();
  const double power = moves ? world::flight_power(model_, air_velocity_.head<2>().norm(), rise)
                             : model_.energy.ground_power;
  state_.energy = std::max(0.0, state_.energy - power * dt / model_.energy.capacity);
}

}  // namespace skein::sim
