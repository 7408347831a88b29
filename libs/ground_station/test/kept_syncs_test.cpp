// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/kept_syncs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using executive::SyncWord;
using testing::at;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(KeptSyncs, OfOneSenderAboutOneMeetingWhatWasSaidLastCountsNotWhatCameLast) {
  KeptSyncs kept;
  kept.note({551, "heliv", "marvin", SyncWord::kThere, at(1)}, at(2));
  kept.note({551, "heliv", "marvin", SyncWord::kWithdrawn, at(5)}, at(6));
  kept.note({551, "heliv", "marvin", SyncWord::kThere, at(3)}, at(7));

  const auto messages = kept.of("marvin");

  ASSERT_THAT(messages, SizeIs(1));
  EXPECT_EQ(messages[0].word, SyncWord::kWithdrawn);
  EXPECT_EQ(messages[0].said, at(5));
}

TEST(KeptSyncs, EachMeetingAndSenderHasItsOwnAndEachReceiverHearsOnlyItsOwn) {
  KeptSyncs kept;
  kept.note({551, "heliv", "marvin"}, at(1));
  kept.note({551, "karma", "marvin"}, at(1));
  kept.note({552, "heliv", "marvin"}, at(1));
  kept.note({551, "heliv", "karma"}, at(1));

  EXPECT_THAT(kept.of("marvin"), SizeIs(3));
  EXPECT_THAT(kept.of("karma"), SizeIs(1));
  EXPECT_THAT(kept.of("heliv"), IsEmpty());
}

TEST(KeptSyncs, WhatDoesNotTellWhenItWasSaidWasSaidWhenItCame) {
  KeptSyncs kept;

  const executive::SyncReceived message = kept.note({551, "heliv", "marvin"}, at(4));

  EXPECT_EQ(message.from, "heliv");
  EXPECT_EQ(message.said, at(4));
}

TEST(KeptSyncs, AreSentAsTheyWereSaid) {
  KeptSyncs kept;
  kept.note({551, "heliv", "marvin", SyncWord::kWithdrawn, at(5)}, at(6));

  const auto sent = kept.for_sending("marvin");

  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_EQ(sent[0].id, 551U);
  EXPECT_EQ(sent[0].from, "heliv");
  EXPECT_EQ(sent[0].to, "marvin");
  EXPECT_EQ(sent[0].word, SyncWord::kWithdrawn);
  EXPECT_EQ(sent[0].said, at(5));
}

}  // namespace
}  // namespace skein::ground_station
