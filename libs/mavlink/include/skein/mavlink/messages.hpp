// SPDX-License-Identifier: Apache-2.0
// The messages that we speak, as MAVLink defines them: names, types and units are those of the
// published definitions (mavlink.io/en/messages/common.html), each listed once, in the order of the
// wire. That a list is right shows in its CRC_EXTRA (test/messages_test.cpp) and by another's code
// (tests/mavlink).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <variant>

#include "skein/mavlink/fields.hpp"

namespace skein::mavlink {

#define SKEIN_MAVLINK_FIELD(name) field(#name, &Self::name)
#define SKEIN_MAVLINK_EXTENSION(name) extension(#name, &Self::name)

/// Says who is there and in which mode; once a second.
struct Heartbeat {
  using Self = Heartbeat;
  static constexpr std::uint32_t kId = 0;
  static constexpr std::string_view kName = "HEARTBEAT";
  std::uint32_t custom_mode = 0;   ///< an autopilot's own modes
  std::uint8_t type = 0;           ///< MAV_TYPE
  std::uint8_t autopilot = 0;      ///< MAV_AUTOPILOT
  std::uint8_t base_mode = 0;      ///< bits of MAV_MODE_FLAG
  std::uint8_t system_status = 0;  ///< MAV_STATE
  std::uint8_t mavlink_version = 3;
  bool operator==(const Heartbeat&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(custom_mode), SKEIN_MAVLINK_FIELD(type),
                      SKEIN_MAVLINK_FIELD(autopilot), SKEIN_MAVLINK_FIELD(base_mode),
                      SKEIN_MAVLINK_FIELD(system_status), SKEIN_MAVLINK_FIELD(mavlink_version));
  }
};

/// The system as a whole; of it we read the battery.
struct SysStatus {
  using Self = SysStatus;
  static constexpr std::uint32_t kId = 1;
  static constexpr std::string_view kName = "SYS_STATUS";
  std::uint32_t onboard_control_sensors_present = 0;
  std::uint32_t onboard_control_sensors_enabled = 0;
  std::uint32_t onboard_control_sensors_health = 0;
  std::uint16_t load = 0;                  ///< [per mille]
  std::uint16_t voltage_battery = 0xffff;  ///< [mV]; 65535: not told
  std::int16_t current_battery = -1;       ///< [10 mA]; -1: not told
  std::uint16_t drop_rate_comm = 0;
  std::uint16_t errors_comm = 0;
  std::uint16_t errors_count1 = 0;
  std::uint16_t errors_count2 = 0;
  std::uint16_t errors_count3 = 0;
  std::uint16_t errors_count4 = 0;
  std::int8_t battery_remaining = -1;  ///< [%]; -1: not told
  std::uint32_t onboard_control_sensors_present_extended = 0;
  std::uint32_t onboard_control_sensors_enabled_extended = 0;
  std::uint32_t onboard_control_sensors_health_extended = 0;
  bool operator==(const SysStatus&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(onboard_control_sensors_present),
                      SKEIN_MAVLINK_FIELD(onboard_control_sensors_enabled),
                      SKEIN_MAVLINK_FIELD(onboard_control_sensors_health),
                      SKEIN_MAVLINK_FIELD(load), SKEIN_MAVLINK_FIELD(voltage_battery),
                      SKEIN_MAVLINK_FIELD(current_battery), SKEIN_MAVLINK_FIELD(drop_rate_comm),
                      SKEIN_MAVLINK_FIELD(errors_comm), SKEIN_MAVLINK_FIELD(errors_count1),
                      SKEIN_MAVLINK_FIELD(errors_count2), SKEIN_MAVLINK_FIELD(errors_count3),
                      SKEIN_MAVLINK_FIELD(errors_count4), SKEIN_MAVLINK_FIELD(battery_remaining),
                      SKEIN_MAVLINK_EXTENSION(onboard_control_sensors_present_extended),
                      SKEIN_MAVLINK_EXTENSION(onboard_control_sensors_enabled_extended),
                      SKEIN_MAVLINK_EXTENSION(onboard_control_sensors_health_extended));
  }
};

/// Angles of the body to north, east, down.
struct Attitude {
  using Self = Attitude;
  static constexpr std::uint32_t kId = 30;
  static constexpr std::string_view kName = "ATTITUDE";
  std::uint32_t time_boot_ms = 0;
  float roll = 0;        ///< [rad]
  float pitch = 0;       ///< [rad], up positive
  float yaw = 0;         ///< [rad], clockwise from north
  float rollspeed = 0;   ///< [rad/s]
  float pitchspeed = 0;  ///< [rad/s]
  float yawspeed = 0;    ///< [rad/s]
  bool operator==(const Attitude&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(time_boot_ms), SKEIN_MAVLINK_FIELD(roll),
                      SKEIN_MAVLINK_FIELD(pitch), SKEIN_MAVLINK_FIELD(yaw),
                      SKEIN_MAVLINK_FIELD(rollspeed), SKEIN_MAVLINK_FIELD(pitchspeed),
                      SKEIN_MAVLINK_FIELD(yawspeed));
  }
};

/// Where the vehicle is, as it filters it.
struct GlobalPositionInt {
  using Self = GlobalPositionInt;
  static constexpr std::uint32_t kId = 33;
  static constexpr std::string_view kName = "GLOBAL_POSITION_INT";
  std::uint32_t time_boot_ms = 0;
  std::int32_t lat = 0;           ///< [1e-7 degrees]
  std::int32_t lon = 0;           ///< [1e-7 degrees]
  std::int32_t alt = 0;           ///< above mean sea level [mm]
  std::int32_t relative_alt = 0;  ///< above home [mm]
  std::int16_t vx = 0;            ///< north [cm/s]
  std::int16_t vy = 0;            ///< east [cm/s]
  std::int16_t vz = 0;            ///< down [cm/s]
  std::uint16_t hdg = 0xffff;     ///< clockwise from north [0.01 degrees]; 65535: not told
  bool operator==(const GlobalPositionInt&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(time_boot_ms), SKEIN_MAVLINK_FIELD(lat),
                      SKEIN_MAVLINK_FIELD(lon), SKEIN_MAVLINK_FIELD(alt),
                      SKEIN_MAVLINK_FIELD(relative_alt), SKEIN_MAVLINK_FIELD(vx),
                      SKEIN_MAVLINK_FIELD(vy), SKEIN_MAVLINK_FIELD(vz), SKEIN_MAVLINK_FIELD(hdg));
  }
};

/// A command with a place.
struct CommandInt {
  using Self = CommandInt;
  static constexpr std::uint32_t kId = 75;
  static constexpr std::string_view kName = "COMMAND_INT";
  float param1 = 0;
  float param2 = 0;
  float param3 = 0;
  float param4 = 0;
  std::int32_t x = 0;         ///< latitude [1e-7 degrees]
  std::int32_t y = 0;         ///< longitude [1e-7 degrees]
  float z = 0;                ///< height [m], of what `frame` says
  std::uint16_t command = 0;  ///< MAV_CMD
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::uint8_t frame = 0;  ///< MAV_FRAME
  std::uint8_t current = 0;
  std::uint8_t autocontinue = 0;
  bool operator==(const CommandInt&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(param1), SKEIN_MAVLINK_FIELD(param2),
                      SKEIN_MAVLINK_FIELD(param3), SKEIN_MAVLINK_FIELD(param4),
                      SKEIN_MAVLINK_FIELD(x), SKEIN_MAVLINK_FIELD(y), SKEIN_MAVLINK_FIELD(z),
                      SKEIN_MAVLINK_FIELD(command), SKEIN_MAVLINK_FIELD(target_system),
                      SKEIN_MAVLINK_FIELD(target_component), SKEIN_MAVLINK_FIELD(frame),
                      SKEIN_MAVLINK_FIELD(current), SKEIN_MAVLINK_FIELD(autocontinue));
  }
};

/// A command.
struct CommandLong {
  using Self = CommandLong;
  static constexpr std::uint32_t kId = 76;
  static constexpr std::string_view kName = "COMMAND_LONG";
  float param1 = 0;
  float param2 = 0;
  float param3 = 0;
  float param4 = 0;
  float param5 = 0;
  float param6 = 0;
  float param7 = 0;
  std::uint16_t command = 0;  ///< MAV_CMD
  std::uint8_t target_system = 0;
  std::uint8_t target_component = 0;
  std::uint8_t confirmation = 0;  ///< how often it was sent before
  bool operator==(const CommandLong&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(param1), SKEIN_MAVLINK_FIELD(param2),
                      SKEIN_MAVLINK_FIELD(param3), SKEIN_MAVLINK_FIELD(param4),
                      SKEIN_MAVLINK_FIELD(param5), SKEIN_MAVLINK_FIELD(param6),
                      SKEIN_MAVLINK_FIELD(param7), SKEIN_MAVLINK_FIELD(command),
                      SKEIN_MAVLINK_FIELD(target_system), SKEIN_MAVLINK_FIELD(target_component),
                      SKEIN_MAVLINK_FIELD(confirmation));
  }
};

/// The answer to a command; it has no number.
struct CommandAck {
  using Self = CommandAck;
  static constexpr std::uint32_t kId = 77;
  static constexpr std::string_view kName = "COMMAND_ACK";
  std::uint16_t command = 0;  ///< MAV_CMD
  std::uint8_t result = 0;    ///< MAV_RESULT
  std::uint8_t progress = 0;
  std::int32_t result_param2 = 0;
  std::uint8_t target_system = 0;     ///< often absent
  std::uint8_t target_component = 0;  ///< often absent
  bool operator==(const CommandAck&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(command), SKEIN_MAVLINK_FIELD(result),
                      SKEIN_MAVLINK_EXTENSION(progress), SKEIN_MAVLINK_EXTENSION(result_param2),
                      SKEIN_MAVLINK_EXTENSION(target_system),
                      SKEIN_MAVLINK_EXTENSION(target_component));
  }
};

/// One battery.
struct BatteryStatus {
  using Self = BatteryStatus;
  static constexpr std::uint32_t kId = 147;
  static constexpr std::string_view kName = "BATTERY_STATUS";
  std::int32_t current_consumed = -1;        ///< [mAh]; -1: not told
  std::int32_t energy_consumed = -1;         ///< [hJ]; -1: not told
  std::int16_t temperature = 0x7fff;         ///< [0.01 degrees C]
  std::array<std::uint16_t, 10> voltages{};  ///< of its cells [mV]; 65535: no such cell
  std::int16_t current_battery = -1;         ///< [10 mA]; -1: not told
  std::uint8_t id = 0;                       ///< 0: the first
  std::uint8_t battery_function = 0;
  std::uint8_t type = 0;
  std::int8_t battery_remaining = -1;  ///< [%]; -1: not told
  std::int32_t time_remaining = 0;     ///< [s]
  std::uint8_t charge_state = 0;
  std::array<std::uint16_t, 4> voltages_ext{};
  std::uint8_t mode = 0;
  std::uint32_t fault_bitmask = 0;
  bool operator==(const BatteryStatus&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(current_consumed), SKEIN_MAVLINK_FIELD(energy_consumed),
                      SKEIN_MAVLINK_FIELD(temperature), SKEIN_MAVLINK_FIELD(voltages),
                      SKEIN_MAVLINK_FIELD(current_battery), SKEIN_MAVLINK_FIELD(id),
                      SKEIN_MAVLINK_FIELD(battery_function), SKEIN_MAVLINK_FIELD(type),
                      SKEIN_MAVLINK_FIELD(battery_remaining),
                      SKEIN_MAVLINK_EXTENSION(time_remaining),
                      SKEIN_MAVLINK_EXTENSION(charge_state), SKEIN_MAVLINK_EXTENSION(voltages_ext),
                      SKEIN_MAVLINK_EXTENSION(mode), SKEIN_MAVLINK_EXTENSION(fault_bitmask));
  }
};

/// Whether it is on the ground.
struct ExtendedSysState {
  using Self = ExtendedSysState;
  static constexpr std::uint32_t kId = 245;
  static constexpr std::string_view kName = "EXTENDED_SYS_STATE";
  std::uint8_t vtol_state = 0;
  std::uint8_t landed_state = 0;  ///< MAV_LANDED_STATE
  bool operator==(const ExtendedSysState&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(vtol_state), SKEIN_MAVLINK_FIELD(landed_state));
  }
};

/// Words for people.
struct StatusText {
  using Self = StatusText;
  static constexpr std::uint32_t kId = 253;
  static constexpr std::string_view kName = "STATUSTEXT";
  std::uint8_t severity = 6;    ///< as of syslog: 0 emergency to 7 debug
  std::array<char, 50> text{};  ///< filled up with zeros
  std::uint16_t id = 0;
  std::uint8_t chunk_seq = 0;
  bool operator==(const StatusText&) const = default;
  static constexpr auto fields() {
    return std::tuple(SKEIN_MAVLINK_FIELD(severity), SKEIN_MAVLINK_FIELD(text),
                      SKEIN_MAVLINK_EXTENSION(id), SKEIN_MAVLINK_EXTENSION(chunk_seq));
  }
};

#undef SKEIN_MAVLINK_FIELD
#undef SKEIN_MAVLINK_EXTENSION

using Message = std::variant<Heartbeat, SysStatus, Attitude, GlobalPositionInt, CommandInt,
                             CommandLong, CommandAck, BatteryStatus, ExtendedSysState, StatusText>;

}  // namespace skein::mavlink
