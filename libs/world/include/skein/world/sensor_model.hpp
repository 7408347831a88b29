// SPDX-License-Identifier: Apache-2.0
// Sensor models: view geometry, detection, quality and evidence.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::world {

/// How a sensor reacts, at each look, to an object of some kind that is in its view.
struct SensorResponse {
  double probability = 0;   ///< that the look detects it, [0, 1]; the rest are missed
  double confidence = 0;    ///< that the sensor gives to such a detection, [0, 1]
  std::string reported_as;  ///< kind it is taken for: a fire sensor takes a hot vehicle for a fire
  bool operator==(const SensorResponse&) const = default;
};

/// Quality with which a sensor perceives visible ground: the product of a factor for distance and a
/// factor for incidence. By default both are 1 within range. Source: spec 4.1 (perception).
struct QualityModel {
  double best_distance = 0;  ///< up to here the distance factor is 1 [m], [0, range]
  double at_range = 1;       ///< distance factor at full range, [0, 1]; linear in between
  /// The incidence factor is the cosine of the incidence to this power, >= 0. At 0 incidence does
  /// not matter; otherwise ground that faces away cannot be perceived.
  double incidence_power = 0;
  bool operator==(const QualityModel&) const = default;
};

/// How probable it is that one look reports a kind at a place, when there is a fire and when not.
struct Likelihood {
  double if_fire = 0;      ///< (0, 1)
  double if_not_fire = 0;  ///< (0, 1)
  bool operator==(const Likelihood&) const = default;
};

/// The weight of a device's looks as evidence for a fire.
struct SensorEvidence {
  /// By reported kind; the sums stay below 1, and the rest is the probability of reporting nothing.
  /// A report of another kind counts as reporting nothing.
  std::map<std::string, Likelihood, std::less<>> kinds;
  /// Only such a device confirms an alarm (a visible camera recognises smoke; a heat cell does
  /// not).
  bool confirms = false;
  /// Limit on the total weight of all looks of one such device, in natural log-odds: its errors are
  /// correlated (a hot engine stays hot), so that it alone can never give certainty.
  double limit = 5;
  bool operator==(const SensorEvidence&) const = default;
};

/// One device of a vehicle. It looks once per period, in a cone about its boresight.
/// Source: spec 4.1 (perception), 8.2.
struct SensorModel {
  std::string device;   ///< the name tasks use: "fire-sensor", "visible", "ir", "mapping"
  double aperture = 0;  ///< half angle of the cone [rad], (0, π/2]
  double boresight_pitch =
      0;  ///< up from the horizon, ahead of the vehicle [rad]; -π/2: straight down
  bool gimballed = false;             ///< can be pointed at a target at any attitude of the vehicle
  double range = 0;                   ///< [m], > 0
  Duration period;                    ///< between two looks, > 0
  double false_alarm_rate = 0;        ///< mean number per second of looking [1/s] (Poisson)
  std::string false_alarm_kind;       ///< what false alarms are reported as
  double false_alarm_confidence = 0;  ///< [0, 1]
  double position_spread = 0;         ///< standard deviation of a reported position, per axis [m]
  /// By kind of object; the sensor is blind to kinds that are not here.
  std::map<std::string, SensorResponse, std::less<>> responses;
  QualityModel quality;
  double cost = 0;  ///< of a use (power, film, radio capacity), in units of quality, [0, 1]
  std::optional<SensorEvidence> evidence;  ///< absent: the model does not say
  /// Uses in the planning domain ("detection", "mapping"), beside those that the domain gives to
  /// devices of this name.
  std::vector<std::string> serves;
  bool operator==(const SensorModel&) const = default;
};

/// The cone a sensor looks through at one instant.
struct View {
  Vector3 viewpoint = Vector3::Zero();
  Vector3 direction = Vector3::UnitX();  ///< unit length
  double range = 0;                      ///< [m]
  double aperture = 0;                   ///< half angle [rad]
};

/// True when some part of a ball (radius 0: the point) is in the cone and within range of the
/// viewpoint; terrain is not considered.
bool in_view(const View& view, const Vector3& centre, double radius = 0);

/// How well the ground at `target` is perceived from a viewpoint, [0, 1]; 0 beyond the range.
/// Incidence is the angle between the line of sight and `normal`, of unit length: of the ground at
/// the target, since it is its foreshortening that loses detail; straight up for what has no
/// surface of its own. Aperture, attitude and terrain are not considered. Monotone: never better
/// further away on the same line. Source: spec 4.1 (quality as a function of distance and
/// incidence).
double perceived_quality(const SensorModel& sensor, const Vector3& viewpoint, const Vector3& target,
                         const Vector3& normal);

/// The two factors of perceived_quality(): `distance` in [0, range], cosine of the incidence in
/// [-1, 1].
double distance_quality(const SensorModel& sensor, double distance);
double incidence_quality(const SensorModel& sensor, double cosine);

}  // namespace skein::world
