// SPDX-License-Identifier: Apache-2.0
// The observer against Fast DDS programs that know nothing of it.
#include "skein/blackboard/fastdds_observer.hpp"

#include <fastdds/statePubSubTypes.h>
#include <gtest/gtest.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "adapters/fastdds/qos.hpp"
#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/program_description.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using ClockType = skein::idl::ClockPubSubType;

/// A plain Fast DDS participant with endpoints of a generated type under any topic name.
class Program {
 public:
  explicit Program(std::uint32_t domain) {
    DdsConfig config;
    config.domain = domain;
    config.participant_name = "program";
    constexpr std::uint32_t kNumber = 20;  // out of the way of the observer's
    participant_ = factory()->create_participant(domain, fastdds::participant_qos(config, kNumber));
    type_ = dds::TypeSupport(new ClockType);
    type_->auto_fill_type_object(false);
    type_->auto_fill_type_information(false);
    type_.register_type(participant_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    participant_->delete_contained_entities();
    factory()->delete_participant(participant_);
  }

  dds::DataWriter* writer(const std::string& topic, const dds::DataWriterQos& qos,
                          const std::string& partition = "world") {
    dds::PublisherQos group;
    group.partition().push_back(partition.c_str());
    publisher_ = participant_->create_publisher(group);
    return publisher_->create_datawriter(
        participant_->create_topic(topic, type_.get_type_name(), dds::TOPIC_QOS_DEFAULT), qos);
  }
  void move_writers(const std::string& partition) {
    dds::PublisherQos group = publisher_->get_qos();
    group.partition().clear();
    group.partition().push_back(partition.c_str());
    publisher_->set_qos(group);
  }
  static dds::DomainParticipantFactory* factory() {
    return dds::DomainParticipantFactory::get_instance();
  }

 private:
  dds::DomainParticipant* participant_;
  dds::Publisher* publisher_ = nullptr;
  dds::TypeSupport type_;
};

dds::DataWriterQos state_writer() {
  return fastdds::writer_qos(wire::Slot::kClock, ChannelKind::kWorld);
}

class ObserverOfFastDds : public ::testing::Test {
 protected:
  void SetUp() override {
    auto lease = claim_domain();
    ASSERT_TRUE(lease.has_value()) << lease.error().why;
    lease_.emplace(std::move(*lease));
    observer_.emplace(ObserverConfig{lease_->domain(), "spy", {}});
    observer_->on_sighting([this] {
      const std::lock_guard lock(mutex_);
      seen_something_ = true;
      wake_.notify_one();
    });
    ASSERT_TRUE(observer_->open().has_value());
    program_.emplace(lease_->domain());
  }

  bool watch_until(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
      for (Sighting& one : observer_->take()) sightings_.push_back(std::move(one));
      if (condition()) return true;
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(100), [this] { return seen_something_; });
      seen_something_ = false;
    }
    return false;
  }
  template <class What>
  std::vector<What> all() const {
    std::vector<What> some;
    for (const Sighting& one : sightings_)
      if (const auto* what = std::get_if<What>(&one)) some.push_back(*what);
    return some;
  }
  std::optional<Endpoint> endpoint(const std::string& topic) const {
    std::optional<Endpoint> found;
    for (const EndpointSeen& seen : all<EndpointSeen>())
      if (seen.endpoint.topic == topic) found = seen.endpoint;
    return found;
  }
  static Subscription reading(const Endpoint& writer) {
    return {writer.topic, writer.type, writer.keyed, {"*"}, writer.qos};
  }

  std::optional<DomainLease> lease_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool seen_something_ = false;
  std::optional<FastDdsObserver> observer_;
  std::optional<Program> program_;
  std::vector<Sighting> sightings_;
};

TEST_F(ObserverOfFastDds, SeesWhoTakesPartAndWhatTheProgramSaysOfItself) {
  ASSERT_TRUE(watch_until([&] { return !all<ParticipantSeen>().empty(); }));
  const Participant participant = all<ParticipantSeen>().front().participant;
  EXPECT_EQ(participant.name, "program");
  EXPECT_EQ(participant.vendor, "fastdds");
  EXPECT_EQ(participant.guid.size(), 24U);
  ASSERT_FALSE(participant.addresses.empty());
  EXPECT_EQ(participant.addresses.front().substr(0, 10), "127.0.0.1:");
  EXPECT_EQ(parse_program_description(participant.description), program_description());
}

TEST_F(ObserverOfFastDds, SeesEndpointsWithTheirQosAndWhenTheyMove) {
  program_->writer("Clock", state_writer());
  ASSERT_TRUE(watch_until([&] { return endpoint("Clock").has_value(); }));
  EXPECT_TRUE(endpoint("Clock")->writer);
  EXPECT_TRUE(endpoint("Clock")->keyed);
  EXPECT_EQ(endpoint("Clock")->type, "skein::idl::Clock");
  EXPECT_EQ(endpoint("Clock")->partitions, std::vector<std::string>{"world"});
  EXPECT_TRUE(endpoint("Clock")->qos.reliable);
  EXPECT_EQ(endpoint("Clock")->qos.durability, Durability::kTransientLocal);

  program_->move_writers("cut/out/world");

  EXPECT_TRUE(
      watch_until([&] { return endpoint("Clock")->partitions.front() == "cut/out/world"; }));
}

TEST_F(ObserverOfFastDds, SeesAProgramLeave) {
  program_->writer("Clock", state_writer());
  ASSERT_TRUE(watch_until([&] { return endpoint("Clock").has_value(); }));
  program_.reset();
  ASSERT_TRUE(watch_until([&] { return !all<ParticipantGone>().empty(); }));
  EXPECT_FALSE(all<ParticipantGone>().front().silent) << "it said goodbye";
}

TEST_F(ObserverOfFastDds, ReadsTheBytesOfTheLastStateAlsoOfATopicThatIsNoneOfOurs) {
  auto* const writer = program_->writer("rt/time_of_others", state_writer(), "");
  skein::idl::Clock clock;
  clock.origin(7);
  clock.rate(2.5);
  ASSERT_TRUE(writer->write(&clock));
  ASSERT_TRUE(watch_until([&] { return endpoint("rt/time_of_others").has_value(); }));
  Subscription subscription = reading(*endpoint("rt/time_of_others"));
  subscription.partitions = {"", "*"};
  ASSERT_TRUE(observer_->read(subscription).has_value());

  ASSERT_TRUE(watch_until([&] { return !all<SampleSeen>().empty(); }));

  const SampleSeen seen = all<SampleSeen>().front();
  EXPECT_EQ(seen.topic, "rt/time_of_others");
  EXPECT_EQ(seen.writer, endpoint("rt/time_of_others")->guid);
  EXPECT_GT(seen.sent, 1'500'000'000'000'000'000);
  EXPECT_GE(seen.heard, seen.sent);
  const auto content = decode(wire::Slot::kClock, seen.bytes);
  ASSERT_TRUE(std::holds_alternative<wire::Sample>(content));
  EXPECT_EQ(std::get<wire::Clock>(std::get<wire::Sample>(content)).rate, 2.5);
}

TEST_F(ObserverOfFastDds, SaysThatATopicIsReadAlreadyWithAnotherType) {
  ASSERT_TRUE(observer_->read({"Clock", "skein::idl::Clock", true, {"*"}, {}}).has_value());
  const auto again = observer_->read({"Clock", "rosgraph::Clock", true, {"*"}, {}});
  ASSERT_FALSE(again.has_value());
  EXPECT_NE(again.error().why.find("Clock is not read as rosgraph::Clock"), std::string::npos);
}

TEST_F(ObserverOfFastDds, RefusesAnInterfaceThatIsNotThere) {
  ObserverConfig config{lease_->domain(), "spy", {}};
  config.network.interfaces = {"10.254.253.252"};
  FastDdsObserver deaf(config);
  const auto opened = deaf.open();
  ASSERT_FALSE(opened.has_value());
  EXPECT_NE(opened.error().why.find("10.254.253.252"), std::string::npos);
}

// The judgement of refusals() against Fast DDS's own, for every pair of reliability and durability.
TEST_F(ObserverOfFastDds, IsRefusedWhereRefusalsSaySo) {
  int number = 0;
  for (const bool offers : {false, true}) {
    for (const bool keeps : {false, true}) {
      dds::DataWriterQos offered;
      offered.reliability().kind =
          offers ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
      offered.durability().kind =
          keeps ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
      auto* const writer = program_->writer("topic" + std::to_string(++number), offered);
      for (const bool asks : {false, true}) {
        for (const bool wants : {false, true}) {
          const std::string topic = "topic" + std::to_string(number);
          ASSERT_TRUE(watch_until([&] { return endpoint(topic).has_value(); }));
          Endpoint reader = *endpoint(topic);
          reader.qos = {asks, wants ? Durability::kTransientLocal : Durability::kVolatile};
          const bool refused = !refusals(*endpoint(topic), reader).empty();
          dds::PublicationMatchedStatus before;
          dds::OfferedIncompatibleQosStatus incompatible_before;
          writer->get_publication_matched_status(before);
          writer->get_offered_incompatible_qos_status(incompatible_before);
          ASSERT_TRUE(observer_->read(reading(reader)).has_value());
          // Whatever it decides, it has decided once the status tells of either.
          const bool decided = watch_until([&] {
            dds::PublicationMatchedStatus matched;
            dds::OfferedIncompatibleQosStatus incompatible;
            writer->get_publication_matched_status(matched);
            writer->get_offered_incompatible_qos_status(incompatible);
            return refused ? incompatible.total_count > incompatible_before.total_count
                           : matched.current_count > before.current_count;
          });
          EXPECT_TRUE(decided) << offers << keeps << asks << wants
                               << (refused ? " not refused" : " refused");
        }
      }
    }
  }
}

}  // namespace
}  // namespace skein::blackboard
