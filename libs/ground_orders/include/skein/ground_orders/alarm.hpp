// SPDX-License-Identifier: Apache-2.0
// What the ground station believes about one possible fire.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "skein/foundation/id.hpp"
#include "skein/foundation/time.hpp"
#include "skein/world/geometry.hpp"

namespace skein::ground_station {

/// Numbered from 1 in the order raised.
using AlarmId = Id<struct AlarmIdTag>;

/// raised → confirmed or infirmed; infirmed → raised when a device that had no part in raising it
/// sees the fire; confirmed is for good.
enum class AlarmState { kRaised, kConfirmed, kInfirmed };

/// "raised", "confirmed", "infirmed".
std::string_view to_text(AlarmState state);

/// The fire model of one alarm. A value; who keeps one keeps a snapshot.
/// Source: T VI.1.1 (perception processing system), T VI.1.2 (confirmation and monitoring).
struct Alarm {
  /// Sectors of the view count: sector k holds bearings [k, k + 1) × 30°, counter-clockwise from
  /// east.
  static constexpr int kSectors = 12;

  AlarmId id;
  AlarmState state = AlarmState::kRaised;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU, on the ground
  double position_sigma = 0;  ///< [m] standard deviation of the position, one axis
  double radius = 0;  ///< [m] of the disc whose scatter the detections show beyond their own errors
  double belief = 0;  ///< probability in (0, 1) that it is a fire
  MissionTime first_seen;
  MissionTime last_seen;
  std::uint32_t views = 0;  ///< independent looks that saw it
  /// The same by bearing from the alarm to the viewer: how many sides it was seen from.
  std::array<std::uint32_t, kSectors> views_by_bearing{};
  bool operator==(const Alarm&) const = default;
};

/// The alarm changed state (also: was raised). What the journal and the Alarm slot carry.
struct AlarmEvent {
  Alarm alarm;
};

/// Same state, better estimate: moved by more than PpsConfig::refine_distance since last told.
struct AlarmRefined {
  Alarm alarm;
};

}  // namespace skein::ground_station
