// SPDX-License-Identifier: Apache-2.0
// What the vehicle flies or where it rests, and the air that it has for that.
#pragma once

#include <optional>

#include "merging/airways.hpp"
#include "merging/circling.hpp"
#include "skein/functional/port.hpp"
#include "skein/merging/margins.hpp"

namespace skein::decision_node {

/// A flight of the vehicle: under way, or the last one from which it has not come to rest.
struct Flown {
  Airway airway;
  bool over = false, ended = false;
  /// Air of the preceding portion, from which it came without a stop, until it has left a part of
  /// this one.
  merging::Volumes behind = {};

  merging::Volumes air() const;
  /// Of a takeoff or landing that was stopped or refused at that height it keeps the air there,
  /// within so much. True: it has left some.
  bool stopped_at(double height, double within);
  /// Notes the vehicle's position; true: it has left more of its way.
  bool passed(const world::Vector3& position);
  /// It circles, its way given up: it keeps what the piece that is nearest, of those that are all
  /// of the circle's air, has around the circle; where there is none, all that have a part of this.
  void stays_on(const Circle& circle, const merging::Margins& margins);
  bool flies(functional::TaskId task) const { return !over && airway.request.id == task; }
};

/// Follows the vehicle by its telemetry and by the flights that it is given.
class VehicleAir {
 public:
  /// `cruising`: margins at cruise speed.
  explicit VehicleAir(const merging::Margins& cruising) : margins_(cruising) {}

  /// True: it has left more of its way.
  bool see(const world::VehicleState& state, MissionTime now);
  void begin(Flown flown);
  /// The flight is over; `ended`: as it was meant to. True: it has left some of its air.
  bool over(bool ended);
  /// Ends a flight that is over once the vehicle holds where it was to end, or stands still after
  /// it was stopped. False: it has not come to rest. A vehicle that circles keeps all of its way
  /// when it is stopped, until it is seen where it circles: then what of it is around there.
  bool come_to_rest();

  bool is_seen() const { return seen_.has_value(); }
  /// Before it is seen: the state of a vehicle on the ground at the origin.
  const world::VehicleState& state() const;
  /// Where it hovers or circles in the air; nothing: it flies, or is on the ground.
  const std::optional<world::Vector3>& rest() const { return rest_; }
  /// Its place in the air: where it rests, else where it is.
  world::Vector3 place() const { return rest_.value_or(state().position); }
  const std::optional<Flown>& flown() const { return flown_; }
  bool flies() const { return flown_ && !flown_->over; }
  bool flies(functional::TaskId task) const { return flown_ && flown_->flies(task); }
  /// In the air at one place, or on a circle somewhere since it was stopped.
  bool stays() const;
  /// The air that it has now.
  merging::Volumes air() const;
  /// Where it will rest in the air; nothing: on the ground.
  std::optional<world::Vector3> rests_next() const { return flies() ? flown_->airway.end : rest_; }

 private:
  bool settles(MissionTime now);

  merging::Margins margins_;
  std::optional<world::VehicleState> seen_;
  std::optional<world::Vector3> rest_;
  std::optional<Flown> flown_;
  std::optional<Circling> circling_;  ///< from when it is stopped in flight until it circles
};

}  // namespace skein::decision_node
