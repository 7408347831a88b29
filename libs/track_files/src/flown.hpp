// SPDX-License-Identifier: Apache-2.0
// What of a run lies on Earth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/track_files/tracks.hpp"

namespace skein::track_files {

struct Fix {
  std::uint64_t at = 0;        ///< [ns since 1970]
  world::GeodeticPoint point;  ///< its altitude over the sea
};

struct Track {
  std::string uav, model;
  std::vector<Fix> fixes;
};

struct Spot {
  std::string name;
  std::string kind;  ///< "place" or "alarm"
  world::GeodeticPoint point;
};

/// The run in the order of its info; alarms as they were last.
class Flown {
 public:
  Flown(const report::RunInfo& info, const std::vector<journal::Record>& records,
        const TrackOptions& options);

  const std::vector<Track>& tracks() const { return tracks_; }
  const std::vector<Spot>& spots() const { return spots_; }
  world::GeodeticPoint on_earth(double x, double y, double z) const;

 private:
  void see_telemetry(const journal::Record& record);
  void see_alarm(const journal::Record& record);

  geodesy::GeodeticFrame frame_;
  double geoid_;
  std::uint64_t epoch_;
  std::vector<Track> tracks_;
  std::vector<Spot> spots_;
};

/// "8.250000123,47.5,430.25" with another separator: degrees to a tenth of a millimetre, metres to
/// a millimetre.
std::string degrees(double value);
std::string metres(double value);

}  // namespace skein::track_files
