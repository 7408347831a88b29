// SPDX-License-Identifier: Apache-2.0
#include "heard_records.hpp"

#include <gtest/gtest.h>

namespace skein::run_tool {
namespace {

constexpr blackboard::NodeNumber kMarvin{2}, kHeliv{3};

wire::JournalEntry entry(std::uint64_t sequence, std::uint64_t line,
                         std::uint64_t incarnation = 1) {
  wire::JournalEntry one;
  one.header.sequence_number = sequence;
  one.header.incarnation = incarnation;
  one.line = line;
  return one;
}

TEST(HeardRecords, AreNewsOnceThoughAParticipantThatIsOpenedAnewHearsThemAgain) {
  HeardRecords heard;

  EXPECT_TRUE(heard.is_news(kMarvin, entry(1, 0)));
  EXPECT_TRUE(heard.is_news(kMarvin, entry(2, 1)));
  EXPECT_FALSE(heard.is_news(kMarvin, entry(1, 0)));
  EXPECT_FALSE(heard.is_news(kMarvin, entry(2, 1)));
  EXPECT_TRUE(heard.is_news(kHeliv, entry(2, 1)));
}

TEST(HeardRecords, OfANodeThatWasKilledBeforeItHadNotedWhatItSaidAreNewsOnce) {
  constexpr std::uint64_t kNextLife = std::uint64_t{1} << 40;
  HeardRecords heard;
  EXPECT_TRUE(heard.is_news(kMarvin, entry(7, 4)));
  EXPECT_TRUE(heard.is_news(kMarvin, entry(8, 5)));

  EXPECT_TRUE(heard.is_news(kMarvin, entry(kNextLife + 1, 0))) << "that it has resumed";
  EXPECT_FALSE(heard.is_news(kMarvin, entry(kNextLife + 2, 5)));
  EXPECT_TRUE(heard.is_news(kMarvin, entry(kNextLife + 3, 6)));
  EXPECT_TRUE(heard.is_news(kMarvin, entry(kNextLife + 4, 0)));
  EXPECT_TRUE(heard.is_news(kMarvin, entry(kNextLife + 5, 7)));
}

TEST(HeardRecords, OfANodeThatForgotBeginAnew) {
  HeardRecords heard;
  EXPECT_TRUE(heard.is_news(kMarvin, entry(8, 5, 1)));

  EXPECT_TRUE(heard.is_news(kMarvin, entry(1, 1, 2)));
}

}  // namespace
}  // namespace skein::run_tool
