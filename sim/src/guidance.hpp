// SPDX-License-Identifier: Apache-2.0
// From what a vehicle is to do to what is asked of it in the next step.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "skein/elementary/task_checks.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/wind.hpp"
#include "vehicle.hpp"

namespace skein::sim {

/// Stay on the ground.
struct Stay {};
/// Keep still there; one that cannot hover circles it.
struct Hold {
  world::Vector3 at;
};
/// Rise from where it stands to an absolute height [m].
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
  /// One that cannot hover flies straight on, to get room for the turn that leads there.
  bool makes_room = false;
};
/// Come to rest as soon as possible, wherever that is.
struct Brake {
  std::optional<world::Vector3> centre = {};  ///< where it will wait
  double at_rest = 0;                         ///< for how long [s]
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

  /// One that cannot hover ends its way as high as the circle there needs.
  void set(Goal goal);
  const Goal& goal() const { return goal_; }
  bool done() const { return done_; }
  /// Where a vehicle that hovers turns to when it is slow.
  void look_at(const std::optional<world::Vector2>& target) { look_at_ = target; }
  /// The part of their speed that Rise, Descend and Fly are flown at, > 0; 1 at first.
  void set_pace(double pace) { pace_ = pace; }

  /// What to do in the next step. `error`: where it is flown to, relative to where meant [m].
  Command next(const Vehicle& vehicle, const world::Vector3& error, double heading_error) const;
  /// After each step of the vehicle, `dt` seconds long: takes note of what it reached.
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
                        double speed_there) const;
  Command orbit(const Vehicle& vehicle, const world::Vector3& at) const;
  bool needs_room(const world::VehicleState& state, const world::Vector2& at, double radius) const;
  double allowed_height(const world::VehicleState& state, double height) const;
  double level_towards(const world::VehicleState& state, double height) const;
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
