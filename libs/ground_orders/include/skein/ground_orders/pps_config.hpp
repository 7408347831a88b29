// SPDX-License-Identifier: Apache-2.0
// What perception processing goes by: what each device's looks are worth, and when belief becomes
// an alarm.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::ground_station {

/// Of devices of well-known names whose model does not say: "fire-sensor" and "ir" raise, "visible"
/// confirms, "mapping" is weak evidence.
std::map<std::string, world::SensorEvidence, std::less<>> default_devices();

struct PpsConfig {
  /// By device name; devices that are not here are logged and give no evidence.
  std::map<std::string, world::SensorEvidence, std::less<>> devices = default_devices();
  /// By UAV and device: what the UAV's model says, which counts before the name.
  std::map<std::pair<std::string, std::string>, world::SensorEvidence> models = {};
  double prior = 0.1;     ///< belief in a new candidate before the look that made it
  double raise = 0.9;     ///< belief from which a candidate is an alarm
  double confirm = 0.97;  ///< belief from which a confirming device's sight confirms it
  double infirm = 0.05;   ///< belief down to which a raised alarm is infirmed, a candidate dropped
  double gate =
      3;  ///< association distance, in standard deviations of detection and candidate together
  /// [m] places closer than this are one fire: a burning patch scatters detections further than the
  /// errors of the sensors do, and one outlier must not raise a second alarm beside the first.
  double least_separation = 25;
  double least_spread = 2;      ///< [m] lower bound on a detection's standard deviation
  double least_confidence = 0;  ///< detections below it are not considered
  double refine_distance = 10;  ///< [m] an alarm that moved by it is told again
  Duration decorrelation =
      Duration::milliseconds(1000);  ///< looks of one device closer than this are one
  Duration forget =
      Duration::milliseconds(300'000);  ///< candidates not seen for this long are dropped
  /// An alarm that is still seen is told again so often, and is as old as it was seen last for who
  /// watches it; zero: only when it changed, and it does not age.
  Duration tell_again = {};
};

/// Why a configuration is unusable, in sentences, all at once; empty when it is fine.
std::vector<std::string> problems_of(const PpsConfig& config);

}  // namespace skein::ground_station
