// SPDX-License-Identifier: Apache-2.0
// The endpoints of a channel, as Fast DDS makes them.
#include "channel_endpoints.hpp"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>

#include <utility>

#include "deletion.hpp"
#include "qos.hpp"
#include "sample_type.hpp"

namespace skein::blackboard::fastdds {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

dds::Topic* Topics::of(wire::Slot slot) {
  dds::Topic*& topic = topics_[slot];
  if (topic != nullptr) return topic;
  auto* const participant = participation_.participant();
  const dds::TypeSupport type(new SampleType(slot));
  if (type.register_type(participant) != ReturnCode_t::RETCODE_OK) return nullptr;
  topic = participant->create_topic(std::string(wire::slot_name(slot)), type.get_type_name(),
                                    dds::TopicQos{}, nullptr, dds::StatusMask::none());
  return topic;
}

ChannelEndpoints::ChannelEndpoints(const Participation& participation, Topics& topics,
                                   const rtps::LinkPlan& link,
                                   std::unique_ptr<SampleListener> listener,
                                   std::unique_ptr<WriterListener> of_writers)
    : participation_(participation),
      topics_(topics),
      kind_(link.config.kind),
      pace_(rtps::pace_of(link.config.capacity)),
      partition_(link.config.partition),
      writes_(!link.writes.empty()),
      reads_(!link.reads.empty()),
      listener_(std::move(listener)),
      of_writers_(std::move(of_writers)) {}

Result<void, Failure> ChannelEndpoints::open() {
  auto* const participant = participation_.participant();
  if (writes_ && publisher_ == nullptr) {
    dds::PublisherQos qos;
    qos.partition().push_back(partition_.c_str());
    publisher_ = participant->create_publisher(qos, nullptr, dds::StatusMask::none());
    if (publisher_ == nullptr) return refused();
  }
  if (reads_ && subscriber_ == nullptr) {
    dds::SubscriberQos qos;
    qos.partition().push_back(partition_.c_str());
    subscriber_ = participant->create_subscriber(qos, nullptr, dds::StatusMask::none());
    if (subscriber_ == nullptr) return refused();
  }
  return {};
}

Result<void, Failure> ChannelEndpoints::add_writer(wire::Slot slot) {
  dds::Topic* const on = topics_.of(slot);
  if (on == nullptr || publisher_ == nullptr) return refused();
  auto*& writer = writers_[static_cast<std::size_t>(slot)];
  const bool state = wire::slot_class(slot) == wire::SlotClass::kState;
  writer = publisher_->create_datawriter(
      on, writer_qos(slot, kind_, pace_), state ? nullptr : of_writers_.get(),
      state ? dds::StatusMask::none() : dds::StatusMask::publication_matched());
  if (writer == nullptr) return refused();
  return {};
}

Result<void, Failure> ChannelEndpoints::add_reader(wire::Slot slot) {
  dds::Topic* const on = topics_.of(slot);
  if (on == nullptr || subscriber_ == nullptr) return refused();
  const auto* const reader = subscriber_->create_datareader(
      on, reader_qos(slot, kind_), listener_.get(), dds::StatusMask::data_available());
  if (reader == nullptr) return refused();
  return {};
}

Result<void, Failure> ChannelEndpoints::close() {
  constexpr auto kOk = ReturnCode_t::RETCODE_OK;
  auto* const participant = participation_.participant();
  bool good = true;
  writers_.fill(nullptr);
  if (auto* const publisher = std::exchange(publisher_, nullptr)) {
    good = delete_publisher(*participant, publisher);
  }
  if (auto* const subscriber = std::exchange(subscriber_, nullptr)) {
    good = subscriber->delete_contained_entities() == kOk &&
           participant->delete_subscriber(subscriber) == kOk && good;
  }
  if (good) return {};
  return failure("Fast DDS does not delete the endpoints of channel " + partition_);
}

bool ChannelEndpoints::write(const wire::Sample& sample) {
  auto* const writer = writers_[static_cast<std::size_t>(wire::slot_of(sample))];
  if (writer == nullptr) return false;
  Cargo cargo;
  cargo.outgoing = &sample;
  return writer->write(&cargo);
}

void ChannelEndpoints::flush(Clock::time_point until) {
  for (dds::DataWriter* const writer : writers_) {
    const std::chrono::nanoseconds left = until - Clock::now();
    if (writer == nullptr || left.count() <= 0) continue;
    writer->wait_for_acknowledgments({static_cast<std::int32_t>(left.count() / 1'000'000'000),
                                      static_cast<std::uint32_t>(left.count() % 1'000'000'000)});
  }
}

Result<void, Failure> ChannelEndpoints::refused() const {
  return failure("Fast DDS refuses the endpoints of channel " + partition_ +
                 (participation_.identities()
                      ? ": the permissions in " + participation_.keys() + " do not allow them"
                      : ""));
}

}  // namespace skein::blackboard::fastdds
