// SPDX-License-Identifier: Apache-2.0
// viewpoint: the best places from which to perceive a target.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::refiners {

/// An additional constraint on places, such as the spatial constraint models of joint tasks. Must
/// be a pure function.
struct PlaceConstraint {
  std::string name;
  std::function<bool(const world::Vector3&)> holds;
};

/// Most view points of one query.
inline constexpr std::size_t kMostViewpoints = 64;
/// Least distance between two points of an answer, as a fraction of the farthest distance.
inline constexpr double kLeastApart = 1.0 / 16;

/// A place is valid if it is in the airspace, at least `clearance` and at most the vehicle's
/// ceiling over the ground, outside of all no-fly volumes, satisfies the constraints, and the
/// sensor perceives the target from it: between both distances, in the aperture, in line of sight,
/// with a quality above 0. A sensor on gimbals can look in any direction; a fixed one only in those
/// that a heading of the level vehicle gives it. For a vehicle that cannot hover the conditions are
/// the same, since it perceives in passing.
struct ViewpointQuery {
  world::VehicleModel vehicle;
  std::string device;  ///< name of one of the vehicle's sensors
  /// The place to perceive, on the ground or over it. On the ground (or up to 0.5 m below) line of
  /// sight is tested to a point 1 cm above; incidence is always that on the ground at the target.
  world::Vector3 target = world::Vector3::Zero();
  double nearest = 0;      ///< least distance from the target [m]
  double farthest = 0;     ///< greatest distance from the target [m]; 0: the sensor's range
  double clearance = 20;   ///< least height over the ground [m]
  std::size_t count = 1;   ///< wanted number of view points
  double least_angle = 0;  ///< between two view points, horizontally, seen from the target [rad]
  std::optional<world::Vector3> from;  ///< position of the vehicle, for `cost_of_way`
  double cost_of_way = 0;              ///< utility lost per metre of distance from `from`
  MissionTime at;                      ///< volumes with a time window count from then on
  std::vector<PlaceConstraint> constraints;
};

struct ViewPoint {
  world::Vector3 position = world::Vector3::Zero();
  double heading = 0, pitch = 0;  ///< of the boresight [rad], ENU
  double quality = 0;             ///< of the perception, (0, 1]: world::perceived_quality
  double utility = 0;  ///< quality - cost of use of the sensor - cost_of_way × distance from `from`
};

struct Viewpoints {
  std::vector<ViewPoint> points;  ///< best first; fewer than asked for when there are no more
  /// Number of ground profiles traced, each as costly as one line of sight; one profile answers all
  /// visibility questions along an azimuth (world::HorizonProfile).
  std::uint64_t sight_checks = 0;
};

/// View points, best first: greedily the best one, then the next best that keeps the distances to
/// the ones before. If these are fewer than `count` with a `least_angle`, the combination with the
/// greatest sum of utilities over 240 azimuths instead. Refined cost: 1 - utility of the best.
/// Duration: of a straight flight from `from` to it, if given. Steps of the budget: candidates
/// evaluated; when it ends the best so far is returned, kBudgetExhausted if there is none. Source:
/// spec 4.2 (viewpoint), T IV.2.2.
Outcome<Viewpoints> refine(const ViewpointQuery& query, const Setting& setting);

}  // namespace skein::refiners
