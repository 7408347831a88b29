// SPDX-License-Identifier: Apache-2.0
// Files of ground stations and maps: QGroundControl's .plan, way-point files, KML.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "skein/foundation/result.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::mission_files {

enum class Format {
  kPlan,       ///< JSON of QGroundControl
  kWaypoints,  ///< QGC WPL 110
  kKml,
};

inline constexpr std::size_t kMostBytes = std::size_t{16} << 20;
/// Items, fences, areas, ways, places, and points of a way; each.
inline constexpr std::size_t kMostParts = 10'000;

/// By the name's ending, and else by how the text begins.
std::optional<Format> format_of(const std::string& file, std::string_view text);

/// Every error at once, each with its line. Refused: other formats, versions that are not known,
/// more than kMostBytes or kMostParts, nesting deeper than 64, a text with nothing in it. What has
/// no counterpart here is no error but told in `left_out`. `file` is the name for messages.
/// Sources: docs.qgroundcontrol.com (plan file format), mavlink.io (MAV_CMD, MAV_FRAME, plain-text
/// file format), OGC 12-007r2 (KML 2.3).
Result<Contents, Diagnostics> read_text(std::string_view text, const std::string& file);
/// The same of a file.
Result<Contents, Diagnostics> read_file(const std::string& path);

}  // namespace skein::mission_files
