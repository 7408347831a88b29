// SPDX-License-Identifier: Apache-2.0
// The delivery classes as QoS of Fast DDS.
#include "qos.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <algorithm>
#include <array>

#include "adapters/rtps/datagram_size.hpp"
#include "adapters/rtps/kept_samples.hpp"
#include "adapters/rtps/ports.hpp"
#include "departure_filter.hpp"
#include "single_path.hpp"
#include "skein/blackboard/program_description.hpp"

namespace skein::blackboard::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace fastrtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

constexpr std::uint32_t kSocketBuffer = 2 * 1024 * 1024;
constexpr const char* kMulticastAddress = "239.255.0.1";  // of RTPS discovery
/// Of the discovery server with id 0; the third byte is the id. Source: Fast DDS 2.9, 4.1.5.
constexpr std::array<std::uint8_t, 12> kServer{0x44, 0x53, 0x00, 0x5f, 0x45, 0x50,
                                               0x52, 0x4f, 0x53, 0x49, 0x4d, 0x41};

Duration_t milliseconds(std::uint32_t ms) {
  return {static_cast<std::int32_t>(ms / 1000), ms % 1000 * 1'000'000};
}
Duration_t duration_of(std::chrono::milliseconds ms) {
  return milliseconds(static_cast<std::uint32_t>(ms.count()));
}

int depth(wire::Slot slot, ChannelKind kind) {
  if (wire::slot_class(slot) != wire::SlotClass::kEvent) return 1;
  return static_cast<int>(kind == ChannelKind::kWorld ? kWorldEventDepth : kEventDepth);
}

/// What writer and reader must agree on, and that no limit refuses a new instance.
template <class Qos>
void set_class(Qos& qos, wire::Slot slot, ChannelKind kind) {
  const bool stream = wire::slot_class(slot) == wire::SlotClass::kStream;
  qos.reliability().kind =
      stream ? dds::BEST_EFFORT_RELIABILITY_QOS : dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind =
      stream ? dds::VOLATILE_DURABILITY_QOS : dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth(slot, kind);
  qos.resource_limits().max_samples = 0;
  qos.resource_limits().max_instances = 0;
  qos.resource_limits().max_samples_per_instance = 0;
  qos.resource_limits().allocated_samples = 1;
  qos.endpoint().history_memory_policy = fastrtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.data_sharing().off();
}

fastrtps::Locator_t udp(const std::string& address, unsigned port) {
  fastrtps::Locator_t locator(LOCATOR_KIND_UDPv4, port);
  fastrtps::IPLocator::setIPv4(locator, address);
  return locator;
}

/// Ports of our own choice: Fast DDS would number participants up for ever within a process, and
/// discovery by unicast needs small numbers.
void set_locators(dds::WireProtocolConfigQos& protocol, const DdsConfig& config,
                  std::uint32_t number) {
  fastrtps::BuiltinAttributes& builtin = protocol.builtin;
  const unsigned own = rtps::first_port(config.domain, number);
  for (const std::string& address : config.network.interfaces) {
    builtin.metatrafficUnicastLocatorList.push_back(udp(address, own));
    protocol.default_unicast_locator_list.push_back(udp(address, own + 1));
  }
  if (!config.network.discovery_servers.empty()) return;
  if (config.network.multicast) {
    const fastrtps::Locator_t everybody = udp(kMulticastAddress, rtps::first_port(config.domain));
    builtin.metatrafficMulticastLocatorList.push_back(everybody);
    builtin.initialPeersList.push_back(everybody);
  }
  // At least one, since of an empty list Fast DDS would make multicast.
  for (const NetworkAddress& place : rtps::places_to_look(config.network, config.domain)) {
    builtin.initialPeersList.push_back(udp(place.address, place.port));
  }
}

/// Everybody is found through these alone.
void set_servers(fastrtps::BuiltinAttributes& builtin, const std::vector<std::string>& servers) {
  if (servers.empty()) return;
  auto& discovery = builtin.discovery_config;
  discovery.discoveryProtocol = fastrtps::DiscoveryProtocol_t::CLIENT;
  for (std::size_t id = 0; id < servers.size(); ++id) {
    const auto address = parse_address(servers[id]);
    if (!address) continue;  // refused before
    fastrtps::RemoteServerAttributes server;
    std::copy(kServer.begin(), kServer.end(), std::begin(server.guidPrefix.value));
    server.guidPrefix.value[2] = static_cast<fastrtps::octet>(id);
    server.metatrafficUnicastLocatorList.push_back(udp(address->address, address->port));
    discovery.m_DiscoveryServers.push_back(server);
  }
}

}  // namespace

dds::DomainParticipantQos participant_qos(const DdsConfig& config, std::uint32_t number,
                                          const rtps::Pace& pace, Departures departures) {
  dds::DomainParticipantQos qos;
  qos.name(config.participant_name);
  const std::string description = to_text(program_description(config.scenario));
  qos.user_data().data_vec({description.begin(), description.end()});
  auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  transport->sendBufferSize = kSocketBuffer;
  transport->receiveBufferSize = kSocketBuffer;
  transport->interfaceWhiteList = config.network.interfaces;
  // Fast DDS says all that a reader lacks in one message, which is lost as a whole: on a radio that
  // loses three packets of ten the more there is to say again, the less of it comes.
  // With keys it is not told: the messages of Fast DDS 2.9's handshake, certificates, do not go in
  // parts, and no handshake would end.
  const bool secured = !config.network.keys.empty();
  const std::uint32_t longest = rtps::longest_datagram(config.network.interfaces);
  qos.transport().use_builtin_transports = false;
  if (config.network.interfaces.size() > 1 || longest < rtps::kLongestDatagram) {
    qos.transport().user_transports.push_back(std::make_shared<SinglePathDescriptor>(
        transport, config.network.interfaces, longest, !secured));
  } else {
    qos.transport().user_transports.push_back(transport);
  }
  if (departures == Departures::kLeftToTheLease && !secured &&
      config.network.discovery_servers.empty()) {
    auto& used = qos.transport().user_transports.back();
    used = std::make_shared<DepartureFilterDescriptor>(used);
  }
  auto& builtin = qos.wire_protocol().builtin;
  // A participant that falls silent is taken for gone after its lease. Where it then comes back,
  // the two begin their handshake anew on one side only, and Fast DDS 2.9 never ends it: with keys
  // a loaded machine must not look like a dead one. Who is out of reach is told by heartbeats.
  const std::chrono::milliseconds lease =
      secured ? std::max(pace.lease, std::chrono::milliseconds(60'000)) : pace.lease;
  builtin.discovery_config.leaseDuration = duration_of(lease);
  builtin.discovery_config.leaseDuration_announcementperiod = duration_of(pace.announcement);
  set_locators(qos.wire_protocol(), config, number);
  set_servers(builtin, config.network.discovery_servers);
  return qos;
}

dds::DataWriterQos writer_qos(wire::Slot slot, ChannelKind kind, const rtps::Pace& pace) {
  dds::DataWriterQos qos;
  set_class(qos, slot, kind);
  qos.reliability().max_blocking_time = milliseconds(100);
  auto& times = qos.reliable_writer_qos().times;
  times.heartbeatPeriod = duration_of(pace.heartbeat);
  times.nackResponseDelay = milliseconds(1);
  // On the writer's side only: a reader would compare the clocks of two machines.
  if (wire::slot_class(slot) == wire::SlotClass::kEvent && kind != ChannelKind::kWorld) {
    qos.lifespan().duration = {static_cast<std::int32_t>(rtps::kEventLifespan.count()), 0};
  }
  return qos;
}

dds::DataReaderQos reader_qos(wire::Slot slot, ChannelKind kind) {
  dds::DataReaderQos qos;
  set_class(qos, slot, kind);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = milliseconds(1);
  return qos;
}

}  // namespace skein::blackboard::fastdds
