// SPDX-License-Identifier: Apache-2.0
// A program of Fast DDS that knows nothing of Skein but the IDL of the messages hears and asks.
#include <ros2_fastdds/ros2PubSubTypes.h>

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include "testing/team.hpp"

namespace skein::ros2_out {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

/// Readers and writers with the QoS that ROS 2 has by default.
class Raw {
 public:
  explicit Raw(std::uint32_t domain) {
    participant_ = factory()->create_participant(domain, on_this_machine(domain));
    subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
    publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;
  ~Raw() {
    participant_->delete_contained_entities();
    factory()->delete_participant(participant_);
  }

  template <class Type>
  dds::DataReader* reader(const std::string& name, bool reliable) {
    dds::DataReaderQos qos = subscriber_->get_default_datareader_qos();
    qos.reliability().kind =
        reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    qos.history().depth = 10;
    return subscriber_->create_datareader(topic<Type>(name), qos);
  }
  template <class Type>
  dds::DataWriter* writer(const std::string& name) {
    dds::DataWriterQos qos = publisher_->get_default_datawriter_qos();
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    return publisher_->create_datawriter(topic<Type>(name), qos);
  }

 private:
  /// As a program of ROS 2 that stays on this machine: UDP on the loopback interface, others looked
  /// for at the ports of the first participants.
  static dds::DomainParticipantQos on_this_machine(std::uint32_t domain) {
    dds::DomainParticipantQos qos;
    const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList = {"127.0.0.1"};
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(udp);
    for (std::uint32_t one = 0; one < 8; ++one) {
      eprosima::fastrtps::rtps::Locator_t peer(LOCATOR_KIND_UDPv4,
                                               7400 + 250 * domain + 10 + 2 * one);
      eprosima::fastrtps::rtps::IPLocator::setIPv4(peer, "127.0.0.1");
      qos.wire_protocol().builtin.initialPeersList.push_back(peer);
    }
    return qos;
  }
  static dds::DomainParticipantFactory* factory() {
    return dds::DomainParticipantFactory::get_instance();
  }
  template <class Type>
  dds::Topic* topic(const std::string& name) {
    dds::TypeSupport type(new Type);
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant_);
    return participant_->create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant_;
  dds::Subscriber* subscriber_;
  dds::Publisher* publisher_;
};

class FastDdsOfOthers : public ::testing::Test {
 protected:
  template <class Type>
  typename Type::type heard(const std::string& topic, bool reliable = true) {
    auto* reader = raw.reader<Type>(topic, reliable);
    typename Type::type message;
    dds::SampleInfo info;
    EXPECT_TRUE(team.tell_until([&] {
      return reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK;
    })) << topic;
    return message;
  }

  testing::Team team;
  Raw raw{team.domain()};
};

TEST_F(FastDdsOfOthers, HearsWhereAUavIs) {
  auto fix = heard<sensor_msgs::msg::dds_::NavSatFix_PubSubType>("rt/skein/marvin/fix", false);
  EXPECT_EQ(fix.header().stamp().sec(), 1'000'000);
  EXPECT_EQ(fix.header().stamp().nanosec(), 250'000'000U);
  EXPECT_NEAR(fix.latitude(), 40, 1e-9);
  EXPECT_NEAR(fix.altitude(), 250, 1e-6);

  auto odometry = heard<nav_msgs::msg::dds_::Odometry_PubSubType>("rt/skein/marvin/odometry");
  EXPECT_EQ(odometry.child_frame_id(), "marvin");
  EXPECT_EQ(odometry.pose().pose().position().z(), 50);

  auto battery =
      heard<sensor_msgs::msg::dds_::BatteryState_PubSubType>("rt/skein/marvin/battery", false);
  EXPECT_EQ(battery.percentage(), 0.75F);
}

TEST_F(FastDdsOfOthers, HearsTasksAlarmsDiagnosticsAndReplies) {
  using Array = diagnostic_msgs::msg::dds_::DiagnosticArray_PubSubType;
  EXPECT_EQ(heard<Array>("rt/skein/marvin/tasks").status().at(0).name(), "marvin/task 3");
  EXPECT_EQ(heard<Array>("rt/skein/alarms").status().at(0).name(), "alarm 4");
  EXPECT_EQ(heard<Array>("rt/diagnostics").status().at(0).hardware_id(), "marvin");
  const auto reply = heard<std_msgs::msg::dds_::String_PubSubType>("rt/skein/reply").data();
  EXPECT_NE(reply.find("\"number\":7"), std::string::npos) << reply;
}

TEST_F(FastDdsOfOthers, GivesAMission) {
  auto* writer = raw.writer<std_msgs::msg::dds_::String_PubSubType>("rt/skein/mission");
  std_msgs::msg::dds_::String_ text;
  text.data("{uav: marvin, id: 1}");
  std::vector<wire::OperatorRequest> asked;

  ASSERT_TRUE(team.tell_until([&] {
    writer->write(&text);
    asked = team.requests();
    return !asked.empty();
  }));

  EXPECT_EQ(asked[0].who, "ros2");
  EXPECT_EQ(asked[0].request, "- mission:\n    {uav: marvin, id: 1}");
  EXPECT_GT(asked[0].number, 0U);
}

}  // namespace
}  // namespace skein::ros2_out
