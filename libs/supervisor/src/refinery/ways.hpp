// SPDX-License-Identifier: Apache-2.0
// Takeoffs, landings, and ways through the air or over the ground, with realistic durations.
#pragma once

#include <optional>
#include <string>

#include "refinery/timed_air.hpp"

namespace skein::supervisor {

class Ways {
 public:
  explicit Ways(TimedAir& air) : air_(air) {}

  Answer<Motion> takeoff(const world::Vector3& from, const Departure& when = {}) const;
  Answer<Motion> landing(const world::Vector3& from, const world::Vector3& to) const;
  /// A landing place, and why it is not the wanted one.
  struct Landing {
    world::Vector3 at;
    std::string instead;  ///< empty: it is the wanted place
  };
  Answer<Landing> landing_place(const world::Vector3& from, const world::Vector3& wanted,
                                const Departure& when = {}) const;
  /// A way clear of every volume that is closed at some time while it may be flown.
  Answer<Motion> path(const world::Vector3& from, const world::Vector3& to,
                      const Departure& when = {}) {
    return path_among(from, to, {}, when);
  }
  /// The same, and around or over the waiting places of others (meetings.hpp), if there is such a
  /// way. A vehicle that begins within one of these leaves it first.
  Answer<Motion> path_among(const world::Vector3& from, const world::Vector3& to,
                            const std::vector<Spot>& others, const Departure& when);
  /// Out of closed air by the shortest straight way to a place where the vehicle may stay: up,
  /// down, level, or level and up.
  Answer<Motion> way_out(const world::Vector3& from);
  Answer<refiners::Way> through(const world::Airspace& air, const world::Vector3& from,
                                const world::Vector3& to) const;
  /// The motion along `way`, with its times and its energy.
  Motion flown(refiners::Way way) const;
  /// Expected energy of so many seconds at one place.
  double energy_of_stay(double seconds) const;

 private:
  using Counted = TimedAir::Counted;
  using Volumes = TimedAir::Volumes;
  const Gazetteer& gazetteer() const { return air_.gazetteer(); }
  const world::World& world() const { return air_.world(); }
  const world::VehicleModel& vehicle() const { return air_.vehicle(); }
  Answer<Motion> path_in(const world::Airspace& air, const Volumes& volumes,
                         const world::Vector3& from, const world::Vector3& to,
                         const std::vector<Spot>& others = {});
  Answer<refiners::Way> through(const world::Airspace& air, const world::World& in,
                                const world::Vector3& from, const world::Vector3& to) const;
  /// path_in() for a ground vehicle (drives.cpp).
  Answer<Motion> drive(const world::Airspace& map, const Volumes& volumes,
                       const world::Vector3& from, const world::Vector3& to) const;
  Motion driven(refiners::Way way) const;
  /// The air with the others' waiting places closed, as airspace, world, and volumes.
  struct Crowd {
    world::Airspace air;
    world::World world;
    Volumes waiting;
  };
  std::optional<world::Volume> room_of(const Spot& other, const world::Vector3& to) const;
  Crowd crowd_of(const std::vector<Spot>& others, const world::Airspace& air,
                 const world::Vector3& to) const;
  static std::optional<world::Vector3> out_of_rooms(const Crowd& crowd, const world::Airspace& air,
                                                    const std::vector<Spot>& others,
                                                    const world::Vector3& from);
  std::optional<refiners::Way> clear_of(const std::vector<Spot>& others, const world::Airspace& air,
                                        const Volumes& volumes, const world::Vector3& from,
                                        const world::Vector3& to) const;
  std::vector<world::Vector3> beside(const world::Vector3& from) const;
  std::optional<refiners::Way> with_room(const world::Airspace& air, const Volumes& volumes,
                                         const world::Vector3& from, const world::Vector3& to,
                                         double margin) const;
  /// A way that begins in closed air (which was closed around the vehicle): out of it first.
  Answer<Motion> out_and_on(const world::Vector3& from, const world::Vector3& to);

  TimedAir& air_;
};

}  // namespace skein::supervisor
