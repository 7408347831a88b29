// SPDX-License-Identifier: Apache-2.0
// Readers for the common parts of world files: origin, terrain, wind, zones, points.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/config/reader.hpp"
#include "skein/foundation/time.hpp"
#include "skein/world/geodetic.hpp"
#include "skein/world/terrain.hpp"
#include "skein/world/volume.hpp"
#include "skein/world/wind.hpp"
#include "skein/world/zone.hpp"

// Each reports errors to the reader's diagnostics and then returns a harmless value.
namespace skein::world {

/// Limit of coordinates and lengths in files [m].
inline constexpr double kFarthest = 1e6;
inline constexpr config::Range kCoordinate{-kFarthest, kFarthest, "m"};

/// {latitude, longitude, altitude}, in degrees and metres, all required.
GeodeticPoint read_geodetic(const config::Reader& reader);
/// {west, south, east, north, cell, base, hills: [{at, height, radius}]}.
TerrainSpec read_terrain(const config::Reader& reader);
/// [{at, height, radius}, …].
std::vector<HillSpec> read_hills(const config::Reader& reader);
/// {toward, speed, gusts}; absent: none.
Wind read_wind(const config::Reader& reader);
/// {NAME: [[x, y], …]}.
std::vector<Zone> read_zones(const config::Reader& reader);

/// [x, y] and [x, y, z] in metres.
Vector2 read_point_2d(const config::Reader& reader);
Vector3 read_point(const config::Reader& reader);
/// [[x, y], …], a simple polygon.
Polygon read_polygon(const config::Reader& reader);
/// {polygon, floor, ceiling, from, until}. Other keys are ignored: the caller, which may have keys
/// of its own, has to check for unknown ones.
Volume read_volume(const std::string& name, const config::Reader& reader);
/// Seconds of mission time, not negative.
MissionTime read_instant(const config::Reader& reader, MissionTime otherwise = {});

/// The items of a list and the entries of a map; null items and empty names are reported and left
/// out.
std::vector<config::Reader> items_of(const config::Reader& reader);
std::vector<std::pair<std::string, config::Reader>> entries_of(const config::Reader& reader);

}  // namespace skein::world
