// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/datagram_size.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace skein::blackboard::rtps {
namespace {

/// A machine whose interfaces carry so much in a packet.
PacketSizeOf machine(std::map<std::string, std::uint32_t> sizes) {
  return [sizes = std::move(sizes)](const std::string& address) -> std::optional<std::uint32_t> {
    const auto found = sizes.find(address);
    if (found == sizes.end()) return std::nullopt;
    return found->second;
  };
}

TEST(DatagramSize, IsWhatTheNarrowestInterfaceCarriesInAPacket) {
  const auto sizes = machine({{"127.0.0.1", 65'536}, {"10.0.0.1", 1500}, {"10.1.0.1", 1400}});
  EXPECT_EQ(longest_datagram({"10.0.0.1"}, sizes), 1472U) << "a packet's less 28 bytes";
  EXPECT_EQ(longest_datagram({"127.0.0.1", "10.0.0.1", "10.1.0.1"}, sizes), 1372U);
  EXPECT_EQ(longest_datagram({"127.0.0.1"}, sizes), kLongestDatagram);
}

TEST(DatagramSize, IsTheLongestWhereNoInterfaceHasTheAddress) {
  EXPECT_EQ(longest_datagram({"10.9.9.9", "no address"}), kLongestDatagram);
  EXPECT_EQ(longest_datagram({}), kLongestDatagram);
}

TEST(DatagramSize, OfThisMachineIsWhatItsKernelSays) {
  std::uint32_t loopback = 0;
  ASSERT_TRUE(std::ifstream("/sys/class/net/lo/mtu") >> loopback);
  EXPECT_EQ(longest_datagram({"127.0.0.1"}),
            std::clamp(loopback - 28, kShortestDatagram, kLongestDatagram));
}

RC_GTEST_PROP(DatagramSize, LeavesRoomForASubmessageWhateverAnInterfaceSays, (std::uint32_t size)) {
  const std::uint32_t longest = longest_datagram({"10.0.0.1"}, machine({{"10.0.0.1", size}}));
  RC_ASSERT(longest >= kShortestDatagram);
  RC_ASSERT(longest <= kLongestDatagram);
}

}  // namespace
}  // namespace skein::blackboard::rtps
