// SPDX-License-Identifier: Apache-2.0
// Guidance: turns the goal of a vehicle into the command for its next step.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/elementary/task_checks.hpp"
#include "skein/world/passage.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/wind.hpp"
#include "vehicle.hpp"

namespace skein::sim {

/// Stay on the ground.
struct Stay {};
/// Hover at a place; a vehicle that cannot hover circles it.
struct Hold {
  world::Vector3 at;
};
/// Climb from the ground to a height [m, ENU z].
struct Rise {
  world::Vector2 at;
  double height;
};
/// Go down and stop on the ground.
struct Descend {
  world::Vector2 at;
};
/// Fly by all but the last way-point and arrive there.
struct Fly {
  std::vector<world::Vector3> waypoints;  ///< at least one
  double speed;                           ///< [m/s]
  std::size_t next = 0;                   ///< the way-point being flown to
  /// A vehicle that cannot hover flies straight on, to get room for its turn to the way-point.
  bool makes_room = false;
};
/// Come to rest as soon as possible, at any place.
struct Brake {
  std::optional<world::Vector3> centre = {};  ///< the place where the vehicle will wait
  double at_rest = 0;                         ///< time at rest so far [s]
};
using elementary::kLeastHeight;

using Goal = std::variant<Stay, Hold, Rise, Descend, Fly, Brake>;

/// The feedback laws of one vehicle.
///
/// | goal    | done when                                       | then        |
/// | Rise    | within tolerance of the height, climb ended      | Hold there  |
/// | Fly     | within tolerance of the last point (and slow)    | Hold there  |
/// | Brake   | at rest (level, if it cannot hover) for a second | Hold there  |
/// | Descend | on the ground and stopped                        | Stay        |
/// | Hold, Stay | at once                                       | –           |
class Guidance {
 public:
  /// The terrain must outlive the guidance.
  Guidance(const world::VehicleModel& model, const world::Terrain& terrain,
           const world::Wind& wind);

  /// For a vehicle that cannot hover, the end of a way is raised to the height that its waiting
  /// circle needs there.
  void set(Goal goal);
  const Goal& goal() const { return goal_; }
  bool done() const { return done_; }
  /// The point that a hovering vehicle turns to when it is slow.
  void look_at(const std::optional<world::Vector2>& target) { look_at_ = target; }
  /// The fraction of their speed at which Rise, Descend and Fly are flown, > 0; initially 1.
  void set_pace(double pace) { pace_ = pace; }

  /// The command for the next step. `error`: flown position relative to the intended one [m].
  Command next(const Vehicle& vehicle, const world::Vector3& error, double heading_error) const;
  /// To be called after each step of the vehicle, of `dt` seconds: updates the goal's progress.
  void update(const Vehicle& vehicle, double dt);
  /// For people: "goto 2/5", "hold", "orbit", …
  std::string activity() const;

 private:
  void advance_fly(Fly& goal, const Vehicle& vehicle);
  void advance_brake(Brake& goal, const Vehicle& vehicle, double dt);
  void finish(Goal then);
  bool reached(const world::VehicleState& state, const world::Vector3& point) const;

  Command follow(const Stay& goal, const Vehicle& vehicle, const world::Vector3& error) const;
  Command follow(const Hold& goal, const Vehicle& vehicle, const world::Vector3& error) const;
  Command follow(const Rise& goal, const Vehicle& vehicle, const world::Vector3& error) const;
  Command follow(const Descend& goal, const Vehicle& vehicle, const world::Vector3& error) const;
  Command follow(const Fly& goal, const Vehicle& vehicle, const world::Vector3& error) const;
  Command follow(const Brake& goal, const Vehicle& vehicle, const world::Vector3& error) const;

  Command keep(const Vehicle& vehicle, const world::Vector3& at) const;
  Command hover_towards(const Vehicle& vehicle, const world::Vector3& at, double speed,
                        const world::Passage& there) const;
  Command orbit(const Vehicle& vehicle, const world::Vector3& at) const;
  bool needs_room(const world::VehicleState& state, const world::Vector2& at, double radius) const;
  double allowed_height(const world::VehicleState& state, double height) const;
  double level_towards(const world::VehicleState& state, double height,
                       double climb_there = 0) const;
  double pace() const;
  void avoid_ground(const Vehicle& vehicle, Command& command) const;
  double above_circle(const world::Vector3& at) const;
  bool rises_too_fast(const world::VehicleState& state) const;
  double climbed_in(double time, double rate_now) const;

  world::VehicleModel model_;
  const world::Terrain* terrain_;
  double tolerance_;
  Goal goal_ = Stay{};
  bool done_ = true;
  std::optional<world::Vector2> look_at_;
  double pace_ = 1;
};

}  // namespace skein::sim
