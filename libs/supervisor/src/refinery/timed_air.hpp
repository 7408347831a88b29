// SPDX-License-Identifier: Apache-2.0
// The air as it is closed over time, as one vehicle meets it.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "flight/autopilot.hpp"
#include "planning/gazetteer.hpp"
#include "refinery/motion.hpp"
#include "skein/refiners/driving.hpp"
#include "skein/refiners/path.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/airspace.hpp"

namespace skein::supervisor {

/// What all parts of the refinery share: vehicle and world, and which volumes count when. Thread
/// rule: one thread at a time.
class TimedAir {
 public:
  TimedAir(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed, refiners::Budget budget);
  /// As that UAV of the team meets it.
  TimedAir of(const std::string& uav) const {
    return {gazetteer_.of(uav), origin_, seed_, budget_};
  }

  /// What begins there, and at once, begins in flight with that heading [rad], or some seconds
  /// later.
  void flies_on(const world::Vector3& from, double heading);
  /// Whether something does that begins then, if it is there: later it circles there before.
  bool begins_in_flight(const Departure& when) const;
  /// It is on the ground there.
  void stands_at(const world::Vector3& at) { stand_ = at; }
  /// Whether it has had no time to fly and land since: a landing of one that cannot hover ends
  /// somewhere on its circle.
  bool still_stands(const Departure& when) const;
  /// How far the climb of what takes off there then may lead it away from there [m].
  double climb_radius(const world::Vector3& from, const Departure& when) const;

  const Gazetteer& gazetteer() const { return gazetteer_; }
  const world::World& world() const { return gazetteer_.world(); }
  const world::VehicleModel& vehicle() const { return gazetteer_.knowledge().vehicle; }
  /// As ways are made for it: one that cannot hover is given the turns and climbs that it can still
  /// hold when the wind is against them.
  const world::VehicleModel& cautious() const { return cautious_; }
  refiners::Setting setting(const refiners::PathPlanner* paths = nullptr) const;
  refiners::Setting setting(const world::World& world,
                            const refiners::PathPlanner* paths = nullptr) const;
  refiners::PathQuery query(const world::Vector3& from, const world::Vector3& to) const;
  MissionTime origin() const { return origin_; }
  /// Kept from the ground [m].
  double clearance() const;
  /// How far it may be from where it means to be [m].
  double stray() const;
  /// How far it gets from where it waits: what it wavers, and circles that are joined [m].
  double reach() const;
  /// What corners and turns may take it off its way [m].
  double swing() const;

  /// Some volume is closed for a part of the time from the origin on.
  bool has_windows() const { return has_windows_; }
  world::TimeWindow window(const Departure& when, double seconds) const;
  /// One, of each world.volumes: whether it counts.
  using Counted = std::vector<bool>;
  /// Those that are closed at some time while a flight of so many seconds may be under way.
  Counted counted(const Departure& when, double seconds) const;
  using Volumes = std::vector<world::Volume>;
  Volumes closed(const Counted& counted) const;
  Volumes closed() const;  ///< at any time from the origin on
  /// Null, with a sentence, when the world makes no airspace for the vehicle. Volumes with a window
  /// that is still to come, or to end, count.
  /// Of a vehicle that drives: the map of the ground that it can drive on (driving.hpp).
  Answer<const world::Airspace*> airspace();
  Answer<const world::Airspace*> airspace(const Counted& counted);
  /// The world with a ground as fine as the footprint over the zone, and the closed air grown by
  /// that margin, unless the vehicle is in what it strays into.
  world::World over(const world::Zone& zone, const world::Vector3& from, double footprint,
                    double margin, const Counted& air) const;

  /// Where that is in the airspace.
  world::Vector3 in_airspace(const world::Vector3& at) const {
    return vehicle().ground ? refiners::on_map(at) : at;
  }

  /// Whether it may wait there: closed air is further away than it strays from its place, or from
  /// its circles.
  bool has_room(const world::Vector3& at) const { return has_room(at, closed()); }
  bool has_room(const world::Vector3& at, const Volumes& volumes) const;
  const world::Volume* taking_room(const world::Vector3& at, const Volumes& volumes) const;
  /// Free air, all around where it wavers or circles.
  bool may_stay(const world::Vector3& at);
  /// Whether it may be there for so many seconds: free air around it all the time. On the ground
  /// it may, unless it drives.
  bool may_stay(const world::Vector3& at, const Departure& when, double seconds) const;
  /// Likewise, but what is closed already does not count: it is known and will be left.
  bool stays_open(const world::Vector3& at, const Departure& when, double seconds) const;
  /// Whether a way can be flown then.
  bool stays_open(const refiners::Way& way, const Departure& when) const;
  bool met(const refiners::Way& way, const Volumes& volumes) const {
    return met(way, volumes, stray());
  }
  /// Whether some flight along the way comes nearer than `margin` [m].
  bool met(const refiners::Way& way, const Volumes& volumes, double margin) const;

  /// Planned so that it is clear of all that it can meet, which is the more the longer it takes;
  /// what sets out `from` somewhere else flies to it first.
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
  std::vector<Pose> poses(const world::Vector3& from) const;

  Gazetteer gazetteer_;
  world::VehicleModel cautious_;
  MissionTime origin_;
  std::uint64_t seed_;
  refiners::Budget budget_;
  bool has_windows_ = false;
  std::optional<world::Vector3> stand_;
  std::vector<Pose> in_flight_;  ///< in which what begins where it flies now may begin
  bool in_flight_now_ = true;    ///< what is planned now may begin so
  std::map<Counted, world::Airspace> airspaces_;
};

}  // namespace skein::supervisor
