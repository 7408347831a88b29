// SPDX-License-Identifier: Apache-2.0
// What is left of events that have expired behind one that still waits: their places.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

namespace skein::blackboard {

/// So many places one tombstone keeps at most.
inline constexpr std::uint64_t kMostPlaces = 1U << 20U;

/// When a tombstone expires [ns], long ago, which says how many places it keeps: its own and those
/// right before it. Precondition: 1 <= places <= kMostPlaces.
constexpr std::int64_t tombstone_of(std::uint64_t places) {
  return std::numeric_limits<std::int64_t>::min() + static_cast<std::int64_t>(places - 1);
}

/// How many places an event that expires then [ns] keeps; absent: it is no tombstone.
constexpr std::optional<std::uint64_t> places_kept(std::int64_t expires) {
  if (expires > tombstone_of(kMostPlaces)) return std::nullopt;
  return static_cast<std::uint64_t>(expires - tombstone_of(1)) + 1;
}

}  // namespace skein::blackboard
