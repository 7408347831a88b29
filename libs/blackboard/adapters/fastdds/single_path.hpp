// SPDX-License-Identifier: Apache-2.0
// UDP from several addresses, over one way to each destination.
#pragma once

#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "adapters/rtps/datagram_size.hpp"
#include "adapters/rtps/source_addresses.hpp"

namespace skein::blackboard::fastdds {

/// Fast DDS has a socket for each interface that it may use, and sends each datagram to each
/// destination from all of them: whatever the routes, a machine with a radio and a cable sends all
/// twice over its radio. Here a unicast datagram leaves from the address that the system's routes
/// choose; a multicast datagram leaves from all. Source: Fast DDS 2.9, UDPTransportInterface.
///
/// Outgoing datagrams are bounded by the configured length; incoming ones may be longer (Cyclone
/// DDS: 14,720 bytes). Fast DDS has one number for both. With keys Fast DDS must not know the
/// bound, since it does not send the messages of its handshakes in parts; then longer messages are
/// divided here.
struct SinglePathDescriptor : eprosima::fastdds::rtps::ChainingTransportDescriptor {
  /// `addresses`: those of the interfaces that `udp` may use; `longest`: of what is sent [byte],
  /// and whether Fast DDS is to know it.
  SinglePathDescriptor(std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> udp,
                       const std::vector<std::string>& addresses,
                       std::uint32_t longest = rtps::kLongestDatagram, bool is_told = true);
  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;
  std::uint32_t max_message_size() const override { return maxMessageSize; }

  std::vector<rtps::Address> own;
  std::uint32_t longest;  ///< [byte] of a message; a longer one is taken apart
};

class SinglePath final : public eprosima::fastdds::rtps::ChainingTransport {
 public:
  SinglePath(const SinglePathDescriptor& descriptor, rtps::SourceAddresses sources);

  eprosima::fastdds::rtps::TransportDescriptorInterface* get_configuration() override;
  bool OpenInputChannel(const eprosima::fastrtps::rtps::Locator_t& locator,
                        eprosima::fastdds::rtps::TransportReceiverInterface* receiver,
                        std::uint32_t longest) override;
  bool send(eprosima::fastrtps::rtps::SenderResource* socket,
            const eprosima::fastrtps::rtps::octet* bytes, std::uint32_t size,
            eprosima::fastdds::rtps::LocatorsIterator* begin,
            eprosima::fastdds::rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& until) override;
  void receive(eprosima::fastdds::rtps::TransportReceiverInterface* next,
               const eprosima::fastrtps::rtps::octet* bytes, std::uint32_t size,
               const eprosima::fastrtps::rtps::Locator_t& local,
               const eprosima::fastrtps::rtps::Locator_t& remote) override;

 private:
  /// Whether what goes there leaves from this address; none: from any.
  bool is_for(std::optional<rtps::Address> source,
              const eprosima::fastrtps::rtps::Locator_t& destination);

  std::uint32_t longest_;
  std::mutex mutex_;
  rtps::SourceAddresses sources_;
};

}  // namespace skein::blackboard::fastdds
