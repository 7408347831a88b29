// SPDX-License-Identifier: Apache-2.0
#include "testing/discovery_server.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>

#include <sstream>
#include <stdexcept>

#include "adapters/rtps/ports.hpp"

namespace skein::blackboard::testing {

namespace dds = eprosima::fastdds::dds;
namespace fastrtps = eprosima::fastrtps::rtps;

namespace {

constexpr unsigned kPort = 200;  ///< above the first of its domain

dds::DomainParticipantQos server_qos(unsigned port) {
  dds::DomainParticipantQos qos;
  qos.name("server");
  qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {rtps::kLoopback};
  qos.transport().user_transports.push_back(udp);
  auto& protocol = qos.wire_protocol();
  protocol.builtin.discovery_config.discoveryProtocol = fastrtps::DiscoveryProtocol_t::SERVER;
  std::istringstream("44.53.00.5f.45.50.52.4f.53.49.4d.41") >> protocol.prefix;  // of id 0
  fastrtps::Locator_t locator(LOCATOR_KIND_UDPv4, port);
  fastrtps::IPLocator::setIPv4(locator, rtps::kLoopback);
  protocol.builtin.metatrafficUnicastLocatorList.push_back(locator);
  return qos;
}

}  // namespace

class DiscoveryServer::Impl {
 public:
  Impl(std::uint32_t domain, unsigned port)
      : participant_(factory().create_participant(domain, server_qos(port), nullptr,
                                                  dds::StatusMask::none())) {
    if (participant_ == nullptr) throw std::runtime_error("no discovery server");
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { factory().delete_participant(participant_); }

 private:
  static dds::DomainParticipantFactory& factory() {
    return *dds::DomainParticipantFactory::get_instance();
  }
  dds::DomainParticipant* participant_;
};

DiscoveryServer::DiscoveryServer(std::uint32_t domain)
    : address_(std::string(rtps::kLoopback) + ":" +
               std::to_string(rtps::first_port(domain) + kPort)),
      impl_(std::make_unique<Impl>(domain, rtps::first_port(domain) + kPort)) {}

DiscoveryServer::~DiscoveryServer() = default;

}  // namespace skein::blackboard::testing
