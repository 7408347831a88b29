// SPDX-License-Identifier: Apache-2.0
// What lies on the map, as GeoJSON with the styles that Foxglove's map knows.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/geodesy/geodetic_frame.hpp"
#include "skein/journal/record.hpp"
#include "skein/report/run_info.hpp"

namespace skein::foxglove {

using Frame = geodesy::GeodeticFrame;

/// Red, green, blue in [0, 1]; for the n-th UAV (Okabe and Ito 2008).
std::array<double, 3> colour_of(std::size_t uav);
std::string html_colour(const std::array<double, 3>& colour);

/// Zones and places.
std::string zones_geojson(const report::RunInfo& info, const Frame& frame);

/// The air that is closed at that instant.
std::string air_geojson(const report::RunInfo& info, MissionTime at, const Frame& frame);

/// Ways by name, each x y z …, in that colour.
std::string ways_geojson(const std::map<std::string, std::vector<double>>& ways,
                         const std::string& colour, const Frame& frame);

/// Records of alarms: place, state, belief.
std::string alarms_geojson(const std::map<std::int64_t, journal::Record>& alarms,
                           const Frame& frame);

}  // namespace skein::foxglove
