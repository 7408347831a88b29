// SPDX-License-Identifier: Apache-2.0
// The messages against what fastddsgen makes of idl/ros2.idl: the same fields from our bytes, the
// same bytes back, the same names of types.
#include <gtest/gtest.h>
#include <ros2_fastdds/ros2PubSubTypes.h>

#include <cmath>

#include "skein/ros2/cdr.hpp"
#include "testing/random_message.hpp"

namespace skein::ros2 {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;
using testing::random_message;

void same(const Time& ours, builtin_interfaces::msg::dds_::Time_& theirs) {
  EXPECT_EQ(ours.sec, theirs.sec());
  EXPECT_EQ(ours.nanosec, theirs.nanosec());
}
void same(const Header& ours, std_msgs::msg::dds_::Header_& theirs) {
  same(ours.stamp, theirs.stamp());
  EXPECT_EQ(ours.frame_id, theirs.frame_id());
}
void same(const String& ours, std_msgs::msg::dds_::String_& theirs) {
  EXPECT_EQ(ours.data, theirs.data());
}
void same(const NavSatFix& ours, sensor_msgs::msg::dds_::NavSatFix_& theirs) {
  same(ours.header, theirs.header());
  EXPECT_EQ(ours.status.status, theirs.status().status());
  EXPECT_EQ(ours.status.service, theirs.status().service());
  EXPECT_EQ(ours.latitude, theirs.latitude());
  EXPECT_EQ(ours.longitude, theirs.longitude());
  EXPECT_EQ(ours.altitude, theirs.altitude());
  EXPECT_EQ(ours.position_covariance, theirs.position_covariance());
  EXPECT_EQ(ours.position_covariance_type, theirs.position_covariance_type());
}
template <class Theirs>
void same(const Vector3& ours, Theirs& theirs) {
  EXPECT_EQ(ours.x, theirs.x());
  EXPECT_EQ(ours.y, theirs.y());
  EXPECT_EQ(ours.z, theirs.z());
}
void same(const Odometry& ours, nav_msgs::msg::dds_::Odometry_& theirs) {
  same(ours.header, theirs.header());
  EXPECT_EQ(ours.child_frame_id, theirs.child_frame_id());
  same(ours.pose.pose.position, theirs.pose().pose().position());
  same(ours.twist.twist.linear, theirs.twist().twist().linear());
  same(ours.twist.twist.angular, theirs.twist().twist().angular());
  const auto& turn = theirs.pose().pose().orientation();
  EXPECT_EQ(ours.pose.pose.orientation, (Quaternion{turn.x(), turn.y(), turn.z(), turn.w()}));
  EXPECT_EQ(ours.pose.covariance, theirs.pose().covariance());
  EXPECT_EQ(ours.twist.covariance, theirs.twist().covariance());
}
void same(const BatteryState& ours, sensor_msgs::msg::dds_::BatteryState_& theirs) {
  same(ours.header, theirs.header());
  EXPECT_EQ(ours.voltage, theirs.voltage());
  EXPECT_EQ(ours.temperature, theirs.temperature());
  EXPECT_EQ(ours.current, theirs.current());
  EXPECT_EQ(ours.charge, theirs.charge());
  EXPECT_EQ(ours.capacity, theirs.capacity());
  EXPECT_EQ(ours.design_capacity, theirs.design_capacity());
  EXPECT_EQ(ours.percentage, theirs.percentage());
  EXPECT_EQ(ours.power_supply_status, theirs.power_supply_status());
  EXPECT_EQ(ours.power_supply_health, theirs.power_supply_health());
  EXPECT_EQ(ours.power_supply_technology, theirs.power_supply_technology());
  EXPECT_EQ(ours.present, theirs.present());
  EXPECT_EQ(ours.cell_voltage, theirs.cell_voltage());
  EXPECT_EQ(ours.cell_temperature, theirs.cell_temperature());
  EXPECT_EQ(ours.location, theirs.location());
  EXPECT_EQ(ours.serial_number, theirs.serial_number());
}
void same(const DiagnosticArray& ours, diagnostic_msgs::msg::dds_::DiagnosticArray_& theirs) {
  same(ours.header, theirs.header());
  ASSERT_EQ(ours.status.size(), theirs.status().size());
  for (std::size_t i = 0; i < ours.status.size(); ++i) {
    const DiagnosticStatus& one = ours.status[i];
    auto& other = theirs.status()[i];
    EXPECT_EQ(one.level, other.level());
    EXPECT_EQ(one.name, other.name());
    EXPECT_EQ(one.message, other.message());
    EXPECT_EQ(one.hardware_id, other.hardware_id());
    ASSERT_EQ(one.values.size(), other.values().size());
    for (std::size_t k = 0; k < one.values.size(); ++k) {
      EXPECT_EQ(one.values[k].key, other.values()[k].key());
      EXPECT_EQ(one.values[k].value, other.values()[k].value());
    }
  }
}

template <class Type, class M>
void expect_conformance() {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const M message = random_message<M>(random);
    const Bytes bytes = to_cdr(message);
    SerializedPayload_t payload(static_cast<std::uint32_t>(bytes.size()));
    payload.length = payload.max_size;
    std::copy(bytes.begin(), bytes.end(), payload.data);
    typename Type::type theirs;
    Type type;

    ASSERT_TRUE(type.deserialize(&payload, &theirs));
    SerializedPayload_t back(type.getSerializedSizeProvider(&theirs)());
    ASSERT_TRUE(type.serialize(&theirs, &back));

    same(message, theirs);
    ASSERT_EQ(bytes, Bytes(back.data, back.data + back.length));
    EXPECT_EQ(type.getName(), type_name<M>());
    EXPECT_FALSE(type.m_isGetKeyDefined);
  }
}

TEST(RosIdl, String) { expect_conformance<std_msgs::msg::dds_::String_PubSubType, String>(); }
TEST(RosIdl, NavSatFix) {
  expect_conformance<sensor_msgs::msg::dds_::NavSatFix_PubSubType, NavSatFix>();
}
TEST(RosIdl, Odometry) { expect_conformance<nav_msgs::msg::dds_::Odometry_PubSubType, Odometry>(); }
TEST(RosIdl, BatteryState) {
  expect_conformance<sensor_msgs::msg::dds_::BatteryState_PubSubType, BatteryState>();
}
TEST(RosIdl, DiagnosticArray) {
  expect_conformance<diagnostic_msgs::msg::dds_::DiagnosticArray_PubSubType, DiagnosticArray>();
}

}  // namespace
}  // namespace skein::ros2
