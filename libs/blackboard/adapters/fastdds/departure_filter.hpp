// SPDX-License-Identifier: Apache-2.0
// A transport over which nobody is heard to leave.
#pragma once

#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>

#include <memory>

namespace skein::blackboard::fastdds {

/// Withholds messages by which participants say that they leave: they are gone when their leases
/// end. Fast DDS 2.9 looks at leases in one thread and hears of departures in another, and aborts
/// the process where both come to the same participant at once (assertion in
/// PDP::check_remote_participant_liveliness). Leases end in the first thread alone.
struct DepartureFilterDescriptor : eprosima::fastdds::rtps::ChainingTransportDescriptor {
  using ChainingTransportDescriptor::ChainingTransportDescriptor;
  eprosima::fastdds::rtps::TransportInterface* create_transport() const override;
};

class DepartureFilter final : public eprosima::fastdds::rtps::ChainingTransport {
 public:
  using ChainingTransport::ChainingTransport;

  eprosima::fastdds::rtps::TransportDescriptorInterface* get_configuration() override;
  bool send(eprosima::fastrtps::rtps::SenderResource* socket,
            const eprosima::fastrtps::rtps::octet* bytes, std::uint32_t size,
            eprosima::fastdds::rtps::LocatorsIterator* begin,
            eprosima::fastdds::rtps::LocatorsIterator* end,
            const std::chrono::steady_clock::time_point& until) override;
  void receive(eprosima::fastdds::rtps::TransportReceiverInterface* next,
               const eprosima::fastrtps::rtps::octet* bytes, std::uint32_t size,
               const eprosima::fastrtps::rtps::Locator_t& local,
               const eprosima::fastrtps::rtps::Locator_t& remote) override;
};

}  // namespace skein::blackboard::fastdds
