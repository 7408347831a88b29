// SPDX-License-Identifier: Apache-2.0
// From which socket of Fast DDS a datagram leaves.
#include "adapters/fastdds/single_path.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <fastdds/rtps/common/LocatorList.hpp>

#include <optional>

namespace skein::blackboard::fastdds {
namespace {

namespace fastdds = eprosima::fastdds::rtps;
namespace fastrtps = eprosima::fastrtps::rtps;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

fastrtps::Locator_t udp(const std::string& address) {
  fastrtps::Locator_t locator(LOCATOR_KIND_UDPv4, 7410);
  fastrtps::IPLocator::setIPv4(locator, address);
  return locator;
}

/// A socket of that address, which notes where it is told to send to.
class Socket final : public fastrtps::SenderResource {
 public:
  explicit Socket(const std::string& address)
      : SenderResource(LOCATOR_KIND_UDPv4), address_(address) {
    send_lambda_ = [this](const fastrtps::octet*, std::uint32_t size, fastdds::LocatorsIterator* it,
                          fastdds::LocatorsIterator* end, const auto&) {
      sizes.push_back(size);
      for (; *it != *end; ++*it) sent.push_back(fastrtps::IPLocator::toIPv4string(**it));
      return works;
    };
  }
  void add_locators_to_list(fastrtps::LocatorList_t& locators) const override {
    if (!address_.empty()) locators.push_back(udp(address_));
  }
  std::vector<std::string> sent;
  std::vector<std::uint32_t> sizes;  ///< of the datagrams [byte]
  bool works = true;

 private:
  std::string address_;
};

/// A board with a cable and a radio.
class Board : public ::testing::Test {
 protected:
  static std::optional<rtps::Address> route(rtps::Address to) {
    const bool radio = to >> 16U == 0x0a63;
    return rtps::parse_ipv4(radio ? "10.99.0.2" : "10.98.0.3");
  }
  bool send(const std::vector<std::string>& addresses) {
    fastrtps::LocatorList_t list;
    for (const std::string& address : addresses) list.push_back(udp(address));
    bool sent = true;
    for (Socket* socket : {&cable, &radio}) {
      fastdds::Locators begin(list.begin()), end(list.end());
      sent = transport.send(socket, nullptr, 0, &begin, &end, {}) && sent;
    }
    return sent;
  }

  SinglePathDescriptor descriptor{std::make_shared<fastdds::UDPv4TransportDescriptor>(),
                                  {"10.98.0.3", "10.99.0.2"}};
  SinglePath transport{descriptor, rtps::SourceAddresses(descriptor.own, route)};
  Socket cable{"10.98.0.3"}, radio{"10.99.0.2"};
};

TEST_F(Board, SaysItOnceToEach) {
  EXPECT_TRUE(send({"10.99.0.1", "10.98.0.1", "10.99.0.4"}));
  EXPECT_THAT(radio.sent, ElementsAre("10.99.0.1", "10.99.0.4"));
  EXPECT_THAT(cable.sent, ElementsAre("10.98.0.1"));
}

TEST_F(Board, SpeaksToAGroupEverywhere) {
  EXPECT_TRUE(send({"239.255.0.1"}));
  EXPECT_THAT(radio.sent, ElementsAre("239.255.0.1"));
  EXPECT_THAT(cable.sent, ElementsAre("239.255.0.1"));
}

TEST_F(Board, SaysWhatASocketSaidOfItsSending) {
  radio.works = false;
  EXPECT_FALSE(send({"10.99.0.1"}));
  EXPECT_TRUE(send({"10.98.0.1"})) << "nothing was for the radio";
}

TEST_F(Board, ASocketThatIsBoundToNoneSendsAll) {
  Socket unbound("");
  fastrtps::LocatorList_t list;
  list.push_back(udp("10.99.0.1"));
  fastdds::Locators begin(list.begin()), end(list.end());
  EXPECT_TRUE(transport.send(&unbound, nullptr, 0, &begin, &end, {}));
  EXPECT_THAT(unbound.sent, ElementsAre("10.99.0.1"));
}

// With keys, where Fast DDS cannot be told: three packets of ten that are lost would lose it all.
TEST(SinglePath, TakesApartWhatDoesNotFitIntoAPacketThoughFastDdsIsNotTold) {
  const SinglePathDescriptor descriptor(std::make_shared<fastdds::UDPv4TransportDescriptor>(),
                                        {"10.99.0.2"}, 1'472, false);
  SinglePath transport(descriptor, rtps::SourceAddresses(descriptor.own));
  Socket unbound("");
  std::vector<fastrtps::octet> message{'R', 'T', 'P', 'S'};
  message.resize(20);
  for (int i = 0; i < 3; ++i) {  // DATA of 1,000 bytes
    message.insert(message.end(), {0x15, 1, 0xe8, 0x03});
    message.resize(message.size() + 1'000);
  }
  fastrtps::LocatorList_t list;
  list.push_back(udp("10.99.0.1"));
  fastdds::Locators begin(list.begin()), end(list.end());

  EXPECT_TRUE(transport.send(&unbound, message.data(), static_cast<std::uint32_t>(message.size()),
                             &begin, &end, {}));

  EXPECT_GE(descriptor.max_message_size(), 65'000U);
  EXPECT_THAT(unbound.sizes, ElementsAre(1'024, 1'024, 1'024));
  EXPECT_THAT(unbound.sent, ElementsAre("10.99.0.1", "10.99.0.1", "10.99.0.1"));
}

TEST_F(Board, KnowsItsOwnAddresses) {
  EXPECT_THAT(descriptor.own, ElementsAre(0x0a620003U, 0x0a630002U));
}

}  // namespace
}  // namespace skein::blackboard::fastdds
