// SPDX-License-Identifier: Apache-2.0
// Captions of the services' pictures.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "skein/cartography/map.hpp"
#include "skein/refiners/refinement.hpp"

namespace skein::cartography {

inline std::string seconds(Duration duration) {
  if (duration == Duration::max()) return "never";
  const double s = duration.to_seconds();
  if (s < 120) return fmt::format("{:.0f} s", s);
  const auto whole = static_cast<long long>(std::llround(s));
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02} h", whole / 3600, whole / 60 % 60, whole % 60);
}

inline std::string duration_words(const refiners::DurationInterval& duration) {
  return seconds(duration.expected) + " (" + seconds(duration.least) + " to " +
         seconds(duration.most) + ")";
}

/// The line under the title if there is no solution.
inline std::string refusal_words(const refiners::Refusal& refusal) {
  return "no solution (" + std::string(to_text(refusal.kind)) +
         (refusal.field.empty() ? "" : ", " + refusal.field) + "): " + refusal.why;
}

/// Draws closed volumes and named zones, which every picture shows.
inline void draw_surroundings(Map& map, const world::World& world) {
  for (const world::Zone& zone : world.zones)
    map.area(zone.polygon, {.colour = "#606060", .dashed = true, .label = zone.name});
  map.closed(world.volumes);
}

inline constexpr const char* kStartColour = "#1b7837";
inline constexpr const char* kEndColour = "#762a83";

}  // namespace skein::cartography
