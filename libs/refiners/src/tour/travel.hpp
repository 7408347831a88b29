// SPDX-License-Identifier: Apache-2.0
// Ways and times between the places of a tour or a plan, found when they are asked for; private.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/straight_flight.hpp"
#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

/// What all ways have in common.
struct Traveller {
  const world::VehicleModel& vehicle;
  double clearance = 0;
  double speed = 0;
  MissionTime depart;
};

/// Straight where the airspace is free, else by the planner of the setting, or on the voxels of an
/// airspace that is built once, with the volumes that may be met at any time from `depart` on.
/// Places are numbered as they are added, the same place only once. Thread rule: one thread.
class Travel {
 public:
  using Id = std::size_t;

  static Result<Travel, Refusal> over(const Traveller& who, const Setting& setting,
                                      const world::Vector3& from, const world::Vector3& to);

  Id add(const world::Vector3& place);
  /// Why the vehicle cannot be there; `field` is the place's. Nothing when there is no time to
  /// tell.
  std::optional<Refusal> closed(Id place, const std::string& field) const;

  /// What the straight flight would take [s], free or not: no way takes less, since climbing,
  /// descending and flying level on any course in a steady wind all keep the triangle inequality,
  /// and so does the slowest of them. Infinite against too strong a wind: so is every way then.
  double bound(Id from, Id to) const;
  bool can_go_straight(Id from, Id to) const;
  /// Finds the way, if it is not known: at most one call of the planner, none when the way back
  /// was found and is as good, nor between two places that others show to be shut off from each
  /// other. False when the time is up before it is known; never for one that is straight.
  bool settle(Id from, Id to);
  /// True once it was settled; from a place to itself always.
  bool is_known(Id from, Id to) const;
  /// Expected time of a known way [s], at least its bound; infinite when there is none; of one that
  /// is not known its bound, or infinite when the places are shut off from each other.
  double seconds(Id from, Id to) const;
  /// Precondition: known, and its time is finite. No point twice in succession.
  Way way(Id from, Id to) const;
  /// Why a known way has an infinite time.
  std::string why_closed(Id from, Id to) const;
  Flight flight(const Way& way) const;

  /// True when the clock ended the search for some way.
  bool cut_short() const { return cut_short_; }
  /// Calls of the planner.
  std::size_t planned() const { return planned_; }
  /// Pairs of places found shut off: when there are more, other times may have become infinite.
  std::size_t shut_off() const { return shut_off_.size(); }

 private:
  struct Leg {
    double seconds = 0;
    Way way;          // empty: straight, or none
    std::string why;  // there is none
  };

  Travel(const Traveller& who, const Setting& setting, world::Airspace airspace);

  bool turns_back_alike() const;
  std::optional<Leg> plan(Id from, Id to);
  Leg turned(Id from, Id to, const Leg& back) const;
  void put(Id from, Id to, Leg leg);
  void join(Id from, Id to);
  Id region(Id place) const;
  bool are_shut_off(Id from, Id to) const;

  Traveller who_;
  StraightFlight straight_;
  const Setting* setting_;
  world::Airspace airspace_;
  std::vector<world::Vector3> places_;
  std::map<std::array<double, 3>, Id> ids_;
  std::map<std::pair<Id, Id>, Leg> legs_;
  std::vector<bool> left_;           // by place: some leg from there is known
  mutable std::vector<Id> regions_;  // of each place: another of the same region, or itself
  std::vector<std::pair<Id, Id>> shut_off_;
  std::size_t planned_ = 0;
  bool cut_short_ = false, time_is_up_ = false;
};

}  // namespace skein::refiners
