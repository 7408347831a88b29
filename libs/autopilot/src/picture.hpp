// SPDX-License-Identifier: Apache-2.0
// What the autopilot says of its vehicle, in the local frame.
#pragma once

#include <optional>
#include <string>

#include "skein/autopilot/bridge.hpp"
#include "skein/world/vehicle_state.hpp"

namespace skein::autopilot {

/// A place as commands name it.
struct Place {
  std::int32_t latitude = 0;   ///< [1e-7 degrees]
  std::int32_t longitude = 0;  ///< [1e-7 degrees]
  double height = 0;           ///< above mean sea level [m]
};

/// Heights: autopilots count from mean sea level, the scenario from the ellipsoid, and how far
/// these are apart is nobody's to know. So a disarmed vehicle on the ground is taken to stand on
/// the scenario's terrain, and heights are counted from there; one that is first heard in the air
/// is as high above the terrain at its start as it says to be above its home. None is under the
/// terrain.
class Picture {
 public:
  explicit Picture(const BridgeConfig& config);

  void hear(const mavlink::Heartbeat& heartbeat, Duration now);
  void hear(const mavlink::GlobalPositionInt& position, Duration now);
  void hear(const mavlink::Attitude& attitude);
  void hear(const mavlink::ExtendedSysState& state);
  /// [0, 100] %; negative: not told.
  void hear_battery(int percent);

  /// Heartbeats come. Lost after five seconds.
  bool is_linked(Duration now) const;
  /// And so do positions.
  bool is_located(Duration now) const;
  bool is_armed() const;
  bool has_manual_input() const;
  bool is_critical() const;
  CustomMode mode() const { return heartbeat_.custom_mode; }
  Dialect dialect() const { return dialect_; }
  const world::VehicleState& state() const { return state_; }

  Place place_of(const world::Vector3& local) const;
  /// Of the place where it was armed, above mean sea level [m].
  double home_height() const { return home_height_; }

 private:
  void settle();

  const BridgeConfig& config_;
  geodesy::GeodeticFrame frame_;
  Dialect dialect_;
  mavlink::Heartbeat heartbeat_{};
  std::optional<Duration> heartbeat_at_, position_at_;
  std::optional<mavlink::GlobalPositionInt> position_;
  std::uint8_t landed_state_ = 0;
  double home_height_ = 0;
  std::optional<double> rise_;  ///< from mean sea level to the frame's altitude [m]
  world::VehicleState state_;
};

}  // namespace skein::autopilot
