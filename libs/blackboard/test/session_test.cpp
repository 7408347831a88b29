// SPDX-License-Identifier: Apache-2.0
// What has passed with one peer: short and long events side by side.
#include "sessions/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;

constexpr bool kShort = false, kLong = true;
class SessionOfAStation : public ::testing::Test {
 protected:
  SessionOfAStation() {
    config.self = NodeNumber(1);
    config.incarnation = 10;
    config.held_events = 2;
    session.emplace(config);
  }
  wire::Sample event(std::uint64_t number, std::int64_t expires = wire::kNever) const {
    wire::Sample event = testing::task_event(number);
    wire::SampleHeader& header = wire::header_of(event);
    header.origin = 1;
    header.destination = 2;
    header.incarnation = 10;
    header.sequence_number = number;
    header.expires = expires;
    return event;
  }
  void hold(bool is_long, std::int64_t expires = wire::kNever) {
    session->hold(event(session->next_number(is_long), expires), 0);
  }

  Config config;
  std::optional<Session> session;
};

std::vector<std::uint64_t> numbers(const std::vector<EventExpired>& all) {
  std::vector<std::uint64_t> numbers;
  for (const EventExpired& one : all) numbers.push_back(one.sequence);
  return numbers;
}

TEST_F(SessionOfAStation, LongEventsAreNumberedAndHeldApart) {
  hold(kShort);
  hold(kLong);
  hold(kLong);

  EXPECT_EQ(session->outgoing.size(), 1U);
  EXPECT_EQ(session->parts_out.size(), 2U);
  EXPECT_EQ(session->unacknowledged(), 3U);
  EXPECT_EQ(session->next_number(kShort), 2U);
  EXPECT_EQ(session->next_number(kLong), kFirstLongEvent + 2);
}

TEST_F(SessionOfAStation, OneHalfIsFullWhileTheOtherHasRoom) {
  hold(kShort);
  EXPECT_FALSE(session->full(kShort));
  hold(kShort);

  EXPECT_TRUE(session->full(kShort));
  EXPECT_FALSE(session->full(kLong));
}

TEST_F(SessionOfAStation, TheFirstExpiryIsThatOfEitherHalfAndTheShortOnesAreToldFirst) {
  hold(kShort, MissionTime::seconds(5).count());
  hold(kLong, MissionTime::seconds(4).count());
  EXPECT_EQ(session->first_expiry(), MissionTime::seconds(4));

  EXPECT_THAT(numbers(session->expire(MissionTime::seconds(6))), ElementsAre(1, kFirstLongEvent));
  EXPECT_FALSE(session->first_expiry());
}

TEST_F(SessionOfAStation, WhatWasSentInAFormerLifeIsHeldAgainWhateverItsLength) {
  session->recall_sent(event(1), 0);
  session->recall_sent(event(2), 0);
  session->recall_sent(event(3), 0);
  session->recall_sent(event(kFirstLongEvent), 0);

  EXPECT_EQ(session->outgoing.size(), 3U);
  EXPECT_EQ(session->parts_out.size(), 1U);
}

TEST_F(SessionOfAStation, WhatWasAcknowledgedInAFormerLifeIsOfItsHalf) {
  hold(kShort);
  hold(kLong);
  session->recall_acknowledged(kFirstLongEvent);
  EXPECT_EQ(session->outgoing.size(), 1U);
  EXPECT_EQ(session->parts_out.size(), 0U);
  session->recall_acknowledged(1);
  EXPECT_EQ(session->unacknowledged(), 0U);
}

TEST_F(SessionOfAStation, WhatWasGivenUpInAFormerLifeIsOfItsHalf) {
  hold(kShort);
  hold(kLong);
  session->recall_given_up(kFirstLongEvent);
  EXPECT_EQ(session->outgoing.size(), 1U);
  EXPECT_EQ(session->parts_out.size(), 0U);
  session->recall_given_up(1);
  EXPECT_EQ(session->unacknowledged(), 0U);
}

TEST_F(SessionOfAStation, WhatWasReceivedInAFormerLifeIsOfTheGreatestIncarnation) {
  wire::SampleHeader header = wire::header_of(event(7));
  header.incarnation = 30;
  session->recall_received(header);
  header.incarnation = 20;
  header.sequence_number = kFirstLongEvent + 4;
  session->recall_received(header);

  const Life& life = session->lives.present();
  EXPECT_EQ(life.incarnation, 30U);
  EXPECT_EQ(life.incoming.ack_sequence(), 7U);
  EXPECT_EQ(life.parts.ack_incarnation(), 20U);
  EXPECT_EQ(life.parts.ack_number(), kFirstLongEvent + 4);
}

TEST_F(SessionOfAStation, EverythingIsSaidAgain) {
  hold(kShort);
  hold(kLong);
  const auto said = [&](Duration now) {
    const bool event = !session->outgoing.take_due({MissionTime(), now}, {}).empty();
    const auto part = session->parts_out.next(now, 4096, Duration::seconds(1));
    if (part) session->parts_out.written(*part, now);
    return std::pair(event, part.has_value());
  };
  EXPECT_EQ(said(Duration::milliseconds(1)), std::pair(true, true));
  EXPECT_EQ(said(Duration::milliseconds(2)), std::pair(false, false));

  session->resend();

  EXPECT_EQ(said(Duration::milliseconds(3)), std::pair(true, true));
}

TEST_F(SessionOfAStation, WhatIsHeldIsOfTheIncarnationThatTheNodeHasTowardsThePeer) {
  hold(kShort);
  session->become(config.self, 40);

  EXPECT_EQ(session->lives.self_incarnation(), 40U);
  const wire::Sample* first = session->outgoing.first_due({}, {});
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(wire::header_of(*first).incarnation, 40U);
}

// A late heartbeat of an older incarnation is no rival; who is heard again and again is.
TEST_F(SessionOfAStation, AnOlderLifeThatIsHeardByTurnsWithThePresentOneIsARival) {
  Lives& lives = session->lives;
  for (int old = 0; old < 5; ++old) lives.heard_older();
  EXPECT_FALSE(lives.has_older_rival());
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_FALSE(lives.has_older_rival()) << turn;
    lives.heard_present(false);
    lives.heard_older();
  }
  EXPECT_TRUE(lives.has_older_rival());

  lives.heard_present(true);
  EXPECT_FALSE(lives.has_older_rival());
}

}  // namespace
}  // namespace skein::blackboard
