// SPDX-License-Identifier: Apache-2.0
// UDP from several addresses, over one way to each destination.
#include "single_path.hpp"

#include <fastrtps/utils/IPLocator.h>
#include <fastdds/rtps/common/LocatorList.hpp>

#include <optional>
#include <utility>

#include "adapters/rtps/message_pieces.hpp"

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
    const std::vector<std::string>& addresses, std::uint32_t at_most, bool is_told)
    : ChainingTransportDescriptor(std::move(udp)), longest(at_most) {
  maxMessageSize = is_told ? at_most : rtps::kLongestDatagram;
  for (const std::string& text : addresses)
    if (const auto address = rtps::parse_ipv4(text)) own.push_back(*address);
}

fastdds::TransportInterface* SinglePathDescriptor::create_transport() const {
  return new SinglePath(*this, rtps::SourceAddresses(own));
}

SinglePath::SinglePath(const SinglePathDescriptor& descriptor, rtps::SourceAddresses sources)
    : ChainingTransport(descriptor), longest_(descriptor.longest), sources_(std::move(sources)) {}

fastdds::TransportDescriptorInterface* SinglePath::get_configuration() {
  return low_level_transport_->get_configuration();
}

bool SinglePath::OpenInputChannel(const fastrtps::Locator_t& locator,
                                  fastdds::TransportReceiverInterface* receiver,
                                  std::uint32_t /*longest*/) {
  return ChainingTransport::OpenInputChannel(locator, receiver, rtps::kLongestDatagram);
}

bool SinglePath::is_for(std::optional<rtps::Address> source,
                        const fastrtps::Locator_t& destination) {
  if (!source || fastrtps::IPLocator::isMulticast(destination)) return true;
  const std::lock_guard lock(mutex_);
  return sources_.is_for(*source, address_of(destination), rtps::SourceAddresses::Clock::now());
}

bool SinglePath::send(fastrtps::SenderResource* socket, const fastrtps::octet* bytes,
                      std::uint32_t size, fastdds::LocatorsIterator* begin,
                      fastdds::LocatorsIterator* end,
                      const std::chrono::steady_clock::time_point& until) {
  const auto source = address_of(*socket);
  fastrtps::LocatorList_t chosen;
  for (fastdds::LocatorsIterator& it = *begin; it != *end; ++it)
    if (is_for(source, *it)) chosen.push_back(*it);
  if (chosen.empty()) return true;
  const auto say = [&](const fastrtps::octet* what, std::size_t length) {
    fastdds::Locators first(chosen.begin()), last(chosen.end());
    return socket->send(what, static_cast<std::uint32_t>(length), &first, &last, until);
  };
  const auto pieces = rtps::pieces_of({bytes, size}, longest_);
  if (pieces.empty()) return say(bytes, size);
  bool sent = true;
  for (const auto& piece : pieces) sent = say(piece.data(), piece.size()) && sent;
  return sent;
}

void SinglePath::receive(fastdds::TransportReceiverInterface* next, const fastrtps::octet* bytes,
                         std::uint32_t size, const fastrtps::Locator_t& local,
                         const fastrtps::Locator_t& remote) {
  next->OnDataReceived(bytes, size, local, remote);
}

}  // namespace skein::blackboard::fastdds
