// SPDX-License-Identifier: Apache-2.0
// Paths and times between the places of a tour or a plan, planned on demand; private.
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

/// Parameters common to all paths.
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
  /// The refusal of a place where the vehicle cannot be; `field` names it in the query. Nothing:
  /// the place is free, or the time is up.
  std::optional<Refusal> closed(Id place, const std::string& field) const;

  /// Duration of the straight flight [s], free or not: a lower bound on every path, since climb,
  /// descent and level flight in a steady wind satisfy the triangle inequality, and so does their
  /// maximum. Infinite against too strong a wind, as is every path then.
  double bound(Id from, Id to) const;
  bool can_go_straight(Id from, Id to) const;
  /// Plans the path unless it is known: at most one call of the planner; none if the known reverse
  /// path is as good, nor between places that other queries have shown to be disconnected. False if
  /// the time is up before; never for a straight path.
  bool settle(Id from, Id to);
  /// Whether settle() has found the result; always true from a place to itself.
  bool is_known(Id from, Id to) const;
  /// Expected time of a known path [s], at least its bound; infinite if none exists. Of an unknown
  /// path its bound, or infinite if the places are disconnected.
  double seconds(Id from, Id to) const;
  /// The path, without equal points in succession. Precondition: known, with a finite time.
  Way way(Id from, Id to) const;
  /// The reason for the infinite time of a known path.
  std::string why_closed(Id from, Id to) const;
  Flight flight(const Way& way) const;

  /// Whether the clock ended the search for some path.
  bool cut_short() const { return cut_short_; }
  /// Number of calls of the planner.
  std::size_t planned() const { return planned_; }
  /// Number of disconnected pairs found; when it grows, further times may have become infinite.
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
