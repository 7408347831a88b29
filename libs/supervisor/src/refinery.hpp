// SPDX-License-Identifier: Apache-2.0
// The refiners as planning uses them: one airspace for all ways, durations as they are flown.
#pragma once

#include <functional>
#include <limits>
#include <map>
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
  double energy = 0;                  ///< expected, as a fraction of what is held when full
  std::optional<world::Vector3> aim;  ///< what its device is to be aimed at meanwhile
  double seen = 1;                    ///< of a sweep, least part of the zone
};

/// When a motion may begin, after the plan's origin [s]; `most` may be infinite.
struct Departure {
  double least = 0, most = std::numeric_limits<double>::infinity();
  /// At one of these moments that suits, which is found later: only air that is closed during all
  /// of them counts.
  bool suited = false;

  /// Of what begins when something else, begun then, is over.
  Departure after(const Times& times) const {
    return {least + times.least, most + times.most, suited};
  }
  Departure after(double seconds) const { return {least + seconds, most + seconds, suited}; }
};

/// Sentences say why not.
template <class Value>
using Answer = Result<Value, std::string>;

class Refinery {
 public:
  Refinery(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed,
           refiners::Budget budget = {});

  Answer<Motion> takeoff(const world::Vector3& from, const Departure& when = {}) const;
  Answer<Motion> landing(const world::Vector3& from, const world::Vector3& to) const;
  /// Clear of every volume that it can meet, whenever it departs then and however long it takes.
  Answer<Motion> path(const world::Vector3& from, const world::Vector3& to,
                      const Departure& when = {});
  /// What setting out at a moment leads to: least is best.
  struct Prospect {
    double unseen = 0;  ///< part of a zone, if any
    double seconds = std::numeric_limits<double>::infinity();
    bool beats(const Prospect& other) const;
  };
  using Venture = std::function<Prospect(const Departure&)>;
  /// How long to wait in place before setting out, so that air which is closed for a time is open
  /// again [s]; nothing when setting out at once is possible and leads no less far, or waiting is
  /// not. `from` on the ground: there.
  std::optional<double> worth_waiting(const world::Vector3& from, const Departure& when,
                                      const Venture& venture) const;
  /// To fly there, from the ground after a takeoff, and stay for some seconds.
  Prospect of_way(const world::Vector3& from, const world::Vector3& to, double stay,
                  const Departure& when);
  /// To fly there and have the zone in sight; and to fly to a sweep, or what is left of one.
  Prospect of_patrol(const world::Vector3& from, const world::Vector3& to, const world::Zone& zone,
                     const world::SensorModel& device, double seconds, const Departure& when);
  Prospect of_sweep(const world::Vector3& from, const world::Zone& zone,
                    const world::SensorModel& device, const Departure& when);
  Prospect of_rest(const world::Vector3& from, const refiners::Way& way,
                   const world::SensorModel& device, const world::SensorModel& before,
                   const Departure& when);
  /// Some volume is closed for a part of the time from the origin on.
  bool has_windows() const { return has_windows_; }
  /// Whether it may be there for so many seconds: free air around it all the time. On the ground
  /// it may.
  bool may_stay(const world::Vector3& at, const Departure& when, double seconds) const;
  /// Likewise, but what is closed already does not count: it is known and will be left.
  bool stays_open(const world::Vector3& at, const Departure& when, double seconds) const;
  /// Whether a way can be flown then.
  bool stays_open(const refiners::Way& way, const Departure& when) const;
  /// Where it lands that comes from there, and why not where it would.
  struct Landing {
    world::Vector3 at;
    std::string instead;  ///< empty: as wanted
  };
  Answer<Landing> landing_place(const world::Vector3& from, const world::Vector3& wanted,
                                const Departure& when = {}) const;
  /// Out of closed air by the shortest straight way, level, up or down, to where it may stay.
  Answer<Motion> way_out(const world::Vector3& from);
  /// Free air, all around where it wavers or circles.
  bool may_stay(const world::Vector3& at);
  /// As long as it takes to come there from where it is and, after that, to have the zone in sight
  /// for so many seconds; at that height. A head that can be aimed is aimed at the middle of a zone
  /// that is too small to be seen ahead.
  Answer<Motion> patrol(const world::Vector3& from, const world::Zone& zone,
                        const world::SensorModel& device, double seconds,
                        const Departure& when = {});
  /// From its first lane on, and where it turns into that; the way there is not part of it, but it
  /// is set out on `when`. As it will be flown all of the zone is seen, but for what lies in air
  /// that is closed then.
  Answer<Motion> sweep(const world::Vector3& from, const world::Zone& zone,
                       const world::SensorModel& device, const Departure& when = {}) const;
  /// What is left of such a way: `device` sees at least as much from it as `before` did.
  Answer<Motion> rest(const world::Vector3& from, const refiners::Way& way,
                      const world::SensorModel& device, const world::SensorModel& before,
                      const Departure& when = {});
  /// Where that sensor sees the place best, from so many sides, when it sets out then and stays for
  /// so many seconds.
  Answer<std::vector<world::Vector3>> views(const world::Vector3& place,
                                            const world::SensorModel& device, std::size_t count,
                                            const Departure& when = {}, double seconds = 0);
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
  /// One, of each world.volumes: whether it counts.
  using Counted = std::vector<bool>;
  /// Those that are closed at some time while a flight of so many seconds may be under way.
  Counted counted(const Departure& when, double seconds) const;
  world::TimeWindow window(const Departure& when, double seconds) const;
  /// Planned so that it is clear of all that it can meet, which is the more the longer it takes;
  /// what sets out `from` somewhere else flies to it first.
  using Planner = std::function<Answer<Motion>(const Counted&)>;
  Answer<Motion> kept_clear(const world::Vector3& from, const Departure& when, double seconds,
                            const Planner& plan) const;
  struct Arrival {
    Departure then;
    double seconds = 0;  ///< expected, since setting out
  };
  /// After a takeoff when it is on the ground; nothing when there is no way then.
  std::optional<Arrival> arrival(const world::Vector3& from, const world::Vector3& to,
                                 const Departure& when);
  /// To fly to where a motion over a zone begins, and that.
  Prospect of_pattern(const world::Vector3& from, const Answer<Motion>& motion,
                      const Departure& when);
  using Volumes = std::vector<world::Volume>;
  Volumes closed(const Counted& counted) const;
  Volumes closed() const;  ///< at any time from the origin on
  bool has_room(const world::Vector3& at, const Volumes& volumes) const;
  const world::Volume* taking_room(const world::Vector3& at, const Volumes& volumes) const;
  bool met(const refiners::Way& way, const Volumes& volumes) const;
  bool comes_near(const refiners::Way& way, const Volumes& volumes) const;
  /// What corners and turns may take it off its way [m].
  double swing() const;
  std::optional<refiners::Way> way_with_room(const world::Airspace& air, const Volumes& volumes,
                                             const world::Vector3& from,
                                             const world::Vector3& to) const;
  Answer<refiners::Way> way_through(const world::Airspace& air, const world::Vector3& from,
                                    const world::Vector3& to) const;
  /// The world with a ground as fine as the footprint over the zone, and the closed air grown by
  /// that margin, unless the vehicle is in what it strays into.
  world::World world_of(const world::Zone& zone, const world::Vector3& from, double footprint,
                        double margin, const Counted& air) const;
  Answer<refiners::Way> planned_patrol(const world::World& world, const world::Vector3& from,
                                       const world::Zone& zone, double footprint,
                                       double seconds) const;
  /// What is flown again and again over the middle of a zone too small for lanes: a circle, or for
  /// one that hovers, where a circle has no room, to and fro.
  std::vector<refiners::Way> rounds(const world::Vector3& from, const world::Zone& zone,
                                    double footprint, const Counted& air) const;
  std::optional<refiners::Way> again_and_again(const world::Vector3& from,
                                               const refiners::Way& round, double seconds,
                                               const Counted& air);
  /// Where a device looks from a height: a disc on the ground, some metres ahead [m]; or what it is
  /// aimed at, from within `reach`.
  struct Look {
    double ahead = 0, reach = 0;
    std::optional<world::Vector2> aim;
    double width = 0;  ///< of what is seen from that height at once
  };
  class Sight;
  static Look look_of(const world::SensorModel& device, double height, double footprint);
  Answer<Motion> patrol_in(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                           const world::SensorModel& device, double seconds);
  Answer<Motion> patrolled(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                           const Look& look, double seconds);
  Answer<Motion> in_lanes(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                          const Look& look, double seconds, double margin) const;
  Answer<Motion> in_rounds(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                           const Look& look, double seconds);
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
  Answer<Lanes> best_sweep(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                           const world::SensorModel& device, double margin) const;
  Answer<Motion> sweep_in(const Counted& air, const world::Vector3& from, const world::Zone& zone,
                          const world::SensorModel& device) const;
  Answer<Motion> rest_in(const Counted& air, const refiners::Way& way,
                         const world::SensorModel& device, const world::SensorModel& before);
  /// From air that is closed, as when it was closed around the vehicle: out, and on from there.
  Answer<Motion> out_and_on(const world::Vector3& from, const world::Vector3& to);
  Answer<double> footprint(const world::SensorModel& device, double height) const;
  Motion flown(refiners::Way way) const;
  /// Null, with a sentence, when the world makes no airspace for the vehicle. Volumes with a window
  /// that is still to come, or to end, count.
  Answer<const world::Airspace*> airspace();
  Answer<const world::Airspace*> airspace(const Counted& counted);
  Answer<Motion> path_in(const world::Airspace& air, const Volumes& volumes,
                         const world::Vector3& from, const world::Vector3& to);

  Gazetteer gazetteer_;
  world::VehicleModel cautious_;
  MissionTime origin_;
  std::uint64_t seed_;
  refiners::Budget budget_;
  bool has_windows_ = false;
  std::map<Counted, world::Airspace> airspaces_;
};

}  // namespace skein::supervisor
