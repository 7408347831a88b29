// SPDX-License-Identifier: Apache-2.0
// viewpoint: where best to perceive a place from.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::refiners {

/// An extra constraint on places; the spatial constraint models of the interaction chapter come in
/// through it. Must be pure.
struct PlaceConstraint {
  std::string name;
  std::function<bool(const world::Vector3&)> holds;
};

/// Most that may be asked for at once.
inline constexpr std::size_t kMostViewpoints = 64;
/// Two points of an answer are at least so far apart, as a part of the farthest distance: what is
/// nearer is the same place.
inline constexpr double kLeastApart = 1.0 / 16;

/// A place will do when it is in the airspace, at least `clearance` and at most the vehicle's
/// ceiling over the ground, out of every no-fly volume, holds the constraints, and perceives the
/// target: within both distances, in the sensor's aperture, in line of sight, with a quality above
/// 0. A sensor on gimbals looks anywhere; a fixed one where a heading of the vehicle, level, brings
/// it. A vehicle that cannot hover perceives in passing: nothing more is asked of it.
struct ViewpointQuery {
  world::VehicleModel vehicle;
  std::string device;  ///< of one of its sensors
  /// What is to be perceived: a place of the ground, or over it. On the ground (or up to 0.5 m
  /// under it) it is looked at 1 cm above; incidence is always that on the ground below it.
  world::Vector3 target = world::Vector3::Zero();
  double nearest = 0;      ///< least distance from the target [m]
  double farthest = 0;     ///< greatest [m]; 0: the sensor's range
  double clearance = 20;   ///< least height over the ground [m]
  std::size_t count = 1;   ///< how many are wanted, best first
  double least_angle = 0;  ///< between two of them, seen from the target, horizontally [rad]
  std::optional<world::Vector3> from;  ///< where the vehicle is: nearer is a little better
  double cost_of_way = 0;              ///< utility lost per metre from `from`
  MissionTime at;                      ///< volumes with a time window count from then on
  std::vector<PlaceConstraint> constraints;
};

struct ViewPoint {
  world::Vector3 position = world::Vector3::Zero();
  double heading = 0, pitch = 0;  ///< of the boresight [rad], ENU
  double quality = 0;             ///< of what is perceived there, (0, 1]: world::perceived_quality
  double utility = 0;  ///< quality - cost of use of the sensor - cost_of_way × distance from `from`
};

struct Viewpoints {
  std::vector<ViewPoint> points;  ///< best first; fewer than asked for when there are no more
  /// Times the ground was traced, each as dear as one line of sight; one settles what is seen all
  /// along an azimuth (world::HorizonProfile).
  std::uint64_t sight_checks = 0;
};

/// The best, and the next best that are apart from those before; when so fewer are found than
/// asked for with a `least_angle`, those of the greatest sum of utilities instead, of 240 azimuths.
/// Best first either way. Refined cost: 1 - utility of the best. Duration: of a straight flight
/// there from `from`, if given. Steps of the budget: candidates looked at; the best so far is given
/// when it ends, refused (kBudgetExhausted) when there is none. Source: spec 4.2 (viewpoint), T
/// IV.2.2.
Outcome<Viewpoints> refine(const ViewpointQuery& query, const Setting& setting);

}  // namespace skein::refiners
