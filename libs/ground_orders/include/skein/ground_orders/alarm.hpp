// SPDX-License-Identifier: Apache-2.0
// An alarm: the ground station's belief in one possible fire.
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

/// raised → confirmed or infirmed; infirmed → raised when a device that had no part in raising the
/// alarm sees the fire; confirmed is final.
enum class AlarmState { kRaised, kConfirmed, kInfirmed };

/// "raised", "confirmed", "infirmed".
std::string_view to_text(AlarmState state);

/// The fire model of one alarm, as a value: a snapshot.
/// Source: T VI.1.1 (perception processing system), T VI.1.2 (confirmation and monitoring).
struct Alarm {
  /// Number of sectors in `views_by_bearing`: sector k holds bearings [k, k + 1) × 30°,
  /// counter-clockwise from east.
  static constexpr int kSectors = 12;

  AlarmId id;
  AlarmState state = AlarmState::kRaised;
  world::Vector3 position = world::Vector3::Zero();  ///< [m] ENU, on the ground
  double position_sigma = 0;  ///< [m] standard deviation of the position, one axis
  double radius = 0;  ///< [m] of the disc whose scatter the detections show beyond their own errors
  double belief = 0;  ///< probability in (0, 1) that it is a fire
  MissionTime first_seen;
  MissionTime last_seen;
  std::uint32_t views = 0;  ///< independent looks that saw the fire
  /// `views` by the bearing from the alarm to the viewer.
  std::array<std::uint32_t, kSectors> views_by_bearing{};
  bool operator==(const Alarm&) const = default;
};

/// The alarm was raised or changed its state. Written to the journal and to the Alarm slot.
struct AlarmEvent {
  Alarm alarm;
};

/// Same state, better estimate: the alarm moved by more than PpsConfig::refine_distance since it
/// was last reported (or is reported again, PpsConfig::tell_again).
struct AlarmRefined {
  Alarm alarm;
};

}  // namespace skein::ground_station
