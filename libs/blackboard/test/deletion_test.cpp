// SPDX-License-Identifier: Apache-2.0
// Writers that are deleted while others have not acknowledged what they wrote.
#include "adapters/fastdds/deletion.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <future>
#include <mutex>
#include <thread>

#include "adapters/fastdds/participation.hpp"
#include "adapters/fastdds/raw_type.hpp"
#include "skein/blackboard/domain_lease.hpp"

namespace skein::blackboard {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::Duration_t;

/// Keeps the thread that receives, so that nothing is acknowledged, until it is let go.
class Busy final : public dds::DataReaderListener {
 public:
  void on_data_available(dds::DataReader* /*reader*/) override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return over_; });
  }
  void let_go() {
    const std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
};

class Matched final : public dds::DataWriterListener {
 public:
  void on_publication_matched(dds::DataWriter* /*writer*/,
                              const dds::PublicationMatchedStatus& status) override {
    const std::lock_guard lock(mutex_);
    now_ = status.current_count > 0;
    changed_.notify_all();
  }
  bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(10), [this] { return now_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool now_ = false;
};

/// A participant with the topic "words".
class Participant {
 public:
  Participant(std::uint32_t domain, const std::string& name) {
    DdsConfig config;
    config.domain = domain;
    config.participant_name = name;
    EXPECT_TRUE(
        participation_.join(config, nullptr, {}, fastdds::Departures::kLeftToTheLease).has_value());
    dds::TypeSupport(new fastdds::RawType("Words", false))
        .register_type(participation_.participant());
    topic_ = participant().create_topic("words", "Words", dds::TOPIC_QOS_DEFAULT);
  }
  dds::DomainParticipant& participant() { return *participation_.participant(); }
  dds::Topic* topic() { return topic_; }

 private:
  fastdds::Participation participation_;
  dds::Topic* topic_ = nullptr;
};

dds::DataWriter* writer_of(Participant& peer, dds::Publisher& publisher, Matched& matched) {
  dds::DataWriterQos qos;
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 500;
  qos.data_sharing().off();
  qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(0, 20'000);
  return publisher.create_datawriter(peer.topic(), qos, &matched);
}

/// Ends the process where the deletion does not end: there is nothing else that could be ended.
bool deleted_in_time(dds::DomainParticipant& participant, dds::Publisher* publisher) {
  std::promise<bool> deleted;
  auto future = deleted.get_future();
  std::thread deleting(
      [&] { deleted.set_value(fastdds::delete_publisher(participant, publisher)); });
  if (future.wait_for(std::chrono::seconds(10)) != std::future_status::ready) {
    std::fputs("a writer is not deleted within 10 s\n", stderr);
    std::abort();
  }
  deleting.join();
  return future.get();
}

// Found by random missions over DDS (--anything --minds 9005, 9006): a decision node in flight fell
// silent for good when its link went down. Without the mend each of 10 runs ended here.
TEST(DeletionOfAWriter, EndsWhileItsHeartbeatRunsAndNobodyAcknowledges) {
  auto lease = claim_domain();
  Busy busy;
  Participant heliv(lease.value().domain(), "heliv"), marvin(lease.value().domain(), "marvin");
  dds::Subscriber* const subscriber =
      heliv.participant().create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  dds::DataReaderQos reads;
  reads.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  ASSERT_NE(subscriber->create_datareader(heliv.topic(), reads, &busy), nullptr);
  for (int round = 0; round < 40; ++round) {
    Matched matched;
    dds::Publisher* const publisher =
        marvin.participant().create_publisher(dds::PUBLISHER_QOS_DEFAULT);
    dds::DataWriter* const writer = writer_of(marvin, *publisher, matched);
    ASSERT_TRUE(matched.wait());
    fastdds::RawType::Sample words{0, 1, 0, 0, 1, 2, 3, 4};
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(writer->write(&words));
    EXPECT_TRUE(deleted_in_time(marvin.participant(), publisher));
  }
  busy.let_go();
}

}  // namespace
}  // namespace skein::blackboard
