// SPDX-License-Identifier: Apache-2.0
#include "sightings.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/topic/TopicDescription.hpp>

#include <algorithm>
#include <array>
#include <chrono>

#include "adapters/rtps/guid_text.hpp"
#include "raw_type.hpp"

namespace skein::blackboard::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::types::ReturnCode_t;

using blackboard::rtps::hexadecimal;

std::string text_of(const rtps::GuidPrefix_t& prefix) { return hexadecimal(prefix.value); }

std::string text_of(const rtps::GUID_t& guid) {
  return blackboard::rtps::guid_text(text_of(guid.guidPrefix), guid.entityId.value);
}

/// Source: OMG, list of vendor ids of RTPS.
std::string vendor_of(const rtps::VendorId_t& id) {
  struct Vendor {
    rtps::octet number;
    const char* name;
  };
  constexpr std::array kVendors{Vendor{0x01, "connext"},    Vendor{0x02, "opensplice"},
                                Vendor{0x03, "opendds"},    Vendor{0x0f, "fastdds"},
                                Vendor{0x10, "cyclonedds"}, Vendor{0x12, "rustdds"}};
  for (const Vendor& vendor : kVendors)
    if (id[0] == 0x01 && id[1] == vendor.number) return vendor.name;
  return "vendor " + hexadecimal(id);
}

template <class Time>
Duration duration_of(const Time& time) {
  if (time == eprosima::fastrtps::c_TimeInfinite) return Duration::max();
  return Duration::nanoseconds(time.to_ns());
}

/// Of a WriterQos or a ReaderQos.
template <class Qos>
EndpointQos qos_of(const Qos& from) {
  EndpointQos qos;
  qos.reliable = from.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  qos.durability = static_cast<Durability>(
      std::clamp<int>(from.m_durability.kind, 0, static_cast<int>(Durability::kPersistent)));
  qos.exclusive = from.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  qos.deadline = duration_of(from.m_deadline.period);
  qos.lifespan = duration_of(from.m_lifespan.duration);
  return qos;
}

/// Of a WriterProxyData or a ReaderProxyData.
template <class Proxy>
Endpoint endpoint_of(const Proxy& proxy, bool writer) {
  Endpoint endpoint;
  endpoint.guid = text_of(proxy.guid());
  endpoint.participant = text_of(proxy.guid().guidPrefix);
  endpoint.writer = writer;
  endpoint.keyed = proxy.topicKind() == rtps::WITH_KEY;
  endpoint.topic = proxy.topicName().c_str();
  endpoint.type = proxy.typeName().c_str();
  endpoint.partitions = proxy.m_qos.m_partition.names();
  endpoint.qos = qos_of(proxy.m_qos);
  return endpoint;
}

Participant participant_of(const rtps::ParticipantProxyData& proxy) {
  Participant participant;
  participant.guid = text_of(proxy.m_guid.guidPrefix);
  participant.name = proxy.m_participantName.c_str();
  participant.vendor = vendor_of(proxy.m_VendorId);
  for (const rtps::Locator_t& locator : proxy.default_locators.unicast) {
    const bool udp4 = locator.kind == LOCATOR_KIND_UDPv4;
    if (udp4)
      participant.addresses.push_back(rtps::IPLocator::toIPv4string(locator) + ":" +
                                      std::to_string(locator.port));
  }
  const auto& said = proxy.m_userData.data_vec();
  participant.description.assign(said.begin(), said.end());
  return participant;
}

std::int64_t wall_clock() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

Duration steady_clock() {
  return Duration::nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                   std::chrono::steady_clock::now().time_since_epoch())
                                   .count());
}

}  // namespace

std::vector<Sighting> Sightings::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(all_, {});
}

void Sightings::on_sighting(std::function<void()> notify) {
  const std::lock_guard lock(notify_mutex_);
  notify_ = std::move(notify);
}

void Sightings::put(std::vector<Sighting> sightings) {
  {
    const std::lock_guard lock(mutex_);
    for (Sighting& one : sightings) all_.push_back(std::move(one));
  }
  const std::lock_guard lock(notify_mutex_);
  if (notify_) notify_();
}

void Sightings::on_participant_discovery(dds::DomainParticipant* /*participant*/,
                                         rtps::ParticipantDiscoveryInfo&& found) {
  using Info = rtps::ParticipantDiscoveryInfo;
  const bool left = found.status == Info::REMOVED_PARTICIPANT;
  const bool silent = found.status == Info::DROPPED_PARTICIPANT;
  if (left || silent) {
    put({ParticipantGone{text_of(found.info.m_guid.guidPrefix), silent}});
  } else {
    put({ParticipantSeen{participant_of(found.info),
                         found.status == Info::CHANGED_QOS_PARTICIPANT}});
  }
}

// Fast DDS tells a participant of its own endpoints, too.
void Sightings::on_publisher_discovery(dds::DomainParticipant* participant,
                                       rtps::WriterDiscoveryInfo&& found) {
  using Info = rtps::WriterDiscoveryInfo;
  if (found.info.guid().guidPrefix == participant->guid().guidPrefix) return;
  Endpoint endpoint = endpoint_of(found.info, true);
  const bool gone = found.status == Info::REMOVED_WRITER;
  {
    const std::lock_guard lock(mutex_);
    const auto& names = endpoint.partitions;
    if (gone) {
      partitions_.erase(endpoint.guid);
    } else {
      partitions_[endpoint.guid] = names.empty() ? "" : names.front();
    }
  }
  if (gone) {
    put({EndpointGone{endpoint.guid}});
  } else {
    put({EndpointSeen{std::move(endpoint), found.status == Info::CHANGED_QOS_WRITER}});
  }
}

void Sightings::on_subscriber_discovery(dds::DomainParticipant* participant,
                                        rtps::ReaderDiscoveryInfo&& found) {
  using Info = rtps::ReaderDiscoveryInfo;
  if (found.info.guid().guidPrefix == participant->guid().guidPrefix) return;
  Endpoint endpoint = endpoint_of(found.info, false);
  if (found.status == Info::REMOVED_READER) {
    put({EndpointGone{endpoint.guid}});
  } else {
    put({EndpointSeen{std::move(endpoint), found.status == Info::CHANGED_QOS_READER}});
  }
}

std::string Sightings::partition_of(const std::string& writer) const {
  const std::lock_guard lock(mutex_);
  const auto found = partitions_.find(writer);
  return found == partitions_.end() ? "" : found->second;
}

void Sightings::on_data_available(dds::DataReader* reader) {
  const std::string topic = reader->get_topicdescription()->get_name();
  std::vector<Sighting> seen;
  RawType::Sample bytes;
  dds::SampleInfo info;
  while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
    SampleSeen sample;
    sample.topic = topic;
    sample.writer = text_of(info.sample_identity.writer_guid());
    sample.partition = partition_of(sample.writer);
    sample.sent = std::max<std::int64_t>(info.source_timestamp.to_ns(), 0);
    sample.heard = wall_clock();
    sample.at = steady_clock();
    if (info.valid_data) sample.bytes = bytes;
    seen.emplace_back(std::move(sample));
  }
  if (!seen.empty()) put(std::move(seen));
}

}  // namespace skein::blackboard::fastdds
