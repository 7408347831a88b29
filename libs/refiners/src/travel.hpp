// SPDX-License-Identifier: Apache-2.0
// Ways and times between the places of a tour or a plan, each found once; private.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "skein/refiners/voxel_path_planner.hpp"

namespace skein::refiners {

/// What all ways have in common.
struct Traveller {
  const world::VehicleModel& vehicle;
  double clearance = 0;
  double speed = 0;
  MissionTime depart;
};

/// Straight where the airspace is free, else by the planner. Places are numbered as they are added,
/// the same place only once. Thread rule: one thread.
class Travel {
 public:
  using Id = std::size_t;

  static Result<Travel, Refusal> over(const Traveller& who, const Setting& setting,
                                      const world::Vector3& from, const world::Vector3& to);

  Id add(const world::Vector3& place);
  /// True when the vehicle can be there.
  bool is_free(Id place) const;
  /// Expected time [s]; infinite when there is no way. Asks the planner at most once a pair, and
  /// once for both senses when the way back is as good.
  double seconds(Id from, Id to);
  /// Precondition: seconds(from, to) is finite.
  Way way(Id from, Id to) const;
  Flight flight(const Way& way) const;
  /// True when the clock ended the search for some way.
  bool cut_short() const { return cut_short_; }

 private:
  Travel(const Traveller& who, const Setting& setting, world::Airspace airspace);

  bool can_go_straight(Id from, Id to) const;
  bool turns_back_alike() const;
  double plan(Id from, Id to);
  void reserve_pairs();

  Traveller who_;
  const Setting* setting_;
  world::Airspace airspace_;
  std::vector<world::Vector3> places_;
  std::map<std::array<double, 3>, Id> ids_;
  std::size_t width_ = 0;
  std::vector<double> seconds_;               // width × width; negative: not yet known
  std::map<std::pair<Id, Id>, Way> planned_;  // those that are not straight
  bool cut_short_ = false;
};

}  // namespace skein::refiners
