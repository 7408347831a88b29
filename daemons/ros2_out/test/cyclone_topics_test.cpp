// SPDX-License-Identifier: Apache-2.0
// A program of Cyclone DDS that knows nothing of Skein but the IDL of the messages hears and asks.
#include <dds/dds.h>
#include <ros2_cyclone/ros2.h>

#include "testing/team.hpp"

namespace skein::ros2_out {
namespace {

/// Readers and writers with the QoS that ROS 2 has by default.
class CycloneOfOthers : public ::testing::Test {
 protected:
  CycloneOfOthers() {
    const std::string settings =
        "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface "
        "address=\"127.0.0.1\"/></Interfaces><AllowMulticast>false</AllowMulticast></General>"
        "<Discovery><ParticipantIndex>21</ParticipantIndex><Peers><Peer address=\"127.0.0.1\"/>"
        "</Peers><MaxAutoParticipantIndex>31</MaxAutoParticipantIndex></Discovery></Domain>"
        "</CycloneDDS>";
    domain_ = dds_create_domain(team.domain(), settings.c_str());
    participant_ = dds_create_participant(team.domain(), nullptr, nullptr);
  }
  ~CycloneOfOthers() override {
    dds_delete(participant_);
    dds_delete(domain_);
  }

  dds_entity_t reader(const dds_topic_descriptor_t& type, const char* topic, bool reliable) {
    dds_qos_t* const qos = qos_of(reliable);
    const dds_entity_t made = dds_create_reader(
        participant_, dds_create_topic(participant_, &type, topic, nullptr, nullptr), qos, nullptr);
    dds_delete_qos(qos);
    return made;
  }
  dds_entity_t writer(const dds_topic_descriptor_t& type, const char* topic) {
    dds_qos_t* const qos = qos_of(true);
    const dds_entity_t made = dds_create_writer(
        participant_, dds_create_topic(participant_, &type, topic, nullptr, nullptr), qos, nullptr);
    dds_delete_qos(qos);
    return made;
  }

  /// What is heard is looked at, and given back to Cyclone.
  template <class Message, class Look>
  void heard(const dds_topic_descriptor_t& type, const char* topic, bool reliable,
             const Look& look) {
    const dds_entity_t from = reader(type, topic, reliable);
    EXPECT_TRUE(team.tell_until([&] {
      void* sample = nullptr;
      dds_sample_info_t info;
      if (dds_take(from, &sample, &info, 1, 1) != 1) return false;
      const bool valid = info.valid_data;
      if (valid) look(*static_cast<const Message*>(sample));
      dds_return_loan(from, &sample, 1);
      return valid;
    })) << topic;
  }

  testing::Team team;

 private:
  static dds_qos_t* qos_of(bool reliable) {
    dds_qos_t* const qos = dds_create_qos();
    dds_qset_reliability(qos, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                         DDS_MSECS(100));
    dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
    return qos;
  }

  dds_entity_t domain_ = 0, participant_ = 0;
};

TEST_F(CycloneOfOthers, HearsWhereAUavIs) {
  heard<sensor_msgs_msg_dds__NavSatFix_>(sensor_msgs_msg_dds__NavSatFix__desc,
                                         "rt/skein/marvin/fix", false, [](const auto& fix) {
                                           EXPECT_EQ(fix.header.stamp.sec, 1'000'000);
                                           EXPECT_EQ(fix.header.stamp.nanosec, 250'000'000U);
                                           EXPECT_NEAR(fix.latitude, 40, 1e-9);
                                           EXPECT_NEAR(fix.altitude, 250, 1e-6);
                                         });
  heard<nav_msgs_msg_dds__Odometry_>(nav_msgs_msg_dds__Odometry__desc, "rt/skein/marvin/odometry",
                                     true, [](const auto& odometry) {
                                       EXPECT_STREQ(odometry.child_frame_id, "marvin");
                                       EXPECT_EQ(odometry.pose.pose.position.z, 50);
                                     });
  heard<sensor_msgs_msg_dds__BatteryState_>(
      sensor_msgs_msg_dds__BatteryState__desc, "rt/skein/marvin/battery", false,
      [](const auto& battery) { EXPECT_EQ(battery.percentage, 0.75F); });
}

TEST_F(CycloneOfOthers, HearsTasksAlarmsDiagnosticsAndReplies) {
  const auto& array = diagnostic_msgs_msg_dds__DiagnosticArray__desc;
  const auto first_is = [](const char* name) {
    return [name](const diagnostic_msgs_msg_dds__DiagnosticArray_& said) {
      ASSERT_GT(said.status._length, 0U);
      EXPECT_STREQ(said.status._buffer[0].name, name);
    };
  };
  using Array = diagnostic_msgs_msg_dds__DiagnosticArray_;
  heard<Array>(array, "rt/skein/marvin/tasks", true, first_is("marvin/task 3"));
  heard<Array>(array, "rt/skein/alarms", true, first_is("alarm 4"));
  heard<Array>(array, "rt/diagnostics", true, first_is("skein/marvin"));
  heard<std_msgs_msg_dds__String_>(
      std_msgs_msg_dds__String__desc, "rt/skein/reply", true, [](const auto& reply) {
        EXPECT_NE(std::string(reply.data).find("\"number\":7"), std::string::npos) << reply.data;
      });
}

TEST_F(CycloneOfOthers, GivesAMission) {
  const dds_entity_t to = writer(std_msgs_msg_dds__String__desc, "rt/skein/mission");
  std::string words = "- abort: {uav: marvin}";
  std_msgs_msg_dds__String_ text{words.data()};
  std::vector<wire::OperatorRequest> asked;

  ASSERT_TRUE(team.tell_until([&] {
    dds_write(to, &text);
    asked = team.requests();
    return !asked.empty();
  }));

  EXPECT_EQ(asked[0].request, words);
}

}  // namespace
}  // namespace skein::ros2_out
