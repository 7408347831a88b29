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
  /// As long as it takes to come there from where it is and, after that, to have the zone in sight
  /// for so many seconds; at that height.
  Answer<Motion> patrol(const world::Vector3& from, const world::Zone& zone,
                        const world::SensorModel& device, double seconds) const;
  /// From its first lane on, and where it turns into that; the way there is not part of it. As it
  /// will be flown all of the zone is seen.
  Answer<Motion> sweep(const world::Vector3& from, const world::Zone& zone,
                       const world::SensorModel& device) const;
  /// Where that sensor sees the place best, from so many sides.
  Answer<std::vector<world::Vector3>> views(const world::Vector3& place,
                                            const world::SensorModel& device, std::size_t count);
  /// A place in the air and, for partners, others around it, a safe distance apart whatever flies
  /// there; the same whoever asks, as far as closed air allows.
  Answer<std::vector<world::Vector3>> places_around(const world::Vector3& at, std::size_t count);
  Answer<std::vector<world::Vector3>> tour(const world::Vector3& from,
                                           const std::vector<world::Vector3>& places);
  /// Whether it may wait there: closed air is further away than it strays from its place, or from
  /// its circles.
  bool has_room(const world::Vector3& at) const;
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
  double stray() const;
  std::vector<world::Volume> closed() const;
  bool met(const refiners::Way& way) const;
  std::optional<refiners::Way> way_with_room(const world::Airspace& air, const world::Vector3& from,
                                             const world::Vector3& to) const;
  Answer<refiners::Way> way_through(const world::Airspace& air, const world::Vector3& from,
                                    const world::Vector3& to) const;
  /// The world with a ground as fine as the footprint over the zone, and the closed air grown by
  /// what the vehicle strays, unless it is in that.
  world::World world_of(const world::Zone& zone, const world::Vector3& from,
                        double footprint) const;
  Answer<refiners::Way> planned_patrol(const world::World& world, const world::Vector3& from,
                                       const world::Zone& zone, double footprint,
                                       double seconds) const;
  /// Circles over the middle of a zone too small for lanes.
  Answer<refiners::Way> rounds(const world::Vector3& from, const world::Zone& zone,
                               double footprint, double seconds) const;
  /// Where a device looks from a height: a disc on the ground, some metres ahead [m].
  struct Look {
    double ahead = 0, reach = 0;
  };
  static Look look_of(const world::SensorModel& device, double height, double footprint);
  Answer<Motion> patrolled(const world::Vector3& from, const world::Zone& zone, const Look& look,
                           double width, double seconds) const;
  std::optional<refiners::Way> filled(const refiners::Way& way, const world::Zone& zone,
                                      const Look& look, double seconds, double& longer) const;
  struct Lanes {
    refiners::Way way;
    double seen = 0;  ///< least part of the zone, of all poses it may begin in
  };
  refiners::Way lanes_flown(const refiners::Coverage& task, const world::World& world) const;
  Answer<Lanes> planned_sweep(const world::World& world, const world::Vector3& from,
                              const world::Zone& zone, const world::SensorModel& device,
                              double overlap) const;
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
