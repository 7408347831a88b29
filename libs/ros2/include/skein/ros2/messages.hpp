// SPDX-License-Identifier: Apache-2.0
// The messages of ROS 2 that Skein speaks, field by field as its packages define them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace skein::ros2 {

/// The fields of a message in the order of its definition, which is that of the wire.
#define SKEIN_ROS2_FIELDS(...)                          \
  auto fields() { return std::tie(__VA_ARGS__); }       \
  auto fields() const { return std::tie(__VA_ARGS__); } \
  bool operator==(const auto& other) const { return fields() == other.fields(); }

/// For CdrWriter: `visitor(name, field)` for each field; messages need no names.
template <class Visitor, class M>
requires requires(const M& message) { message.fields(); }
void visit_fields(Visitor&& visitor, const M& message) {
  std::apply([&](const auto&... field) { (visitor("", field), ...); }, message.fields());
}

/// builtin_interfaces/Time: since 1970 here.
struct Time {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  SKEIN_ROS2_FIELDS(sec, nanosec)
};

/// std_msgs/Header
struct Header {
  Time stamp;
  std::string frame_id;
  SKEIN_ROS2_FIELDS(stamp, frame_id)
};

/// std_msgs/String
struct String {
  std::string data;
  SKEIN_ROS2_FIELDS(data)
};

/// sensor_msgs/NavSatStatus
struct NavSatStatus {
  static constexpr std::int8_t kFix = 0;
  static constexpr std::uint16_t kGps = 1;
  std::int8_t status = kFix;
  std::uint16_t service = kGps;
  SKEIN_ROS2_FIELDS(status, service)
};

/// sensor_msgs/NavSatFix
struct NavSatFix {
  static constexpr std::uint8_t kCovarianceUnknown = 0;
  Header header;
  NavSatStatus status;
  double latitude = 0;   ///< [°]
  double longitude = 0;  ///< [°]
  double altitude = 0;   ///< [m] above the WGS 84 ellipsoid
  std::array<double, 9> position_covariance{};
  std::uint8_t position_covariance_type = kCovarianceUnknown;
  SKEIN_ROS2_FIELDS(header, status, latitude, longitude, altitude, position_covariance,
                    position_covariance_type)
};

/// geometry_msgs/Point and geometry_msgs/Vector3
struct Vector3 {
  double x = 0, y = 0, z = 0;
  SKEIN_ROS2_FIELDS(x, y, z)
};

/// geometry_msgs/Quaternion
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
  SKEIN_ROS2_FIELDS(x, y, z, w)
};

/// geometry_msgs/Pose
struct Pose {
  Vector3 position;
  Quaternion orientation;
  SKEIN_ROS2_FIELDS(position, orientation)
};

/// geometry_msgs/PoseWithCovariance
struct PoseWithCovariance {
  Pose pose;
  std::array<double, 36> covariance{};
  SKEIN_ROS2_FIELDS(pose, covariance)
};

/// geometry_msgs/Twist
struct Twist {
  Vector3 linear;   ///< [m/s]
  Vector3 angular;  ///< [rad/s]
  SKEIN_ROS2_FIELDS(linear, angular)
};

/// geometry_msgs/TwistWithCovariance
struct TwistWithCovariance {
  Twist twist;
  std::array<double, 36> covariance{};
  SKEIN_ROS2_FIELDS(twist, covariance)
};

/// nav_msgs/Odometry: the pose in the header's frame, the twist in the child's.
struct Odometry {
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;
  SKEIN_ROS2_FIELDS(header, child_frame_id, pose, twist)
};

/// sensor_msgs/BatteryState; what is not known is not a number.
struct BatteryState {
  static constexpr std::uint8_t kStatusUnknown = 0, kDischarging = 2;
  Header header;
  float voltage = 0, temperature = 0, current = 0, charge = 0, capacity = 0, design_capacity = 0;
  float percentage = 0;  ///< in [0, 1]
  std::uint8_t power_supply_status = kStatusUnknown;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = true;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;
  SKEIN_ROS2_FIELDS(header, voltage, temperature, current, charge, capacity, design_capacity,
                    percentage, power_supply_status, power_supply_health, power_supply_technology,
                    present, cell_voltage, cell_temperature, location, serial_number)
};

/// diagnostic_msgs/KeyValue
struct KeyValue {
  std::string key;
  std::string value;
  SKEIN_ROS2_FIELDS(key, value)
};

/// diagnostic_msgs/DiagnosticStatus
struct DiagnosticStatus {
  static constexpr std::uint8_t kOk = 0, kWarn = 1, kError = 2, kStale = 3;
  std::uint8_t level = kOk;
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<KeyValue> values;
  SKEIN_ROS2_FIELDS(level, name, message, hardware_id, values)
};

/// diagnostic_msgs/DiagnosticArray
struct DiagnosticArray {
  Header header;
  std::vector<DiagnosticStatus> status;
  SKEIN_ROS2_FIELDS(header, status)
};

/// What has a topic of its own.
using Message = std::variant<String, NavSatFix, Odometry, BatteryState, DiagnosticArray>;

/// As the middleware of ROS 2 mangles them: "sensor_msgs::msg::dds_::NavSatFix_". Source: ROS 2
/// design, "Topic and Service name mapping to DDS".
template <class M>
constexpr std::string_view type_name();
template <>
constexpr std::string_view type_name<String>() {
  return "std_msgs::msg::dds_::String_";
}
template <>
constexpr std::string_view type_name<NavSatFix>() {
  return "sensor_msgs::msg::dds_::NavSatFix_";
}
template <>
constexpr std::string_view type_name<Odometry>() {
  return "nav_msgs::msg::dds_::Odometry_";
}
template <>
constexpr std::string_view type_name<BatteryState>() {
  return "sensor_msgs::msg::dds_::BatteryState_";
}
template <>
constexpr std::string_view type_name<DiagnosticArray>() {
  return "diagnostic_msgs::msg::dds_::DiagnosticArray_";
}

}  // namespace skein::ros2
