// SPDX-License-Identifier: Apache-2.0
// Objects that move, followed by what sensors tell of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/ground_orders/object_spec.hpp"
#include "skein/world/perception.hpp"

namespace skein::ground_station {

/// Where it was when it was seen last.
struct ObjectSeen {
  std::string name;
  std::string kind;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
  double spread = 0;                                 ///< standard deviation per axis [m]
  MissionTime seen;
  bool operator==(const ObjectSeen&) const = default;
};

/// A random walk seen by sensors of known spread, so the estimate follows by Kalman's gain. A
/// detection of its kind within four standard deviations of both is it; the nearest, if there are
/// several in a look. It is followed from the second sighting on that agrees with the one before
/// (two-point initiation; Bar-Shalom, Li, Estimation with Applications to Tracking and Navigation,
/// 2001, 5.5.3): a single one may be a false alarm of a sensor, and missions are planned anew where
/// an object is said to be. Each is told when it is seen, not more often than every second of
/// looks. Looks that come late count by how old they are. Deterministic. Cost of a look:
/// O(detections × objects). Thread rule: one thread. Source: spec 7.6.
class ObjectTracking {
 public:
  /// Precondition: problems_of(objects) is empty.
  explicit ObjectTracking(std::vector<ObjectSpec> objects);

  /// What is to be told of it. Figures that are not finite are disregarded.
  std::vector<ObjectSeen> handle(const world::Perception& look);

 private:
  struct Track {
    ObjectSpec spec;
    world::Vector3 position = world::Vector3::Zero();
    double variance = 0;                   ///< per axis [m²]
    std::optional<MissionTime> seen = {};  ///< absent: it is thought to be there
    bool sure = false;                     ///< two sightings agreed
    std::optional<MissionTime> told = {};  ///< as seen then
  };
  /// Of those where it can have got to.
  static const world::Detection* sighting_of(const Track& track, const world::Perception& look);
  /// Of those where it may be seen first.
  static const world::Detection* first_of(const Track& track, const world::Perception& look);
  static void begin(Track& track, const world::Detection& sighting, MissionTime at);
  static void follow(Track& track, const world::Detection& sighting, MissionTime at);

  std::vector<Track> tracks_;
};

}  // namespace skein::ground_station
