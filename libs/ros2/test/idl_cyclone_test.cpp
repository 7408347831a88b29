// SPDX-License-Identifier: Apache-2.0
// The messages against what idlc makes of idl/ros2.idl: it reads our bytes and writes the same
// ones, and says the same names of types. Which field is which is compared by the test against
// fastddsgen.
#include <dds/ddsi/ddsi_cdrstream.h>
#include <gtest/gtest.h>
#include <ros2_cyclone/ros2.h>

#include <cstring>

#include "skein/ros2/cdr.hpp"
#include "testing/random_message.hpp"

namespace skein::ros2 {
namespace {

constexpr std::uint32_t kXcdr1 = 1;
constexpr std::size_t kEncapsulation = 4;

template <class Image, class M>
void expect_conformance(const dds_topic_descriptor_t& descriptor) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    Bytes bytes = to_cdr(testing::random_message<M>(random));
    const auto size = static_cast<std::uint32_t>(bytes.size() - kEncapsulation);
    Image image{};
    dds_istream_t in;
    dds_istream_init(&in, size, bytes.data() + kEncapsulation, kXcdr1);
    dds_ostream_t out;
    dds_ostream_init(&out, 0, kXcdr1);

    dds_stream_read(&in, reinterpret_cast<char*>(&image), descriptor.m_ops);
    dds_stream_write(&out, reinterpret_cast<const char*>(&image), descriptor.m_ops);

    ASSERT_EQ(out.m_index, size);
    EXPECT_EQ(std::memcmp(out.m_buffer, bytes.data() + kEncapsulation, size), 0);
    dds_ostream_fini(&out);
    dds_stream_free_sample(&image, descriptor.m_ops);
  }
  EXPECT_EQ(descriptor.m_typename, type_name<M>());
  EXPECT_EQ(descriptor.m_nkeys, 0U);
}

TEST(RosIdl, String) {
  expect_conformance<std_msgs_msg_dds__String_, String>(std_msgs_msg_dds__String__desc);
}
TEST(RosIdl, NavSatFix) {
  expect_conformance<sensor_msgs_msg_dds__NavSatFix_, NavSatFix>(
      sensor_msgs_msg_dds__NavSatFix__desc);
}
TEST(RosIdl, Odometry) {
  expect_conformance<nav_msgs_msg_dds__Odometry_, Odometry>(nav_msgs_msg_dds__Odometry__desc);
}
TEST(RosIdl, BatteryState) {
  expect_conformance<sensor_msgs_msg_dds__BatteryState_, BatteryState>(
      sensor_msgs_msg_dds__BatteryState__desc);
}
TEST(RosIdl, DiagnosticArray) {
  expect_conformance<diagnostic_msgs_msg_dds__DiagnosticArray_, DiagnosticArray>(
      diagnostic_msgs_msg_dds__DiagnosticArray__desc);
}

}  // namespace
}  // namespace skein::ros2
