// SPDX-License-Identifier: Apache-2.0
#include "adapters/rtps/source_addresses.hpp"

#include <gtest/gtest.h>

#include <map>

namespace skein::blackboard::rtps {
namespace {

using Clock = SourceAddresses::Clock;

Address ipv4(const std::string& text) { return parse_ipv4(text).value(); }

const Address kCable = ipv4("10.98.0.3"), kRadio = ipv4("10.99.0.2");
const Address kGround = ipv4("10.99.0.1"), kAutopilot = ipv4("10.98.0.1");

/// A machine with a cable and a radio, and routes that change.
class Machine : public ::testing::Test {
 protected:
  Machine() {
    routes[kGround] = kRadio;
    routes[kAutopilot] = kCable;
  }
  std::map<Address, Address> routes;
  int asked = 0;
  Clock::time_point now;
  SourceAddresses sources{{kCable, kRadio}, [this](Address to) -> std::optional<Address> {
                            ++asked;
                            const auto found = routes.find(to);
                            if (found == routes.end()) return std::nullopt;
                            return found->second;
                          }};
};

TEST_F(Machine, SpeaksToEachFromTheAddressOfTheWayThere) {
  EXPECT_TRUE(sources.is_for(kRadio, kGround, now));
  EXPECT_FALSE(sources.is_for(kCable, kGround, now));
  EXPECT_TRUE(sources.is_for(kCable, kAutopilot, now));
  EXPECT_FALSE(sources.is_for(kRadio, kAutopilot, now));
  EXPECT_EQ(asked, 2);
}

TEST_F(Machine, SpeaksFromEachWhereNoWayIsKnown) {
  const Address nowhere = ipv4("192.0.2.1");
  EXPECT_TRUE(sources.is_for(kRadio, nowhere, now));
  EXPECT_TRUE(sources.is_for(kCable, nowhere, now));
}

TEST_F(Machine, SpeaksFromEachWhereTheSystemWouldChooseAnAddressThatIsNotToBeUsed) {
  routes[kGround] = ipv4("172.16.0.1");
  EXPECT_TRUE(sources.is_for(kRadio, kGround, now));
  EXPECT_TRUE(sources.is_for(kCable, kGround, now));
}

TEST_F(Machine, FollowsRoutesThatChange) {
  EXPECT_TRUE(sources.is_for(kRadio, kGround, now));
  routes[kGround] = kCable;
  EXPECT_TRUE(sources.is_for(kRadio, kGround, now + std::chrono::seconds(1)));
  EXPECT_FALSE(sources.is_for(kRadio, kGround, now + SourceAddresses::kAskedAgain));
  EXPECT_TRUE(sources.is_for(kCable, kGround, now + SourceAddresses::kAskedAgain));
}

TEST_F(Machine, AsksAnewRatherThanRememberWithoutEnd) {
  for (Address to = 1; to <= 5'000; ++to) sources.is_for(kRadio, to, now);
  EXPECT_EQ(asked, 5'000);
  EXPECT_TRUE(sources.is_for(kRadio, kGround, now));
}

TEST(SourceAddresses, TheSystemSpeaksToItselfFromWhereItIsSpokenTo) {
  SourceAddresses sources({ipv4("127.0.0.1"), kRadio});
  EXPECT_TRUE(sources.is_for(ipv4("127.0.0.1"), ipv4("127.0.0.1"), {}));
  EXPECT_FALSE(sources.is_for(kRadio, ipv4("127.0.0.1"), {}));
}

TEST(SourceAddresses, AreReadAndWritten) {
  EXPECT_EQ(to_text(ipv4("10.99.0.2")), "10.99.0.2");
  EXPECT_EQ(ipv4("0.0.1.2"), 258U);
  for (const char* text : {"", "10.99.0", "10.99.0.256", "ground", "::1"})
    EXPECT_FALSE(parse_ipv4(text).has_value()) << text;
}

}  // namespace
}  // namespace skein::blackboard::rtps
