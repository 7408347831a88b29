// SPDX-License-Identifier: Apache-2.0
// Topics of others over Fast DDS.
#include "skein/blackboard/foreign_topics.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include "adapters/rtps/mailbox.hpp"
#include "participation.hpp"
#include "raw_type.hpp"

namespace skein::blackboard {

namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;
using Bytes = std::vector<std::uint8_t>;

using Inbox = rtps::MailboxOf<ForeignTopics::Arrival>;

class Listener final : public dds::DataReaderListener {
 public:
  /// The inbox outlives it.
  Listener(Inbox& inbox, std::size_t topic) : inbox_(inbox), topic_(topic) {}

  void on_data_available(dds::DataReader* reader) override {
    Bytes bytes;
    dds::SampleInfo info;
    bool any = false;
    while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      inbox_.put({topic_, std::move(bytes)});
      bytes = {};
      any = true;
    }
    if (any) inbox_.notify();
  }

 private:
  Inbox& inbox_;
  std::size_t topic_;
};

template <class Qos>
Qos with(Qos qos, const ForeignTopic& topic) {
  qos.reliability().kind =
      topic.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = dds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = topic.depth;
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
  return qos;
}

}  // namespace

class ForeignTopics::Impl {
 public:
  explicit Impl(ForeignConfig config) : config_(std::move(config)) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() = default;

  Result<void, Failure> open() {
    DdsConfig config;
    config.domain = config_.domain;
    config.participant_name = config_.participant_name;
    config.network = config_.network;
    config.network.keys.clear();
    if (auto joined = participation_.join(config, nullptr); !joined) return joined;
    auto* const publisher =
        participant().create_publisher(dds::PublisherQos(), nullptr, dds::StatusMask::none());
    for (const ForeignTopic& one : config_.writes) {
      writers_.push_back(publisher->create_datawriter(
          topic(one), with(publisher->get_default_datawriter_qos(), one), nullptr,
          dds::StatusMask::none()));
      if (writers_.back() == nullptr) return failure("DDS refuses to write " + one.name);
    }
    return read();
  }

  bool write(std::size_t topic, std::span<const std::uint8_t> bytes) {
    Bytes sample(bytes.begin(), bytes.end());
    return writers_.at(topic)->write(&sample);
  }
  Inbox& inbox() { return inbox_; }

 private:
  Result<void, Failure> read() {
    auto* const subscriber =
        participant().create_subscriber(dds::SubscriberQos(), nullptr, dds::StatusMask::none());
    for (std::size_t i = 0; i < config_.reads.size(); ++i) {
      listeners_.push_back(std::make_unique<Listener>(inbox_, i));
      const ForeignTopic& one = config_.reads[i];
      const auto* reader = subscriber->create_datareader(
          topic(one), with(subscriber->get_default_datareader_qos(), one), listeners_.back().get(),
          dds::StatusMask::data_available());
      if (reader == nullptr) return failure("DDS refuses to read " + one.name);
    }
    return {};
  }

  dds::Topic* topic(const ForeignTopic& one) {
    const dds::TypeSupport type(new fastdds::RawType(one.type, false));
    if (type.register_type(&participant()) != ReturnCode_t::RETCODE_OK) return nullptr;
    return participant().create_topic(one.name, type.get_type_name(), dds::TopicQos{}, nullptr,
                                      dds::StatusMask::none());
  }
  dds::DomainParticipant& participant() { return *participation_.participant(); }

  ForeignConfig config_;
  Inbox inbox_{kWaiting};
  std::vector<std::unique_ptr<Listener>> listeners_;
  fastdds::Participation participation_;   // ends before its listeners
  std::vector<dds::DataWriter*> writers_;  // owned by the participant
};

ForeignTopics::ForeignTopics(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ForeignTopics::~ForeignTopics() = default;

Result<std::unique_ptr<ForeignTopics>, Failure> ForeignTopics::open(ForeignConfig config) {
  auto impl = std::make_unique<Impl>(std::move(config));
  if (auto opened = impl->open(); !opened) return tl::unexpected(opened.error());
  return std::unique_ptr<ForeignTopics>(new ForeignTopics(std::move(impl)));
}

bool ForeignTopics::write(std::size_t topic, std::span<const std::uint8_t> bytes) {
  return impl_->write(topic, bytes);
}
std::vector<ForeignTopics::Arrival> ForeignTopics::take() { return impl_->inbox().take(); }
void ForeignTopics::on_arrival(std::function<void()> notify) {
  impl_->inbox().on_arrival(std::move(notify));
}

}  // namespace skein::blackboard
