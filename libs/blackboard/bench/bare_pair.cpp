// SPDX-License-Identifier: Apache-2.0
// Request and reply over bare Fast DDS, with the types that fastddsgen generates.
#include "bare_pair.hpp"

#include <fastdds/eventPubSubTypes.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>

#include "adapters/fastdds/qos.hpp"

namespace skein::blackboard::bench {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

/// Participant numbers clear of those that the blackboards of the two processes take.
constexpr std::uint32_t kNumberOfAsker = 20;
constexpr std::uint32_t kNumberOfAnswerer = 21;

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

}  // namespace

class BareSide::Impl {
 public:
  Impl(std::uint32_t domain, Role role) {
    FastDdsConfig config;
    config.domain = domain;
    const bool asks = role == Role::kAsks;
    participant = dds::DomainParticipantFactory::get_instance()->create_participant(
        domain, fastdds::participant_qos(config, asks ? kNumberOfAsker : kNumberOfAnswerer));
    dds::Topic* request = topic<idl::TaskRequestPubSubType>(wire::Slot::kTaskRequest);
    dds::Topic* reply = topic<idl::RequestReplyPubSubType>(wire::Slot::kRequestReply);
    dds::PublisherQos publisher;
    publisher.partition().push_back("bench/bare");
    dds::SubscriberQos subscriber;
    subscriber.partition().push_back("bench/bare");
    const auto out = asks ? wire::Slot::kTaskRequest : wire::Slot::kRequestReply;
    const auto in = asks ? wire::Slot::kRequestReply : wire::Slot::kTaskRequest;
    dds::DataReaderListener* listener = &requests;
    if (asks) listener = &replies;
    writer = participant->create_publisher(publisher)->create_datawriter(
        asks ? request : reply, fastdds::writer_qos(out, ChannelKind::kRadio));
    participant->create_subscriber(subscriber)
        ->create_datareader(asks ? reply : request, fastdds::reader_qos(in, ChannelKind::kRadio),
                            listener);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    participant->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }

  template <class Type>
  dds::Topic* topic(wire::Slot slot) {
    dds::TypeSupport type(new Type);
    type->auto_fill_type_object(false);
    type->auto_fill_type_information(false);
    type.register_type(participant);
    return participant->create_topic(std::string(wire::slot_name(slot)), type.get_type_name(),
                                     dds::TOPIC_QOS_DEFAULT);
  }

  dds::DomainParticipant* participant = nullptr;
  dds::DataWriter* writer = nullptr;
  Inbox<idl::TaskRequest> requests;
  Inbox<idl::RequestReply> replies;
};

BareSide::BareSide(std::uint32_t domain, Role role) : impl_(std::make_unique<Impl>(domain, role)) {}

BareSide::~BareSide() = default;

bool BareSide::ask(std::uint64_t command) {
  idl::TaskRequest request;
  request.origin(1);
  request.command(command);
  request.task().id(command);
  request.task().type("goto");
  request.task().parameters().resize(1);
  request.task().parameters()[0].name("to");
  request.task().parameters()[0].numbers({100.0, 200.0, 50.0});
  idl::RequestReply reply;
  return impl_->writer->write(&request) && impl_->replies.take(reply);
}

void BareSide::serve() {
  idl::TaskRequest request;
  while (true) {
    if (!impl_->requests.take(request)) continue;
    idl::RequestReply reply;
    reply.origin(2);
    reply.command(request.command());
    reply.accepted(true);
    impl_->writer->write(&reply);
  }
}

}  // namespace skein::blackboard::bench
