// SPDX-License-Identifier: Apache-2.0
#include "departure_filter.hpp"

#include "adapters/rtps/departures.hpp"

namespace skein::blackboard::fastdds {

namespace fastdds = eprosima::fastdds::rtps;
namespace fastrtps = eprosima::fastrtps::rtps;

fastdds::TransportInterface* DepartureFilterDescriptor::create_transport() const {
  return new DepartureFilter(*this);
}

fastdds::TransportDescriptorInterface* DepartureFilter::get_configuration() {
  return low_level_transport_->get_configuration();
}

bool DepartureFilter::send(fastrtps::SenderResource* socket, const fastrtps::octet* bytes,
                           std::uint32_t size, fastdds::LocatorsIterator* begin,
                           fastdds::LocatorsIterator* end,
                           const std::chrono::steady_clock::time_point& until) {
  return socket->send(bytes, size, begin, end, until);
}

void DepartureFilter::receive(fastdds::TransportReceiverInterface* next,
                              const fastrtps::octet* bytes, std::uint32_t size,
                              const fastrtps::Locator_t& local, const fastrtps::Locator_t& remote) {
  if (!rtps::tells_departure({bytes, size})) next->OnDataReceived(bytes, size, local, remote);
}

}  // namespace skein::blackboard::fastdds
