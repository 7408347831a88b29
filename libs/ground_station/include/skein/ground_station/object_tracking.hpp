// SPDX-License-Identifier: Apache-2.0
// Tracking of moving objects by sensor detections.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/ground_orders/object_spec.hpp"
#include "skein/world/perception.hpp"

namespace skein::ground_station {

/// The estimated position of an object at its last sighting.
struct ObjectSeen {
  std::string name;
  std::string kind;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU
  double spread = 0;                                 ///< standard deviation per axis [m]
  MissionTime seen;
  bool operator==(const ObjectSeen&) const = default;
};

/// Kalman filters, one for each object: a random walk observed by sensors of known spread. A
/// detection of the object's kind within four standard deviations (of both together) is associated
/// with it; of several in one look, the nearest. A track is confirmed by the second sighting that
/// agrees with the one before (two-point initiation; Bar-Shalom, Li, Estimation with Applications
/// to Tracking and Navigation, 2001, 5.5.3), since a single one may be a false alarm, and missions
/// are planned anew when an object is reported elsewhere. Until then it is given up after three
/// looks of the device that saw it over the same place that do not: the longer it is unconfirmed,
/// the further off may be what agrees with it, by another false alarm. Each sighting of a confirmed
/// object is reported, at most once per second of look time. Late looks count by their age.
/// Deterministic. Cost of a look: O(detections × objects). Thread rule: one thread. Source:
/// spec 7.6.
class ObjectTracking {
 public:
  /// Precondition: problems_of(objects) is empty.
  explicit ObjectTracking(std::vector<ObjectSpec> objects);

  /// Adds a look; returns the objects to report. Figures that are not finite are disregarded.
  std::vector<ObjectSeen> handle(const world::Perception& look);

 private:
  struct Track {
    ObjectSpec spec;
    world::Vector3 position = world::Vector3::Zero();
    double variance = 0;                   ///< per axis [m²]
    std::optional<MissionTime> seen = {};  ///< last sighting; absent: `position` is assumed
    bool sure = false;                     ///< confirmed: two sightings agreed
    std::string by = {};                   ///< device of the first sighting, "marvin/visible"
    int misses = 0;                        ///< its looks over that place since then
    std::optional<MissionTime> told = {};  ///< sighting last reported
  };
  /// The detection associated with a track that has a sighting; null: none.
  static const world::Detection* sighting_of(const Track& track, const world::Perception& look);
  /// The detection associated with a track that has no sighting yet; null: none.
  static const world::Detection* first_of(const Track& track, const world::Perception& look);
  /// Begins a track that is not confirmed, or gives it up.
  static void look_for(Track& track, const world::Perception& look);
  static void begin(Track& track, const world::Detection& sighting, const world::Perception& look);
  static void follow(Track& track, const world::Detection& sighting, MissionTime at);

  std::vector<Track> tracks_;
};

}  // namespace skein::ground_station
