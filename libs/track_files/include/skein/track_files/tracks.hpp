// SPDX-License-Identifier: Apache-2.0
// Where everybody flew in a recorded run, as KML and GPX.
#pragma once

#include <string>
#include <vector>

#include "skein/journal/record.hpp"
#include "skein/report/run_info.hpp"

namespace skein::track_files {

struct TrackOptions {
  /// Height of the sea over the ellipsoid there [m]: both formats count heights from sea level,
  /// runs from the ellipsoid.
  double geoid = 0;
};

/// KML 2.2: for each UAV a line, and a track in time (gx:Track); zones, closed air, places and
/// alarms in folders of these names, on the ground. `records` are in the order of time.
/// Preconditions of both: the run says where on Earth it was (info.origin); finite positions.
std::string to_kml(const report::RunInfo& info, const std::vector<journal::Record>& records,
                   const TrackOptions& options = {});

/// GPX 1.1: a track for each UAV, way-points for places and alarms.
std::string to_gpx(const report::RunInfo& info, const std::vector<journal::Record>& records,
                   const TrackOptions& options = {});

}  // namespace skein::track_files
