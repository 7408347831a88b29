// SPDX-License-Identifier: Apache-2.0
// Description of a run (file run.json of its folder), which a report needs beside the event log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skein/foundation/diagnostics.hpp"
#include "skein/foundation/result.hpp"
#include "skein/report/records.hpp"

namespace skein::report {

enum class RuntimeKind : std::uint8_t { kDds, kVirtual };

/// A rectangle of the local frame [m].
struct Extents {
  double west = 0.0;
  double south = 0.0;
  double east = 0.0;
  double north = 0.0;
  bool operator==(const Extents&) const = default;
};

/// Heights on a regular grid, for the map's relief. Row 0 is the southernmost, values run east
/// along a row; a value is the height [m] at west + column × cell, south + row × cell.
struct TerrainGrid {
  double west = 0.0;
  double south = 0.0;
  double cell = 1.0;  ///< [m], > 0
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<double> values;  ///< width × height values [m], row by row
  bool operator==(const TerrainGrid&) const = default;
};

struct GroundPoint {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const GroundPoint&) const = default;
};

struct Zone {
  std::string name;
  std::vector<GroundPoint> polygon;
  bool operator==(const Zone&) const = default;
};

/// Where on Earth the local frame has its origin (WGS 84): degrees, degrees, metres.
struct Origin {
  double latitude = 0.0;
  double longitude = 0.0;
  double altitude = 0.0;
  bool operator==(const Origin&) const = default;
};

/// A volume that was closed from `from` to `until` [s], or to the end of the run.
struct ClosedAir {
  std::string name;
  std::vector<GroundPoint> polygon;
  double from = 0.0;
  std::optional<double> until;
  bool operator==(const ClosedAir&) const = default;
};

struct Place {
  std::string name;
  Position position;
  bool operator==(const Place&) const = default;
};

struct UavInfo {
  std::string name;
  std::string model;
  int degree = 1;  ///< of autonomy, at the start
  bool operator==(const UavInfo&) const = default;
};

struct RunInfo {
  std::string scenario;
  std::string epoch;  ///< ISO 8601, UTC
  RuntimeKind runtime = RuntimeKind::kVirtual;
  double rate = 0.0;  ///< mission seconds per wall second asked for; 0: as fast as possible
  std::uint64_t seed = 0;
  double wall_seconds = 0.0;
  std::string version;  ///< of Skein
  std::optional<Origin> origin;
  std::optional<Extents> extents;
  std::optional<TerrainGrid> terrain;
  std::vector<Zone> zones;
  std::vector<ClosedAir> air;
  std::vector<Place> places;
  std::vector<UavInfo> uavs;  ///< their order is the order of the report's rows and colours
  bool operator==(const RunInfo&) const = default;
};

/// One JSON document, indented, ended by a newline; run_info_from_json gives the same value back
/// (numbers that are not finite become 0).
std::string to_json(const RunInfo& info);

/// Every error at once; unknown keys and absent optional keys are no error. `name` is the file's
/// name for the diagnostics.
Result<RunInfo, Diagnostics> run_info_from_json(std::string_view text, std::string_view name);

}  // namespace skein::report
