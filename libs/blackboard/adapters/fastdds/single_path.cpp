// SPDX-License-Identifier: Apache-2.0
// UDP from several addresses, over one way to each destination.
#include "single_path.hpp"

#include <fastrtps/utils/IPLocator.h>
#include <fastdds/rtps/common/LocatorList.hpp>

#include <optional>
#include <utility>

namespace skein::blackboard::fastdds {
namespace {

namespace fastdds = eprosima::fastdds::rtps;
namespace fastrtps = eprosima::fastrtps::rtps;

rtps::Address address_of(const fastrtps::Locator_t& locator) {
  rtps::Address address = 0;
  for (unsigned i = 12; i < 16; ++i) address = address << 8U | locator.address[i];
  return address;
}

/// The one that the socket is bound to.
std::optional<rtps::Address> address_of(const fastrtps::SenderResource& socket) {
  fastrtps::LocatorList_t locators;
  socket.add_locators_to_list(locators);
  if (locators.size() != 1) return std::nullopt;
  return address_of(*locators.begin());
}

}  // namespace

SinglePathDescriptor::SinglePathDescriptor(
    std::shared_ptr<fastdds::TransportDescriptorInterface> udp,
    const std::vector<std::string>& addresses, std::uint32_t longest)
    : ChainingTransportDescriptor(std::move(udp)) {
  maxMessageSize = longest;
  for (const std::string& text : addresses)
    if (const auto address = rtps::parse_ipv4(text)) own.push_back(*address);
}

fastdds::TransportInterface* SinglePathDescriptor::create_transport() const {
  return new SinglePath(*this, rtps::SourceAddresses(own));
}

SinglePath::SinglePath(const SinglePathDescriptor& descriptor, rtps::SourceAddresses sources)
    : ChainingTransport(descriptor), sources_(std::move(sources)) {}

fastdds::TransportDescriptorInterface* SinglePath::get_configuration() {
  return low_level_transport_->get_configuration();
}

bool SinglePath::OpenInputChannel(const fastrtps::Locator_t& locator,
                                  fastdds::TransportReceiverInterface* receiver,
                                  std::uint32_t /*longest*/) {
  return ChainingTransport::OpenInputChannel(locator, receiver, rtps::kLongestDatagram);
}

bool SinglePath::send(fastrtps::SenderResource* socket, const fastrtps::octet* bytes,
                      std::uint32_t size, fastdds::LocatorsIterator* begin,
                      fastdds::LocatorsIterator* end,
                      const std::chrono::steady_clock::time_point& until) {
  const auto source = address_of(*socket);
  if (!source) return socket->send(bytes, size, begin, end, until);
  fastrtps::LocatorList_t chosen;
  {
    const std::lock_guard lock(mutex_);
    const auto now = rtps::SourceAddresses::Clock::now();
    for (fastdds::LocatorsIterator& it = *begin; it != *end; ++it) {
      const bool is_group = fastrtps::IPLocator::isMulticast(*it);
      if (is_group || sources_.is_for(*source, address_of(*it), now)) chosen.push_back(*it);
    }
  }
  if (chosen.empty()) return true;
  fastdds::Locators first(chosen.begin()), last(chosen.end());
  return socket->send(bytes, size, &first, &last, until);
}

void SinglePath::receive(fastdds::TransportReceiverInterface* next, const fastrtps::octet* bytes,
                         std::uint32_t size, const fastrtps::Locator_t& local,
                         const fastrtps::Locator_t& remote) {
  next->OnDataReceived(bytes, size, local, remote);
}

}  // namespace skein::blackboard::fastdds
