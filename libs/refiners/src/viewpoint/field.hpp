// SPDX-License-Identifier: Apache-2.0
// Candidate places around a target: their utility, and whether they are permitted and see it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "skein/refiners/setting.hpp"
#include "skein/refiners/viewpoint.hpp"
#include "skein/world/horizon.hpp"

namespace skein::refiners {

/// A place as seen from the target.
struct Bearing {
  /// A full turn, in the unit of azimuths: whole numbers, so that the same plane is the same
  /// number.
  static constexpr std::int32_t kTurn = 46080;

  std::int32_t azimuth = 0;  ///< [0, kTurn)
  double elevation = 0;      ///< up from the horizon [rad]
  double range = 0;          ///< [m]

  static double radians(std::int32_t azimuth);
};

/// A box of bearings.
struct BearingCell {
  std::int32_t azimuth = 0, azimuth_end = 0;  ///< the same: one plane only
  double elevation = 0, elevation_end = 0;
  double range = 0, range_end = 0;

  Bearing middle() const;
  /// Greatest angle between the middle and another direction of it, as seen from the target [rad].
  double angular_radius() const;
};

/// Properties common to all cells of the same directions, whatever their ranges.
struct Aspect {
  world::Vector3 direction = world::Vector3::Zero();  ///< of the middle, from the target
  double radius = 0;                                  ///< BearingCell::angular_radius() [rad]
  double quality = 0;                                 ///< upper bound, from incidence
};

struct Place {
  world::Vector3 position = world::Vector3::Zero();
  double quality = 0, utility = 0;  ///< as of a ViewPoint
};

/// Result of the checks of a place.
enum class Fate : std::uint8_t {
  kGood,
  kImperceptible,  ///< the ground faces away, or quality is nil at that distance
  kOutside,        ///< of the airspace
  kTooLow,
  kTooHigh,
  kInVolume,
  kConstraint,
  kTaken,  ///< too near a view point chosen before
  kHidden,
};

struct Verdict {
  Fate fate = Fate::kGood;
  std::size_t which = 0;  ///< volume or constraint
  auto operator<=>(const Verdict&) const = default;
};

/// One query in its world, with defaults filled in. Thread rule: one thread (it keeps horizons).
class ViewpointField {
 public:
  /// Precondition: the query is valid. All arguments must outlive this object.
  ViewpointField(const ViewpointQuery& query, const Setting& setting,
                 const world::SensorModel& sensor);

  /// The cell of all bearings; with empty extents if the sensor can look in no direction.
  const BearingCell& whole() const { return whole_; }
  Place place(const Bearing& bearing) const;
  /// Upper bound on the utility of places in the cell. Cost: constant.
  double utility_bound(const BearingCell& cell) const {
    return utility_bound(cell, aspect_of(cell));
  }
  /// The same with a known aspect, which saves most of the cost.
  double utility_bound(const BearingCell& cell, const Aspect& aspect) const;
  Aspect aspect_of(const BearingCell& cell) const;
  /// Checks whether the place is permitted and sees the target. The first call for an azimuth
  /// traces the ground along it; later ones reuse that profile.
  Verdict judge(const Bearing& bearing, const Place& place);
  /// The place as an element of the result.
  ViewPoint view_point(const Bearing& bearing) const;
  /// "in volume 'tower'": after "of 900 places, 12 are".
  std::string describe(const Verdict& verdict) const;
  std::uint64_t sight_checks() const { return sight_checks_; }
  const ViewpointQuery& query() const { return query_; }

 private:
  bool is_outside(const world::Vector3& position) const;
  world::Vector3 position(const Bearing& bearing) const;
  Verdict judge_position(const world::Vector3& position) const;
  bool sees(const Bearing& bearing, const world::Vector3& position);

  const ViewpointQuery& query_;
  const world::World& world_;
  const world::SensorModel& sensor_;
  std::vector<const world::Volume*> volumes_;  // those that hold
  world::Vector3 eye_ =
      world::Vector3::Zero();  // what is to be seen: the target, just off the ground
  world::Vector3 normal_ = world::Vector3::UnitZ();
  BearingCell whole_;
  std::map<std::int32_t, world::HorizonProfile> horizons_;  // by azimuth, from the target
  std::uint64_t sight_checks_ = 0;
};

}  // namespace skein::refiners
