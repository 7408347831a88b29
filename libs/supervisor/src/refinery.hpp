// SPDX-License-Identifier: Apache-2.0
// The refiners as planning uses them: one airspace for all ways, durations as they are flown.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flight_times.hpp"
#include "gazetteer.hpp"
#include "skein/refiners/coverage.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::supervisor {

/// A motion with all that a task is made of.
struct Motion {
  refiners::Way way;  ///< where it begins and all that is flown to
  Times times;
  double energy = 0;  ///< expected, as a fraction of what is held when full
};

/// Sentences say why not.
template <class Value>
using Answer = Result<Value, std::string>;

class Refinery {
 public:
  Refinery(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed);

  Answer<Motion> takeoff(const world::Vector3& from) const;
  Answer<Motion> landing(const world::Vector3& from, const world::Vector3& to) const;
  Answer<Motion> path(const world::Vector3& from, const world::Vector3& to);
  /// Where it lands that comes from there, and why not where it would.
  struct Landing {
    world::Vector3 at;
    std::string instead;  ///< empty: as wanted
  };
  Answer<Landing> landing_place(const world::Vector3& from, const world::Vector3& wanted) const;
  /// Out of closed air by the shortest straight way, level, up or down, to where it may stay.
  Answer<Motion> way_out(const world::Vector3& from);
  /// Free air, all around where it wavers or circles.
  bool may_stay(const world::Vector3& at);
  /// Some seconds of it, from where it is and at that height.
  Answer<Motion> patrol(const world::Vector3& from, const world::Zone& zone,
                        const world::SensorModel& device, double seconds) const;
  /// From its first lane on; the way there is not part of it.
  Answer<Motion> sweep(const world::Vector3& from, const world::Zone& zone,
                       const world::SensorModel& device) const;
  /// Where that sensor sees the place best, from so many sides.
  Answer<std::vector<world::Vector3>> views(const world::Vector3& place,
                                            const world::SensorModel& device, std::size_t count);
  Answer<std::vector<world::Vector3>> tour(const world::Vector3& from,
                                           const std::vector<world::Vector3>& places);
  /// Expected energy of so many seconds at one place.
  double energy_of_stay(double seconds) const;

  const Gazetteer& gazetteer() const { return gazetteer_; }

 private:
  const world::VehicleModel& vehicle() const { return gazetteer_.knowledge().vehicle; }
  /// As ways are made for it: one that cannot hover is given the turns and climbs that it can still
  /// hold when the wind is against them.
  const world::VehicleModel& cautious() const { return cautious_; }
  const world::World& world() const { return gazetteer_.world(); }
  refiners::Setting setting(const refiners::PathPlanner* paths = nullptr) const;
  refiners::PathQuery query(const world::Vector3& from, const world::Vector3& to) const;
  double clearance() const;
  /// From air that is closed, as when it was closed around the vehicle: out, and on from there.
  Answer<Motion> out_and_on(const world::Vector3& from, const world::Vector3& to);
  Answer<double> footprint(const world::SensorModel& device, double height) const;
  Motion flown(refiners::Way way) const;
  /// Null, with a sentence, when the world makes no airspace for the vehicle.
  Answer<const world::Airspace*> airspace();

  Gazetteer gazetteer_;
  world::VehicleModel cautious_;
  MissionTime origin_;
  std::uint64_t seed_;
  std::optional<world::Airspace> airspace_;
};

}  // namespace skein::supervisor
