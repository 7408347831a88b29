// SPDX-License-Identifier: Apache-2.0
#include "guidance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "skein/world/steering.hpp"

namespace skein::sim {
namespace {

using world::Vector2;
using world::Vector3;

constexpr double kRestSpeed = 0.3;      // [m/s] at rest below it
constexpr double kRestTime = 1;         // [s]
constexpr double kArrivalSpeed = 1;     // [m/s] at the last way-point, of one that hovers
constexpr double kCeilingMargin = 0.5;  // [m]
constexpr double kFlareHeight = 15;     // [m] below it, one that cannot hover lands slowly
constexpr double kTouchRate = 0.3;      // [m/s] sink rate at the ground
constexpr double kRoomMargin = 1.5;     // room is made until a turn this much wider leads there
constexpr double kSinkGain = 0.25;      // [1/s] sink rate per metre of height, near the ground
constexpr double kNear = 0.05;          // [m] where directions no longer mean anything
constexpr double kSlow = 1.5;           // [m/s] it may look elsewhere than it flies
constexpr double kLookAhead = 2;        // [s] for rising ground
constexpr double kForesight = 20;       // [s] for ground that rises faster than it climbs
constexpr double kStride = 1;           // [s] between two looks of that foresight
constexpr double kClimbShare = 0.7;     // of its climb rate is counted on
constexpr double kOrbitGain = 1.5;      // how sharply it joins its circle

/// All around, from east on.
std::vector<Vector2> directions(int count) {
  std::vector<Vector2> all;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    all.emplace_back(std::cos(angle), std::sin(angle));
  }
  return all;
}

double bearing(const Vector2& from, const Vector2& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

world::Passage passage_of(const Fly& goal) {
  if (goal.next == 0 || goal.next + 1 >= goal.waypoints.size()) return {};
  return world::passage_of(goal.waypoints[goal.next - 1], goal.waypoints[goal.next],
                           goal.waypoints[goal.next + 1], goal.speed);
}

}  // namespace

Guidance::Guidance(const world::VehicleModel& model, const world::Terrain& terrain,
                   const world::Wind& wind)
    : model_(model), terrain_(&terrain), tolerance_(world::reaching_distance(model, wind)) {}

void Guidance::set(Goal goal) {
  goal_ = std::move(goal);
  auto* fly = std::get_if<Fly>(&goal_);
  if (fly && !model_.hovers && !model_.ground && !fly->waypoints.empty())
    fly->waypoints.back().z() = above_circle(fly->waypoints.back());
  done_ = std::holds_alternative<Stay>(goal_) || std::holds_alternative<Hold>(goal_);
}

void Guidance::finish(Goal then) {
  set(std::move(then));
  done_ = true;
}

Command Guidance::next(const Vehicle& vehicle, const Vector3& error, double heading_error) const {
  Command command =
      std::visit([&](const auto& goal) { return follow(goal, vehicle, error); }, goal_);
  if (!command.may_touch) avoid_ground(vehicle, command);
  const bool slow = vehicle.air_velocity().head<2>().norm() < kSlow;
  if (look_at_ && slow && model_.hovers)
    command.heading = bearing(vehicle.state().position.head<2>(), *look_at_) + heading_error;
  return command;
}

void Guidance::update(const Vehicle& vehicle, double dt) {
  const world::VehicleState& state = vehicle.state();
  if (const auto* rise = std::get_if<Rise>(&goal_)) {
    const bool level = std::abs(vehicle.air_velocity().z()) < 2 * kRestSpeed;
    if (state.airborne && level && std::abs(state.position.z() - rise->height) <= tolerance_)
      finish(Hold{Vector3(rise->at.x(), rise->at.y(), rise->height)});
  } else if (std::holds_alternative<Descend>(goal_)) {
    if (!state.airborne && vehicle.air_velocity().norm() <= 0) finish(Stay{});
  } else if (auto* fly = std::get_if<Fly>(&goal_)) {
    advance_fly(*fly, vehicle);
  } else if (auto* brake = std::get_if<Brake>(&goal_)) {
    advance_brake(*brake, vehicle, dt);
  }
}

void Guidance::advance_fly(Fly& goal, const Vehicle& vehicle) {
  while (goal.next + 1 < goal.waypoints.size() &&
         reached(vehicle.state(), goal.waypoints[goal.next])) {
    ++goal.next;
    goal.makes_room = false;
  }
  if (!model_.hovers) {
    // Two radii: with one, it would circle the point for ever on the edge between the two answers.
    const double radius = model_.min_turn_radius * (goal.makes_room ? kRoomMargin : 1);
    goal.makes_room = needs_room(vehicle.state(), goal.waypoints[goal.next].head<2>(), radius);
  }
  const Vector3 last = goal.waypoints.back();
  const bool slow = !model_.hovers || vehicle.air_velocity().norm() <= kArrivalSpeed;
  if (goal.next + 1 != goal.waypoints.size() || !slow || !reached(vehicle.state(), last)) return;
  model_.ground ? finish(Stay{}) : finish(Hold{last});
}

void Guidance::advance_brake(Brake& goal, const Vehicle& vehicle, double dt) {
  const Vector3& velocity = vehicle.air_velocity();
  const double motion = model_.hovers ? velocity.norm() : std::abs(velocity.z());
  goal.at_rest = motion < kRestSpeed ? goal.at_rest + dt : 0;
  if (!goal.centre || model_.hovers) goal.centre = vehicle.state().position;
  goal.centre->z() = vehicle.state().position.z();
  if (goal.at_rest >= kRestTime) finish(Hold{Vector3(*goal.centre)});
}

bool Guidance::reached(const world::VehicleState& state, const Vector3& point) const {
  const Vector3 offset = point - state.position;
  if (model_.ground) return offset.head<2>().norm() <= tolerance_;
  return offset.head<2>().norm() <= tolerance_ && std::abs(offset.z()) <= tolerance_;
}

Command Guidance::follow(const Stay&, const Vehicle&, const Vector3&) const {
  Command command;
  command.may_touch = true;
  return command;
}

Command Guidance::follow(const Hold& goal, const Vehicle& vehicle, const Vector3& error) const {
  return keep(vehicle, goal.at + error);
}

Command Guidance::follow(const Rise& goal, const Vehicle& vehicle, const Vector3& error) const {
  Command command = keep(vehicle, Vector3(goal.at.x(), goal.at.y(), goal.height + error.z()));
  command.may_touch = true;
  if (!vehicle.state().airborne) command.climb = pace() * model_.climb_rate;
  return command;
}

Command Guidance::follow(const Descend& goal, const Vehicle& vehicle, const Vector3& error) const {
  const world::VehicleState& state = vehicle.state();
  if (!state.airborne) return follow(Stay{}, vehicle, error);
  const double height =
      state.position.z() - terrain_->elevation(state.position.x(), state.position.y());
  Command command =
      keep(vehicle, Vector3(goal.at.x() + error.x(), goal.at.y() + error.y(), state.position.z()));
  if (!model_.hovers && height < kFlareHeight) command.speed = model_.min_speed;
  command.climb =
      -std::min(pace() * model_.descent_rate, kTouchRate + kSinkGain * std::max(0.0, height));
  command.may_touch = true;
  return command;
}

Command Guidance::follow(const Fly& goal, const Vehicle& vehicle, const Vector3& error) const {
  const Vector3 aim = goal.waypoints[goal.next] + error;
  const double speed = pace() * goal.speed;
  if (model_.hovers) {
    const world::Passage passage = passage_of(goal);
    return hover_towards(vehicle, aim, speed, {pace() * passage.speed, pace() * passage.climb});
  }
  Command command;
  command.speed = speed;
  const Vector2 position = vehicle.state().position.head<2>();
  command.course = goal.makes_room ? vehicle.state().heading : bearing(position, aim.head<2>());
  command.climb = level_towards(vehicle.state(), aim.z());
  return command;
}

Command Guidance::follow(const Brake& goal, const Vehicle& vehicle, const Vector3&) const {
  Command command;
  if (!model_.hovers) command = orbit(vehicle, goal.centre.value_or(vehicle.state().position));
  command.climb = 0;
  return command;
}

Command Guidance::keep(const Vehicle& vehicle, const Vector3& at) const {
  return model_.hovers ? hover_towards(vehicle, at, model_.cruise_speed, {}) : orbit(vehicle, at);
}

/// Straight at the point in space: the quicker of the two motions waits for the slower.
Command Guidance::hover_towards(const Vehicle& vehicle, const Vector3& at, double speed,
                                const world::Passage& there) const {
  const world::VehicleState& state = vehicle.state();
  const double distance = (at - state.position).head<2>().norm();
  if (model_.ground) {
    const double stopping =
        std::hypot(there.speed, world::stopping_speed(model_.acceleration, distance));
    return {.speed = std::min(speed, stopping),
            .course = bearing(state.position.head<2>(), at.head<2>())};
  }
  const double rise = std::abs(allowed_height(state, at.z()) - state.position.z());
  Command command;
  command.course = bearing(state.position.head<2>(), at.head<2>());
  command.climb = level_towards(state, at.z(), there.climb);
  command.speed = std::min(
      speed, std::hypot(there.speed, world::stopping_speed(model_.acceleration, distance)));
  if (distance < kNear || rise < kNear) return command;
  const double level_time = distance / command.speed;
  const double climb_time = rise / std::abs(command.climb);
  if (climb_time < level_time)
    command.climb *= climb_time / level_time;
  else
    command.speed *= level_time / climb_time;
  return command;
}

/// A vector field that ends on the circle, counter-clockwise, whatever side it is joined from.
Command Guidance::orbit(const Vehicle& vehicle, const Vector3& at) const {
  const world::VehicleState& state = vehicle.state();
  const Vector2 offset = state.position.head<2>() - at.head<2>();
  const double excess = (offset.norm() - model_.orbit_radius) / model_.orbit_radius;
  const double around = offset.norm() > 1e-6 ? std::atan2(offset.y(), offset.x())
                                             : state.heading - std::numbers::pi / 2;
  Command command;
  command.speed = model_.cruise_speed;
  command.course = around + std::numbers::pi / 2 + std::atan(kOrbitGain * excess);
  command.climb = level_towards(state, above_circle(at));
  return command;
}

/// The height to circle at: as asked, or higher where a part of the circle would lead into a slope.
double Guidance::above_circle(const Vector3& at) const {
  if (at.z() > terrain_->highest() + kLeastHeight) return at.z();
  static const std::vector<Vector2> kAround = directions(16);
  double height = at.z();
  for (const Vector2& direction : kAround) {
    const Vector2 there = at.head<2>() + model_.orbit_radius * direction;
    height = std::max(height, terrain_->elevation(there.x(), there.y()) + kLeastHeight);
  }
  return height;
}

/// True when the point lies inside the circle of that radius that would turn towards it.
bool Guidance::needs_room(const world::VehicleState& state, const Vector2& at,
                          double radius) const {
  const Vector2 position = state.position.head<2>();
  const double side = world::wrapped(bearing(position, at) - state.heading) >= 0 ? 1 : -1;
  const Vector2 left(-std::sin(state.heading), std::cos(state.heading));
  return (at - (position + side * radius * left)).norm() < radius - tolerance_ / 2;
}

/// The nearest height that the ceiling and the ground below allow.
double Guidance::allowed_height(const world::VehicleState& state, double height) const {
  const double ground = terrain_->elevation(state.position.x(), state.position.y());
  const double most = std::max(kLeastHeight, model_.ceiling - kCeilingMargin);
  return std::clamp(height, ground + kLeastHeight, ground + most);
}

double Guidance::level_towards(const world::VehicleState& state, double height,
                               double climb_there) const {
  const double allowed = allowed_height(state, height);
  const double error = allowed - state.position.z();
  // Past the height, or where it may not go there, it comes back to it.
  const double there = std::abs(allowed - height) > 0 || climb_there * error < 0 ? 0 : climb_there;
  const double rate = world::stopping_speed(model_.acceleration, std::abs(error));
  return std::clamp(there + std::copysign(rate, error), -pace() * model_.descent_rate,
                    pace() * model_.climb_rate);
}

double Guidance::pace() const {
  const bool moves = std::holds_alternative<Rise>(goal_) ||
                     std::holds_alternative<Descend>(goal_) || std::holds_alternative<Fly>(goal_);
  return moves ? pace_ : 1;
}

/// The last guard: rising ground ahead makes it climb whatever else is asked.
void Guidance::avoid_ground(const Vehicle& vehicle, Command& command) const {
  const world::VehicleState& state = vehicle.state();
  if (!state.airborne) return;
  const Vector3 ahead = state.position + kLookAhead * state.velocity;
  const double ground = std::max(terrain_->elevation(state.position.x(), state.position.y()),
                                 terrain_->elevation(ahead.x(), ahead.y()));
  const double height = std::min(state.position.z(), ahead.z()) - ground;
  if (height < kLeastHeight / 2 || rises_too_fast(state)) command.climb = model_.climb_rate;
}

/// Whether it has to climb from now on to pass above the ground where it will be: on the tightest
/// turn to its next way-point and straight there, or straight on where it has none.
bool Guidance::rises_too_fast(const world::VehicleState& state) const {
  const double rise = terrain_->highest() + kLeastHeight - state.position.z();
  if (rise < 0) return false;
  const auto* fly = std::get_if<Fly>(&goal_);
  const double stride = state.velocity.head<2>().norm() * kStride;
  const double turn = model_.hovers ? std::numbers::pi : stride / model_.min_turn_radius;
  double course = std::atan2(state.velocity.y(), state.velocity.x());
  Vector2 there = state.position.head<2>();
  for (double time = kStride; time <= kForesight; time += kStride) {
    const double climbed = climbed_in(time, state.velocity.z());
    if (climbed >= rise) return false;  // from then on above everything
    if (fly) {
      const Vector2 aim = fly->waypoints[fly->next].head<2>();
      if ((aim - there).norm() < stride) return false;
      course += std::clamp(world::wrapped(bearing(there, aim) - course), -turn, turn);
    }
    there += stride * Vector2(std::cos(course), std::sin(course));
    const double above = terrain_->elevation(there.x(), there.y()) + kLeastHeight;
    if (above - state.position.z() > climbed) return true;
  }
  return false;
}

/// What it gains in height [m] within `time` [s] if it begins to climb now; below 0 at first where
/// it sinks now.
double Guidance::climbed_in(double time, double rate_now) const {
  const double rate = kClimbShare * model_.climb_rate;
  const double response = std::max(0.0, (rate - rate_now) / model_.acceleration);
  const double gains = std::min(time, response);
  const double first = (rate_now + model_.acceleration * gains / 2) * gains;
  return first + rate * (time - gains);
}

std::string Guidance::activity() const {
  if (const auto* fly = std::get_if<Fly>(&goal_))
    return "goto " + std::to_string(fly->next + 1) + "/" + std::to_string(fly->waypoints.size());
  if (std::holds_alternative<Stay>(goal_)) return "on the ground";
  if (std::holds_alternative<Rise>(goal_)) return "takeoff";
  if (std::holds_alternative<Descend>(goal_)) return "landing";
  if (std::holds_alternative<Brake>(goal_)) return "stopping";
  return model_.hovers ? "hold" : "orbit";
}

}  // namespace skein::sim
