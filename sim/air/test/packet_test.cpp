// SPDX-License-Identifier: Apache-2.0
#include "skein/air/packet.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace skein::air {
namespace {

std::vector<std::uint8_t> packet_to(std::uint32_t address) {
  std::vector<std::uint8_t> packet(24, 0);
  packet[0] = 0x45;
  packet[3] = 24;
  for (std::size_t i = 0; i < 4; ++i)
    packet[16 + i] = static_cast<std::uint8_t>(address >> (24 - 8 * i));
  return packet;
}

TEST(Packet, GoesToItsDestination) {
  EXPECT_EQ(route_of(packet_to(address_of(3))), (Route{address_of(3), false, false}));
}

TEST(Packet, GoesToEverybodyByMulticastAndBroadcast) {
  for (const std::uint32_t address : {0xefff0001U, 0xe0000001U, 0xffffffffU, 0x0a63ffffU})
    EXPECT_TRUE(route_of(packet_to(address))->everybody) << to_text(address);
}

TEST(Packet, IsAPieceWhereMoreFollowOrSomeCameBefore) {
  auto packet = packet_to(address_of(3));
  packet[6] = 0x40;
  EXPECT_FALSE(route_of(packet)->piece) << "must not be cut up";
  packet[6] = 0x20;
  EXPECT_TRUE(route_of(packet)->piece) << "the first";
  packet[6] = 0;
  packet[7] = 185;
  EXPECT_TRUE(route_of(packet)->piece) << "the last";
}

TEST(Packet, IsNoneWhenItIsCutOffOrOfAnotherProtocol) {
  auto packet = packet_to(address_of(0));
  EXPECT_FALSE(route_of(std::span(packet).first(19)).has_value());
  packet[3] = 25;
  EXPECT_FALSE(route_of(packet).has_value()) << "longer than it is";
  packet[3] = 19;
  EXPECT_FALSE(route_of(packet).has_value()) << "shorter than its header";
  packet = packet_to(address_of(0));
  packet[0] = 0x60;
  EXPECT_FALSE(route_of(packet).has_value()) << "IPv6";
  EXPECT_FALSE(route_of({}).has_value());
}

TEST(Addresses, AreThoseOfTheNodesAndNobodyElses) {
  EXPECT_EQ(to_text(address_of(0)), "10.99.0.1");
  EXPECT_EQ(to_text(address_of(255)), "10.99.1.0");
  for (const std::size_t node : {0U, 1U, 254U, 255U, 1000U})
    EXPECT_EQ(node_of(address_of(node)), node);
  EXPECT_FALSE(node_of(0x0a630000).has_value());
  EXPECT_FALSE(node_of(0x0a640001).has_value());
}

}  // namespace
}  // namespace skein::air
