// SPDX-License-Identifier: Apache-2.0
// A blackboard, over Fast DDS and over Cyclone DDS that announces its types, against Fast DDS
// programs that know nothing of Skein but idl/.
#include <fastdds/statePubSubTypes.h>
#include <fastdds/streamPubSubTypes.h>
#include <gtest/gtest.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>

#include "adapters/fastdds/qos.hpp"
#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/blackboard/fastdds_transport.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

const Node kGround{NodeNumber(1), "ground"};
const Node kMarvin{NodeNumber(3), "marvin"};

/// A plain Fast DDS participant with endpoints of generated types.
class Raw {
 public:
  explicit Raw(std::uint32_t domain) {
    DdsConfig config;
    config.domain = domain;
    constexpr std::uint32_t kNumber = 20;  // out of the way of the blackboard's
    participant_ = factory()->create_participant(domain, fastdds::participant_qos(config, kNumber));
  }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;
  ~Raw() {
    participant_->delete_contained_entities();
    factory()->delete_participant(participant_);
  }

  template <class Type>
  dds::DataWriter* writer(wire::Slot slot, const std::string& partition) {
    dds::PublisherQos qos;
    qos.partition().push_back(partition.c_str());
    return participant_->create_publisher(qos)->create_datawriter(
        topic<Type>(slot), fastdds::writer_qos(slot, ChannelKind::kRadio));
  }
  template <class Type>
  dds::DataReader* reader(wire::Slot slot, const std::string& partition) {
    dds::SubscriberQos qos;
    qos.partition().push_back(partition.c_str());
    return participant_->create_subscriber(qos)->create_datareader(
        topic<Type>(slot), fastdds::reader_qos(slot, ChannelKind::kRadio));
  }

 private:
  static dds::DomainParticipantFactory* factory() {
    return dds::DomainParticipantFactory::get_instance();
  }
  template <class Type>
  dds::Topic* topic(wire::Slot slot) {
    dds::TypeSupport type(new Type);
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant_);
    return participant_->create_topic(std::string(wire::slot_name(slot)), type.get_type_name(),
                                      dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant_;
};

class FastDdsRaw : public ::testing::TestWithParam<DdsVendor> {
 protected:
  FastDdsRaw() {
    transport->on_arrival([this] {
      const std::lock_guard lock(mutex_);
      arrived_ = true;
      wake_.notify_one();
    });
    Config settings;
    settings.self = kGround.number;
    settings.channels = radio_link(kGround, kMarvin);
    auto opened = Blackboard::open(std::move(settings), *transport);
    if (opened) ground = std::make_unique<Blackboard>(std::move(*opened));
  }

  static DdsConfig config(std::uint32_t domain) {
    DdsConfig config;
    config.domain = domain;
    config.network.dds = GetParam();
    config.network.types = GetParam() == DdsVendor::kCycloneDds;
    return config;
  }
  static Now now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return {{}, Duration::nanoseconds(std::chrono::nanoseconds(since).count())};
  }
  bool run_until(const std::function<bool()>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < deadline) {
      for (Incoming& incoming : ground->step(now())) received.push_back(std::move(incoming));
      if (condition()) return true;
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return arrived_; });
      arrived_ = false;
    }
    return false;
  }
  std::vector<Dropped> dropped() const {
    std::vector<Dropped> found;
    for (const Incoming& incoming : received) {
      if (const auto* report = std::get_if<Dropped>(&incoming)) found.push_back(*report);
    }
    return found;
  }
  std::size_t received_samples() const {
    return static_cast<std::size_t>(std::ranges::count_if(received, [](const Incoming& incoming) {
      return std::holds_alternative<Received>(incoming);
    }));
  }
  template <class T>
  static void stamp(T& sample, std::uint64_t sequence) {
    sample.origin(kMarvin.number.value());
    sample.incarnation(1);
    sample.sequence_number(sequence);
    sample.expires(wire::kNever);
  }

  DomainLease lease = claim_domain().value();
  std::unique_ptr<Transport> transport = make_dds_transport(config(lease.domain()));
  std::unique_ptr<Blackboard> ground;
  Raw raw{lease.domain()};
  std::vector<Incoming> received;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool arrived_ = false;
};

TEST_P(FastDdsRaw, AnEnumerationOutOfRangeIsDropped) {
  auto* writer =
      raw.writer<idl::PlanBoardPubSubType>(wire::Slot::kPlanBoard, "radio/marvin>ground");
  idl::PlanBoard board;
  stamp(board, 1);
  board.tasks().resize(1);
  board.tasks()[0].state(static_cast<idl::TaskState>(17));

  ASSERT_TRUE(writer->write(&board));

  ASSERT_TRUE(run_until([&] { return !dropped().empty(); }));
  EXPECT_EQ(dropped()[0].slot, wire::Slot::kPlanBoard);
  EXPECT_EQ(dropped()[0].origin, kMarvin.number);
  EXPECT_EQ(dropped()[0].field, "tasks[0].state");
  EXPECT_EQ(received_samples(), 0U);
}

TEST_P(FastDdsRaw, ANumberThatIsNotFiniteIsDropped) {
  auto* writer =
      raw.writer<idl::TelemetryPubSubType>(wire::Slot::kTelemetry, "radio/marvin>ground");
  idl::Telemetry telemetry;
  telemetry.position().z(std::numeric_limits<float>::quiet_NaN());
  std::uint64_t sequence = 0;

  ASSERT_TRUE(run_until([&] {
    stamp(telemetry, ++sequence);
    writer->write(&telemetry);
    return !dropped().empty();
  }));

  EXPECT_EQ(dropped()[0].field, "position.z");
  EXPECT_TRUE(dropped()[0].first);
  EXPECT_EQ(received_samples(), 0U);
}

TEST_P(FastDdsRaw, ASequenceBeyondTheLimitIsDroppedAndWhatFollowsIsRead) {
  auto* writer =
      raw.writer<idl::PlanBoardPubSubType>(wire::Slot::kPlanBoard, "radio/marvin>ground");
  idl::PlanBoard board;
  stamp(board, 1);
  board.tasks().resize(wire::kMaximumSequence + 1);
  ASSERT_TRUE(writer->write(&board));
  ASSERT_TRUE(run_until([&] { return !dropped().empty(); }));
  EXPECT_EQ(dropped()[0].field, "tasks");
  EXPECT_EQ(dropped()[0].origin, kMarvin.number);

  stamp(board, 2);
  board.tasks().resize(2);
  ASSERT_TRUE(writer->write(&board));

  EXPECT_TRUE(run_until([&] { return received_samples() == 1; }));
}

TEST_P(FastDdsRaw, AGeneratedReaderUnderstandsUs) {
  auto* reader =
      raw.reader<idl::AutonomyDegreePubSubType>(wire::Slot::kAutonomyDegree, "radio/ground>marvin");
  wire::AutonomyDegree degree;
  degree.uav = "marvin";
  degree.degree = 4;
  degree.contact_policy = "hold";

  ASSERT_TRUE(ground->send(degree, kMarvin.number, now()));

  idl::AutonomyDegree seen;
  dds::SampleInfo info;
  ASSERT_TRUE(run_until(
      [&] { return reader->take_next_sample(&seen, &info) == ReturnCode_t::RETCODE_OK; }));
  EXPECT_EQ(seen.origin(), kGround.number.value());
  EXPECT_EQ(seen.destination(), kMarvin.number.value());
  EXPECT_EQ(seen.uav(), "marvin");
  EXPECT_EQ(seen.degree(), 4);
  EXPECT_EQ(seen.contact_policy(), "hold");
}

INSTANTIATE_TEST_SUITE_P(Ours, FastDdsRaw,
                         ::testing::Values(DdsVendor::kFastDds, DdsVendor::kCycloneDds),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(FastDdsTransport, AnAddressThatNobodyHereHasIsAFailureAndNotSilence) {
  DdsConfig lost;
  lost.domain = 1;
  lost.participant_name = "lost";
  lost.network.interfaces = {"127.0.0.1", "192.0.2.77"};
  FastDdsTransport transport(lost);

  const auto opened = transport.open({kGround.number, {}, {}});

  ASSERT_FALSE(opened.has_value());
  EXPECT_EQ(opened.error().why, "no interface that is up has address 192.0.2.77");
}

}  // namespace
}  // namespace skein::blackboard
