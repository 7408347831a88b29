// SPDX-License-Identifier: Apache-2.0
// Time-dependent closed air, from the point of view of one vehicle.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "planning/gazetteer.hpp"
#include "refinery/motion.hpp"
#include "refinery/vehicle_start.hpp"
#include "skein/refiners/driving.hpp"
#include "skein/refiners/path.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/airspace.hpp"

namespace skein::supervisor {

/// Shared by all parts of the refinery: vehicle, world, and which volumes count at which time.
/// Thread rule: one thread at a time.
class TimedAir {
 public:
  TimedAir(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed, refiners::Budget budget);
  /// The same air from the point of view of another UAV of the team.
  TimedAir of(const std::string& uav) const {
    return {gazetteer_.of(uav), origin_, seed_, budget_};
  }

  /// Where the vehicle is now, and whether motions begin in flight there.
  VehicleStart& start() { return start_; }
  /// Whether the vehicle stands where it does still at departure, having had no time to fly and
  /// land. (A landing of a vehicle that cannot hover ends somewhere on its circle.)
  bool still_stands(const Departure& when) const;
  /// Greatest horizontal distance from `from` during the climb of a takeoff there [m].
  double climb_radius(const world::Vector3& from, const Departure& when) const;

  const Gazetteer& gazetteer() const { return gazetteer_; }
  const world::World& world() const { return gazetteer_.world(); }
  const world::VehicleModel& vehicle() const { return gazetteer_.knowledge().vehicle; }
  /// The model that ways are planned with: a vehicle that cannot hover has the turns and climbs
  /// that it still achieves against the wind.
  const world::VehicleModel& cautious() const { return cautious_; }
  refiners::Setting setting(const refiners::PathPlanner* paths = nullptr) const;
  refiners::Setting setting(const world::World& world,
                            const refiners::PathPlanner* paths = nullptr) const;
  refiners::PathQuery query(const world::Vector3& from, const world::Vector3& to) const;
  MissionTime origin() const { return origin_; }
  /// Least height over the ground [m]; more where it was too little for turns over steep ground.
  double clearance() const;
  /// Bound on the deviation from the intended path [m].
  double stray() const;
  /// Bound on the distance from a waiting place, while waiting and while joining the circle [m].
  double reach() const;
  /// Bound on the deviation at corners and turns [m].
  double swing() const;

  /// Whether some volume is closed only for a part of the time from the origin on.
  bool has_windows() const { return has_windows_; }
  world::TimeWindow window(const Departure& when, double seconds) const;
  /// For each of world().volumes, whether it counts.
  using Counted = std::vector<bool>;
  /// The volumes that are closed at some time while a flight of `seconds` may be under way; with
  /// Departure::suited, only those that are closed all of that time.
  Counted counted(const Departure& when, double seconds) const;
  using Volumes = std::vector<world::Volume>;
  Volumes closed(const Counted& counted) const;
  Volumes closed() const;  ///< at any time from the origin on
  /// The airspace without the volumes that count; without argument, without all that are closed at
  /// some time from the origin on. For a ground vehicle: the map of drivable ground (driving.hpp).
  /// Error: no airspace can be made for the vehicle in this world. Cached.
  Answer<const world::Airspace*> airspace();
  Answer<const world::Airspace*> airspace(const Counted& counted);
  /// The world with a ground grid as fine as the footprint over the zone, and with closed volumes
  /// grown by `margin` [m], unless `from` is within stray() of one.
  world::World over(const world::Zone& zone, const world::Vector3& from, double footprint,
                    double margin, const Counted& air) const;

  /// The point that stands for `at` in airspace(): for a ground vehicle, its point on the map.
  world::Vector3 in_airspace(const world::Vector3& at) const {
    return vehicle().ground ? refiners::on_map(at) : at;
  }

  /// Whether the vehicle may wait at `at`: closed air is further away than its tracking error, or
  /// its waiting circle with that.
  bool has_room(const world::Vector3& at) const { return has_room(at, closed()); }
  bool has_room(const world::Vector3& at, const Volumes& volumes) const;
  const world::Volume* taking_room(const world::Vector3& at, const Volumes& volumes) const;
  /// Whether the air at `at`, and all around where the vehicle may be while it waits, is free.
  bool may_stay(const world::Vector3& at);
  /// Whether the vehicle may be at `at` for so many seconds with free air around it all the time.
  /// Always true on the ground, except for a ground vehicle.
  bool may_stay(const world::Vector3& at, const Departure& when, double seconds) const;
  /// The same, but volumes that are closed at departure already do not count: the vehicle will
  /// leave them.
  bool stays_open(const world::Vector3& at, const Departure& when, double seconds) const;
  /// Whether no volume closes the way while it is flown.
  bool stays_open(const refiners::Way& way, const Departure& when) const;
  /// Whether some simulated flight along the way comes nearer than `margin` [m] (as far as it
  /// strays) to a volume.
  bool met(const refiners::Way& way, const Volumes& volumes,
           std::optional<double> margin = {}) const;

  /// Whether some flight along the way of a vehicle that cannot hover, which is not on its way in
  /// its turns, comes to the ground.
  bool meets_ground(const refiners::Way& way) const;

  /// Plans a motion, by `plan`, that is clear of every volume that is closed at some time during
  /// it, and of the ground. Repeats until the set of volumes is consistent with the motion's
  /// duration, including the flight to its beginning from `from`.
  using Planner = std::function<Answer<Motion>(const Counted&)>;
  Answer<Motion> kept_clear(const world::Vector3& from, const Departure& when, double seconds,
                            const Planner& plan);

 private:
  Answer<Motion> clear_of_all(const world::Vector3& from, const Departure& when, double seconds,
                              const Planner& plan) const;
  bool has_landed(const world::Vector3& at) const {
    return gazetteer_.on_ground(at) && !vehicle().ground;
  }
  bool comes_near(const refiners::Way& way, const Volumes& volumes) const;
  double longest(const refiners::Way& way) const;

  Gazetteer gazetteer_;
  world::VehicleModel cautious_;
  MissionTime origin_;
  std::uint64_t seed_;
  refiners::Budget budget_;
  bool has_windows_ = false;
  VehicleStart start_;
  bool in_flight_now_ = true;  ///< whether the motion being planned may begin in flight
  double raised_ = 0;          ///< what clearance() is raised by [m]
  std::map<std::pair<double, Counted>, world::Airspace> airspaces_;  ///< by raised_ too
};

}  // namespace skein::supervisor
