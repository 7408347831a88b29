// SPDX-License-Identifier: Apache-2.0
// The headers of what a node says.
#include "signature.hpp"

#include <gtest/gtest.h>

namespace skein::blackboard {
namespace {

const Node kSigner{NodeNumber(1), "ground"}, kReader{NodeNumber(2), "heliv"};
const Now kSignedAt{MissionTime::seconds(7), Duration::seconds(40)};

/// Of the ground in incarnation 100, with heliv as its peer.
class SignatureOfTheGround : public ::testing::Test {
 protected:
  static Config ground() {
    Config config;
    config.self = kSigner.number;
    config.incarnation = 100;
    config.mission = 5;
    config.channels = radio_link(kSigner, kReader);
    return config;
  }

  Config config = ground();
  Session none{config};
  Peer heliv{{kReader.number, ChannelKind::kRadio, 0, 1}, config, none};
  Signature signature{config};
};

TEST_F(SignatureOfTheGround, SaysWhoSaysItToWhomAndWhen) {
  wire::SampleHeader header;
  header.expires = 3;

  EXPECT_EQ(signature.sign(header, heliv, kSignedAt), 1U);

  EXPECT_EQ(header.origin, 1U);
  EXPECT_EQ(header.destination, 2U);
  EXPECT_EQ(header.incarnation, 100U);
  EXPECT_EQ(header.sequence_number, 1U);
  EXPECT_EQ(header.mission, 5U);
  EXPECT_EQ(header.mission_time, MissionTime::seconds(7).count());
  EXPECT_EQ(header.expires, wire::kNever);
}

TEST_F(SignatureOfTheGround, NumbersRiseWhoeverIsToHaveIt) {
  wire::SampleHeader header;

  EXPECT_EQ(signature.sign(header, heliv, kSignedAt), 1U);
  EXPECT_EQ(signature.sign_published(header, kSignedAt), 2U);
  EXPECT_EQ(header.destination, kEverybody.value());
  EXPECT_EQ(signature.sign(header, heliv, kSignedAt), 3U);
  EXPECT_EQ(signature.last_number(), 3U);
}

TEST_F(SignatureOfTheGround, ALaterLifeNumbersFromWhereNoFormerOneCame) {
  config.life = 2;
  Signature later(config);
  wire::SampleHeader header;

  EXPECT_EQ(later.sign(header, heliv, kSignedAt), (std::uint64_t{2} << 40U) + 1);
}

TEST_F(SignatureOfTheGround, EventsAndPublishedHeartbeatsTakeNoNumberFromOthers) {
  wire::Sample event = wire::TaskEvent();
  wire::Heartbeat heartbeat;
  signature.sign_event(event, heliv, MissionTime::seconds(9), kSignedAt);
  heliv.session().hold(event, 0);
  signature.sign_event(event, heliv, MissionTime::max(), kSignedAt);
  signature.sign_published(heartbeat.header, 77, kSignedAt);
  wire::SampleHeader header;

  EXPECT_EQ(wire::header_of(event).sequence_number, 2U);
  EXPECT_EQ(heartbeat.header.sequence_number, 77U);
  EXPECT_EQ(signature.sign(header, heliv, kSignedAt), 1U);
}

TEST_F(SignatureOfTheGround, AnEventExpiresAsItsSenderSaysIfItsSlotDoesNotSooner) {
  config.lifespans[static_cast<std::size_t>(wire::Slot::kTaskEvent)] = Duration::seconds(10);
  wire::Sample soon = wire::TaskEvent(), late = wire::TaskEvent();
  signature.sign_event(soon, heliv, MissionTime::seconds(9), kSignedAt);
  signature.sign_event(late, heliv, MissionTime::max(), kSignedAt);

  EXPECT_EQ(wire::header_of(soon).expires, MissionTime::seconds(9).count());
  EXPECT_EQ(wire::header_of(late).expires, MissionTime::seconds(17).count());
}

TEST_F(SignatureOfTheGround, EachPeerHasItsIncarnationAndEverybodyTheGreatest) {
  wire::SampleHeader to_heliv, to_all;
  EXPECT_TRUE(signature.become(120));
  EXPECT_FALSE(signature.become(110));
  signature.sign(to_heliv, heliv, kSignedAt);
  signature.sign_published(to_all, kSignedAt);
  EXPECT_EQ(to_heliv.incarnation, 100U);
  EXPECT_EQ(to_all.incarnation, 120U);

  heliv.become(110, {});
  signature.sign(to_heliv, heliv, kSignedAt);
  EXPECT_EQ(to_heliv.incarnation, 110U);
}

TEST_F(SignatureOfTheGround, WhatIsSaidAgainHasTheTimeWhenItWasSaidFirst) {
  wire::SampleHeader header;
  signature.sign(header, heliv, kSignedAt);
  signature.renew(header, 120);

  EXPECT_EQ(header.incarnation, 120U);
  EXPECT_EQ(header.sequence_number, 2U);
  EXPECT_EQ(header.mission_time, MissionTime::seconds(7).count());
}

}  // namespace
}  // namespace skein::blackboard
