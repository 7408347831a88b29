// SPDX-License-Identifier: Apache-2.0
// Request, reply and stream over bare Fast DDS, with the types that fastddsgen generates.
#include "bare_pair.hpp"

#include <fastdds/eventPubSubTypes.h>
#include <fastdds/streamPubSubTypes.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

#include "adapters/fastdds/qos.hpp"

namespace skein::blackboard::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

template <class T>
class Inbox final : public dds::DataReaderListener {
 public:
  void on_data_available(dds::DataReader* reader) override {
    T sample;
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      const std::lock_guard lock(mutex_);
      samples_.push_back(std::move(sample));
      wake_.notify_one();
    }
  }
  bool take(T& sample) {
    std::unique_lock lock(mutex_);
    if (!wake_.wait_for(lock, std::chrono::seconds(5), [this] { return !samples_.empty(); })) {
      return false;
    }
    sample = std::move(samples_.front());
    samples_.pop_front();
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<T> samples_;
};

class FastDdsSide final : public BareSide {
 public:
  FastDdsSide(std::uint32_t domain, Role role) {
    DdsConfig config;
    config.domain = domain;
    const bool asks = role == Role::kAsks;
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, fastdds::participant_qos(config, bare_number(role)));
    dds::Topic* request = topic<idl::TaskRequestPubSubType>(wire::Slot::kTaskRequest);
    dds::Topic* reply = topic<idl::RequestReplyPubSubType>(wire::Slot::kRequestReply);
    dds::PublisherQos publisher;
    publisher.partition().push_back("bench/bare");
    dds::SubscriberQos subscriber;
    subscriber.partition().push_back("bench/bare");
    const auto out = asks ? wire::Slot::kTaskRequest : wire::Slot::kRequestReply;
    const auto in = asks ? wire::Slot::kRequestReply : wire::Slot::kTaskRequest;
    dds::DataReaderListener* listener = &requests_;
    if (asks) listener = &replies_;
    writer_ = participant_->create_publisher(publisher)->create_datawriter(
        asks ? request : reply, fastdds::writer_qos(out, ChannelKind::kRadio));
    participant_->create_subscriber(subscriber)
        ->create_datareader(asks ? reply : request, fastdds::reader_qos(in, ChannelKind::kRadio),
                            listener);
  }
  ~FastDdsSide() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

  bool ask(std::uint64_t command) override {
    idl::TaskRequest request;
    request.origin(1);
    request.command(command);
    request.task().id(command);
    request.task().type("goto");
    request.task().parameters().resize(1);
    request.task().parameters()[0].name("to");
    request.task().parameters()[0].numbers({100.0, 200.0, 50.0});
    idl::RequestReply reply;
    return writer_->write(&request) && replies_.take(reply);
  }

  void serve() override {
    idl::TaskRequest request;
    while (true) {
      if (!requests_.take(request)) continue;
      idl::RequestReply reply;
      reply.origin(2);
      reply.command(request.command());
      reply.accepted(true);
      writer_->write(&reply);
    }
  }

 private:
  template <class Type>
  dds::Topic* topic(wire::Slot slot) {
    dds::TypeSupport type(new Type);
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant_);
    return participant_->create_topic(std::string(wire::slot_name(slot)), type.get_type_name(),
                                      dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
  Inbox<idl::TaskRequest> requests_;
  Inbox<idl::RequestReply> replies_;
};

class FastDdsStream final : public BareStream, public dds::DataReaderListener {
 public:
  FastDdsStream(std::uint32_t domain, Role role) {
    DdsConfig config;
    config.domain = domain;
    const std::uint32_t number =
        bare_number(role == Role::kWrites ? BareSide::Role::kAsks : BareSide::Role::kAnswers);
    participant_ = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, fastdds::participant_qos(config, number));
    dds::TypeSupport type(new idl::TelemetryPubSubType);
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant_);
    dds::Topic* const topic =
        participant_->create_topic("Telemetry", type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
    if (role == Role::kWrites) {
      dds::PublisherQos publisher;
      publisher.partition().push_back("bench/bare");
      writer_ = participant_->create_publisher(publisher)->create_datawriter(
          topic, fastdds::writer_qos(wire::Slot::kTelemetry, ChannelKind::kRadio));
      return;
    }
    dds::SubscriberQos subscriber;
    subscriber.partition().push_back("bench/bare");
    participant_->create_subscriber(subscriber)
        ->create_datareader(topic, fastdds::reader_qos(wire::Slot::kTelemetry, ChannelKind::kRadio),
                            this);
  }
  ~FastDdsStream() override {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }

  bool write(std::uint64_t sequence) override {
    idl::Telemetry telemetry;
    telemetry.origin(1);
    telemetry.sequence_number(sequence);
    telemetry.uav("asker");
    telemetry.activity("flying");
    return writer_->write(&telemetry);
  }
  std::uint64_t taken() const override { return taken_; }
  void on_data_available(dds::DataReader* reader) override {
    idl::Telemetry sample;
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK)
      if (info.valid_data) ++taken_;
  }

 private:
  dds::DomainParticipant* participant_ = nullptr;
  dds::DataWriter* writer_ = nullptr;
  std::atomic<std::uint64_t> taken_{0};
};

}  // namespace

std::unique_ptr<BareStream> make_bare_fastdds_stream(std::uint32_t domain, BareStream::Role role) {
  return std::make_unique<FastDdsStream>(domain, role);
}

std::unique_ptr<BareSide> make_bare_fastdds_side(std::uint32_t domain, BareSide::Role role) {
  return std::make_unique<FastDdsSide>(domain, role);
}

}  // namespace skein::blackboard::bench
