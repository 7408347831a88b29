// SPDX-License-Identifier: Apache-2.0
// Takeoffs, landings and ways through the air, or over the ground, lasting as long as they are
// flown or driven.
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
  /// Where it lands that comes from there, and why not where it would.
  struct Landing {
    world::Vector3 at;
    std::string instead;  ///< empty: as wanted
  };
  Answer<Landing> landing_place(const world::Vector3& from, const world::Vector3& wanted,
                                const Departure& when = {}) const;
  /// Clear of every volume that it can meet, whenever it departs then and however long it takes.
  Answer<Motion> path(const world::Vector3& from, const world::Vector3& to,
                      const Departure& when = {}) {
    return path_among(from, to, {}, when);
  }
  /// Likewise, around or over where others wait, if there is such a way: at places that are apart
  /// (meetings.hpp). Who begins where one of them may wait leaves it first.
  Answer<Motion> path_among(const world::Vector3& from, const world::Vector3& to,
                            const std::vector<Spot>& others, const Departure& when);
  /// Out of closed air by the shortest straight way to where it may stay: up, down, level, or level
  /// and up.
  Answer<Motion> way_out(const world::Vector3& from);
  Answer<refiners::Way> through(const world::Airspace& air, const world::Vector3& from,
                                const world::Vector3& to) const;
  /// A way with the times and the energy that it takes.
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
  /// Of a vehicle that keeps to the ground (drives.cpp).
  Answer<Motion> drive(const world::Airspace& map, const Volumes& volumes,
                       const world::Vector3& from, const world::Vector3& to) const;
  Motion driven(refiners::Way way) const;
  /// The air with rooms around where others wait, and where they may be then themselves.
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
  /// From air that is closed, as when it was closed around the vehicle: out, and on from there.
  Answer<Motion> out_and_on(const world::Vector3& from, const world::Vector3& to);

  TimedAir& air_;
};

}  // namespace skein::supervisor
