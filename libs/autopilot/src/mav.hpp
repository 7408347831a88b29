// SPDX-License-Identifier: Apache-2.0
// Numbers of MAVLink's enumerations that the bridge uses. Source:
// mavlink.io/en/messages/common.html.
#pragma once

#include <cstdint>

namespace skein::autopilot::mav {

// MAV_CMD
inline constexpr std::uint16_t kNavTakeoff = 22;
inline constexpr std::uint16_t kDoSetMode = 176;
inline constexpr std::uint16_t kDoChangeSpeed = 178;
inline constexpr std::uint16_t kDoReposition = 192;
inline constexpr std::uint16_t kDoDigicamControl = 203;
inline constexpr std::uint16_t kComponentArmDisarm = 400;
inline constexpr std::uint16_t kSetMessageInterval = 511;
inline constexpr std::uint16_t kImageStartCapture = 2000;

// MAV_RESULT
inline constexpr std::uint8_t kAccepted = 0;
inline constexpr std::uint8_t kTemporarilyRejected = 1;
inline constexpr std::uint8_t kInProgress = 5;

// MAV_TYPE, MAV_AUTOPILOT, MAV_COMP_ID
inline constexpr std::uint8_t kTypeGroundStation = 6;
inline constexpr std::uint8_t kTypeOnboardController = 18;
inline constexpr std::uint8_t kArdupilot = 3;
inline constexpr std::uint8_t kNoAutopilot = 8;
inline constexpr std::uint8_t kPx4 = 12;
inline constexpr std::uint8_t kAutopilotComponent = 1;

// MAV_MODE_FLAG, MAV_STATE, MAV_LANDED_STATE, MAV_FRAME, MAV_DO_REPOSITION_FLAGS, MAV_SEVERITY
inline constexpr std::uint8_t kArmedFlag = 0x80;
inline constexpr std::uint8_t kManualInputFlag = 0x40;
inline constexpr std::uint8_t kCustomModeFlag = 0x01;
inline constexpr std::uint8_t kStateActive = 4;
inline constexpr std::uint8_t kStateCritical = 5;
inline constexpr std::uint8_t kLandedOnGround = 1;
inline constexpr std::uint8_t kLandedUnknown = 0;
inline constexpr std::uint8_t kFrameGlobal = 0;
inline constexpr float kChangeMode = 1;
inline constexpr std::uint8_t kSeverityWarning = 4;

}  // namespace skein::autopilot::mav
