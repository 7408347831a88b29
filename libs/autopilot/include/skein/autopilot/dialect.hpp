// SPDX-License-Identifier: Apache-2.0
// In what the autopilots differ that speak MAVLink.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace skein::autopilot {

enum class Dialect : std::uint8_t { kPx4, kArdupilot };

/// "px4", "ardupilot".
std::string_view to_text(Dialect dialect);
std::optional<Dialect> dialect_from(std::string_view text);
/// By MAV_AUTOPILOT of a heartbeat.
std::optional<Dialect> dialect_of(std::uint8_t autopilot);

/// `custom_mode` of a heartbeat: ArduCopter's number, or PX4's main mode in bits 16 to 23 and its
/// sub mode in bits 24 to 31.
using CustomMode = std::uint32_t;

/// In which the vehicle flies to places it is told and stays there: GUIDED, Hold.
CustomMode guided_mode(Dialect dialect);
CustomMode land_mode(Dialect dialect);
/// That a takeoff goes through by itself, beside the guided one; absent: none.
std::optional<CustomMode> takeoff_mode(Dialect dialect);
/// As its people call it: "GUIDED", "Position"; "mode 42" when we do not know it.
std::string name_of(Dialect dialect, CustomMode mode);
/// Whether the flag "manual input" says that a pilot's sticks count. ArduPilot sets it in all
/// modes.
bool tells_manual_input(Dialect dialect);

}  // namespace skein::autopilot
