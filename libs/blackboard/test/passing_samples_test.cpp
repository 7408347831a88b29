// SPDX-License-Identifier: Apache-2.0
#include "passing_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "skein/blackboard/transport.hpp"
#include "skein/foundation/random.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

wire::Sample between(std::uint32_t origin, std::uint32_t destination, std::uint64_t number,
                     wire::Sample sample = wire::SyncMessage{}) {
  wire::SampleHeader& header = wire::header_of(sample);
  header.origin = origin;
  header.destination = destination;
  header.sequence_number = number;
  header.expires = wire::kNever;
  return sample;
}

/// "1>3 #5" of each, in order; heartbeats as "1>3 beat 5".
std::vector<std::string> taken(PassingSamples& passing) {
  std::vector<std::string> all;
  while (!passing.empty()) {
    const wire::Sample one = passing.take();
    const wire::SampleHeader& header = wire::header_of(one);
    const bool beats = std::holds_alternative<wire::Heartbeat>(one);
    all.push_back(std::to_string(header.origin) + ">" + std::to_string(header.destination) +
                  (beats ? " beat " : " #") + std::to_string(header.sequence_number));
  }
  return all;
}

// Found by a random mission: a message of a synchronisation waited behind five minutes of events
// for the ground station.
TEST(PassingSamples, WhatWaitsForOneReceiverKeepsNobodyElseWaiting) {
  PassingSamples passing;
  for (std::uint64_t number = 1; number <= 3; ++number) passing.put(between(5, 1, number));
  passing.put(between(5, 2, 1));
  passing.put(between(6, 1, 1));

  EXPECT_THAT(taken(passing), ElementsAre("5>1 #1", "5>2 #1", "6>1 #1", "5>1 #2", "5>1 #3"));
}

TEST(PassingSamples, TheLastHeartbeatOfAPairGoesBeforeItsEvents) {
  PassingSamples passing;
  passing.put(between(5, 1, 1));
  passing.put(between(5, 1, 7, wire::Heartbeat{}));
  passing.put(between(6, 1, 1));
  passing.put(between(5, 1, 8, wire::Heartbeat{}));

  EXPECT_THAT(taken(passing), ElementsAre("5>1 beat 8", "5>1 #1", "6>1 #1"));
}

// Found by random missions (--relays --merged --capacity 9600): what five UAVs tell each other past
// a chain of relays once a second was more than the channel carries, and no event of 40 s came
// through to 3,000 s.
TEST(PassingSamples, AnEventHasItsTurnThoughHeartbeatsWaitEachTime) {
  PassingSamples passing;
  for (std::uint64_t number = 1; number <= 3; ++number) passing.put(between(5, 1, number));
  std::string order;
  for (std::uint64_t beat = 1; beat <= 4; ++beat) {
    for (const std::uint32_t author : {5U, 6U, 7U})
      passing.put(between(author, 1, beat, wire::Heartbeat{}));
    order += std::holds_alternative<wire::Heartbeat>(passing.take()) ? "beat " : "event ";
  }

  EXPECT_EQ(order, "beat event beat event ");
}

TEST(PassingSamples, WhatItsAuthorSaysAgainMeanwhileWaitsOnce) {
  PassingSamples passing;
  passing.put(between(5, 1, 1));
  passing.put(between(5, 1, 2));
  passing.put(between(5, 1, 1));

  EXPECT_THAT(taken(passing), ElementsAre("5>1 #1", "5>1 #2"));
}

// Found by a random mission: at 9,600 bit/s a UAV's words about air, which live 2 s, waited longer
// than that behind each other, and nothing else of it came through for half an hour.
TEST(PassingSamples, WhatHasExpiredMakesWay) {
  const auto until = [](std::uint64_t number, std::int64_t expires) {
    wire::Sample sample = between(5, 1, number);
    wire::header_of(sample).expires = expires;
    return sample;
  };
  PassingSamples passing;
  passing.put(until(1, 10));
  passing.put(until(2, 30));
  passing.put(until(3, 10));
  passing.put(between(5, 1, 7, wire::Heartbeat{}));
  passing.drop_expired(MissionTime::nanoseconds(20));

  EXPECT_THAT(taken(passing), ElementsAre("5>1 beat 7", "5>1 #2"));
  passing.put(until(4, 30));
  passing.drop_expired(MissionTime::nanoseconds(40));
  EXPECT_TRUE(passing.empty());
}

// Its receiver waits for nothing behind it.
TEST(PassingSamples, AnEmptyPlaceOfTheSequenceDoesNotExpireAndTakesThatOfItsContent) {
  PassingSamples passing;
  passing.put(between(5, 1, 1, sync_message(77)));
  passing.put(between(5, 1, 2));
  wire::Sample empty = between(5, 1, 1);
  wire::header_of(empty).expires = std::numeric_limits<std::int64_t>::min();
  passing.put(empty);
  passing.drop_expired(MissionTime::seconds(1e6));

  EXPECT_EQ(passing.take(), empty);
  EXPECT_THAT(taken(passing), ElementsAre("5>1 #2"));
}

TEST(PassingSamples, WhoHasSavedUpMostLosesTheOldest) {
  PassingSamples passing;
  for (std::uint64_t number = 1; number <= kEventDepth; ++number)
    passing.put(between(5, 1, number));
  passing.put(between(6, 1, 1));

  const std::vector<std::string> all = taken(passing);

  ASSERT_THAT(all, SizeIs(kEventDepth));
  EXPECT_EQ(all[0], "5>1 #2");
  EXPECT_EQ(all[1], "6>1 #1");
}

TEST(PassingSamples, AsManyPairsAsThereAreMayWait) {
  PassingSamples passing;
  for (std::uint32_t origin = 1; origin <= kEventDepth + 10; ++origin)
    passing.put(between(origin, 1'000, 1));

  EXPECT_THAT(taken(passing), SizeIs(kEventDepth));
}

// Whatever comes and goes: each pair's events in their order, and between two of one pair at most
// one of each other.
TEST(PassingSamples, GoInOrderAndInTurn) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    PassingSamples passing;
    std::map<std::uint32_t, std::uint64_t> put;
    std::map<std::uint32_t, std::uint64_t> taken;
    std::map<std::uint32_t, std::map<std::uint32_t, int>> others;  // since the last of the first
    for (int step = 0; step < 300; ++step) {
      const auto origin = static_cast<std::uint32_t>(1 + random.below(4));
      if (passing.empty() || random.chance(0.55)) {
        passing.put(between(origin, 9, ++put[origin]));
        continue;
      }
      const wire::Sample one = passing.take();
      const std::uint32_t from = wire::header_of(one).origin;
      ASSERT_EQ(wire::header_of(one).sequence_number, ++taken[from]) << seed;
      others[from].clear();
      for (auto& [waiting, count] : others) {
        if (waiting == from || put[waiting] == taken[waiting]) continue;
        ASSERT_LE(++count[from], 1) << seed << ": " << from << " before " << waiting;
      }
      for (std::uint32_t each = 1; each <= 4; ++each)
        if (put[each] == taken[each]) others[each].clear();
    }
  }
}

}  // namespace
}  // namespace skein::blackboard::testing
