// SPDX-License-Identifier: Apache-2.0
// The endpoints of a channel, as Cyclone DDS makes them.
#include "channel_endpoints.hpp"

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>

#include "qos.hpp"
#include "sample_type.hpp"

namespace skein::blackboard::cyclonedds {

const Topics::Topic& Topics::of(wire::Slot slot) {
  Topic& topic = topics_[slot];
  if (topic.entity > 0) return topic;
  ddsi_sertype* type = make_sample_type(slot);
  const std::string name(wire::slot_name(slot));
  topic.entity =
      dds_create_topic_sertype(participant_, name.c_str(), &type, nullptr, nullptr, nullptr);
  if (topic.entity > 0) {
    topic.type = type;  // the one of the domain
  } else {
    ddsi_sertype_unref(type);
  }
  return topic;
}

ChannelEndpoints::ChannelEndpoints(const dds_entity_t& participant, Topics& topics,
                                   const rtps::LinkPlan& link, std::size_t channel,
                                   rtps::Mailbox& mailbox, rtps::Matches& matches)
    : participant_(participant),
      topics_(topics),
      kind_(link.config.kind),
      partition_(link.config.partition),
      writes_(!link.writes.empty()),
      reads_(!link.reads.empty()) {
  for (const wire::Slot slot : link.writes) {
    if (wire::slot_class(slot) != wire::SlotClass::kState)
      match_listeners_.emplace(slot, MatchListener{&matches, {channel, slot}});
  }
  for (const wire::Slot slot : link.reads) listeners_.try_emplace(slot, mailbox, channel, slot);
}

Result<void, Failure> ChannelEndpoints::open() {
  const Qos qos = partition_qos(partition_);
  if (writes_ && publisher_ <= 0) {
    publisher_ = dds_create_publisher(participant_, qos.get(), nullptr);
    if (publisher_ < 0) return made(publisher_);
  }
  if (reads_ && subscriber_ <= 0) {
    subscriber_ = dds_create_subscriber(participant_, qos.get(), nullptr);
    if (subscriber_ < 0) return made(subscriber_);
  }
  return {};
}

Result<void, Failure> ChannelEndpoints::add_writer(wire::Slot slot) {
  const dds_entity_t on = topics_.of(slot).entity;
  if (on < 0) return made(on);
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
      listener_of(slot), &dds_delete_listener);
  const dds_entity_t writer =
      dds_create_writer(publisher_, on, writer_qos(slot, kind_).get(), listener.get());
  if (writer > 0) writers_[static_cast<std::size_t>(slot)] = writer;
  return made(writer);
}

dds_listener_t* ChannelEndpoints::listener_of(wire::Slot slot) {
  const auto found = match_listeners_.find(slot);
  if (found == match_listeners_.end()) return nullptr;
  dds_listener_t* const listener = dds_create_listener(&found->second);
  dds_lset_publication_matched(
      listener, [](dds_entity_t, const dds_publication_matched_status_t status, void* self) {
        const auto& it = *static_cast<const MatchListener*>(self);
        if (status.current_count_change > 0) it.matches->found(it.writer);
      });
  return listener;
}

Result<void, Failure> ChannelEndpoints::add_reader(wire::Slot slot) {
  const dds_entity_t on = topics_.of(slot).entity;
  if (on < 0) return made(on);
  return made(listeners_.at(slot).make_reader(subscriber_, on, *reader_qos(slot, kind_)));
}

Result<void, Failure> ChannelEndpoints::close() {
  writers_.fill(0);
  dds_return_t worst = DDS_RETCODE_OK;
  for (dds_entity_t* const owner : {&publisher_, &subscriber_})
    if (const dds_entity_t one = std::exchange(*owner, 0); one > 0)
      worst = std::min(worst, dds_delete(one));
  if (worst == DDS_RETCODE_OK) return {};
  return failure("Cyclone DDS does not delete the endpoints of channel " + partition_ + ": " +
                 dds_strretcode(worst));
}

bool ChannelEndpoints::write(const wire::Sample& sample) {
  const wire::Slot slot = wire::slot_of(sample);
  const dds_entity_t writer = writers_[static_cast<std::size_t>(slot)];
  if (writer <= 0) return false;
  ddsi_serdata* const data = make_outgoing(*topics_.of(slot).type, sample);
  return dds_writecdr(writer, data) == DDS_RETCODE_OK;
}

void ChannelEndpoints::flush(Clock::time_point until) {
  constexpr std::chrono::milliseconds kLook{5};
  // Asked again and again: Cyclone would wait until an instant of the wall clock (WallClock).
  for (const dds_entity_t writer : writers_)
    while (writer > 0 && Clock::now() < until &&
           dds_wait_for_acks(writer, 0) == DDS_RETCODE_TIMEOUT)
      std::this_thread::sleep_for(kLook);
}

Result<void, Failure> ChannelEndpoints::made(dds_return_t code) const {
  if (code >= 0) return {};
  return failure("Cyclone DDS refuses the endpoints of channel " + partition_ + ": " +
                 dds_strretcode(code));
}

}  // namespace skein::blackboard::cyclonedds
