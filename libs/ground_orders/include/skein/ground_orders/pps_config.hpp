// SPDX-License-Identifier: Apache-2.0
// Configuration of perception processing: the evidence of each device, and the thresholds of
// belief.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/world/sensor_model.hpp"

namespace skein::ground_station {

/// Evidence by well-known device names, for models that do not state it: "fire-sensor" and "ir"
/// raise, "visible" confirms, "mapping" is weak evidence.
std::map<std::string, world::SensorEvidence, std::less<>> default_devices();

struct PpsConfig {
  /// By device name; looks of other devices are logged and give no evidence.
  std::map<std::string, world::SensorEvidence, std::less<>> devices = default_devices();
  /// By UAV and device, from the UAVs' models; takes precedence over `devices`.
  std::map<std::pair<std::string, std::string>, world::SensorEvidence> models = {};
  double prior = 0.1;     ///< belief in a new candidate before its first look
  double raise = 0.9;     ///< a candidate with at least this belief becomes an alarm
  double confirm = 0.97;  ///< an alarm with at least this belief may be confirmed by sight
  double infirm = 0.05;   ///< at most this belief infirms a raised alarm, or drops a candidate
  double gate =
      3;  ///< association distance, in standard deviations of detection and candidate together
  /// [m] places closer than this are one fire: a burning patch scatters detections further than the
  /// errors of the sensors do, and one outlier must not raise a second alarm beside the first.
  double least_separation = 25;
  double least_spread = 2;      ///< [m] lower bound on a detection's standard deviation
  double least_confidence = 0;  ///< detections with less confidence are ignored
  double refine_distance = 10;  ///< [m] an alarm that moved by more is reported again
  Duration decorrelation =
      Duration::milliseconds(1000);  ///< looks of one device closer than this are one
  Duration forget =
      Duration::milliseconds(300'000);  ///< candidates not seen for this long are dropped
  /// Interval after which an alarm that is still seen is reported again; its receivers then take
  /// its age from its last sighting. Zero: it is reported only when it changes, and does not age.
  Duration tell_again = {};
};

/// Why a configuration is unusable, in sentences, all at once; empty when it is fine.
std::vector<std::string> problems_of(const PpsConfig& config);

}  // namespace skein::ground_station
