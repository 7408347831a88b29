// SPDX-License-Identifier: Apache-2.0
#include "feed.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "limits.hpp"

namespace skein::console {
namespace {

constexpr std::size_t kAll = 1'000'000'000;

/// The data lines of server-sent events.
std::vector<std::string> data_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("data: ")) lines.push_back(line.substr(6));
  }
  return lines;
}

TEST(Feed, TellsValuesAndEventsInTheOrderInWhichTheyCame) {
  Feed feed;
  feed.set("a", "1");
  feed.add("2");
  feed.set("b", "3");
  std::uint64_t cursor = 0;

  EXPECT_EQ(data_of(feed.take(cursor, kAll)), (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_FALSE(feed.has_news(cursor));
  EXPECT_EQ(feed.take(cursor, kAll), "");
}

TEST(Feed, AStoryFromItsBeginningLeavesNothingOfTheOneBefore) {
  Feed feed;
  feed.set("a", "1");
  feed.add("2");
  std::uint64_t reader = 0, late = 0;
  (void)feed.take(reader, kAll);

  feed.begin_again("again");
  feed.set("a", "1");

  EXPECT_EQ(data_of(feed.take(reader, kAll)), (std::vector<std::string>{"again", "1"}));
  EXPECT_EQ(data_of(feed.take(late, kAll)), (std::vector<std::string>{"again", "1"}));
}

TEST(Feed, WhoComesLateIsToldTheLastOfEachValueAndAllEvents) {
  Feed feed;
  for (int i = 0; i < 5; ++i) {
    feed.set("a", std::to_string(i));
    feed.add("e" + std::to_string(i));
  }
  std::uint64_t cursor = 0;

  EXPECT_EQ(data_of(feed.take(cursor, kAll)),
            (std::vector<std::string>{"e0", "e1", "e2", "e3", "4", "e4"}));
}

TEST(Feed, AValueThatDidNotChangeIsNoNews) {
  Feed feed;
  feed.set("a", "1");
  std::uint64_t cursor = 0;
  (void)feed.take(cursor, kAll);

  feed.set("a", "1");

  EXPECT_FALSE(feed.has_news(cursor));
}

TEST(Feed, SaysThatEventsWereThrownAwayBeforeAReaderCameToThem) {
  Feed feed;
  feed.add("first");
  std::uint64_t cursor = 0;
  (void)feed.take(cursor, kAll);
  for (std::size_t i = 0; i < kEvents + 10; ++i) feed.add("x");

  const std::string text = feed.take(cursor, kAll);

  EXPECT_TRUE(text.starts_with("event: gap\n"));
  EXPECT_EQ(data_of(text).size(), kEvents + 1);  // the gap has data too
}

TEST(Feed, KeepsNoMoreBytesOfEventsThanItMay) {
  Feed feed;
  const std::string big(100'000, 'x');
  for (int i = 0; i < 200; ++i) feed.add(big);
  std::uint64_t cursor = 0;

  EXPECT_LE(feed.take(cursor, kAll).size(), kEventBytes + 10'000);
}

// However slowly it reads, a reader ends with the last of each value and has missed no event.
RC_GTEST_PROP(Feed, EveryReaderEndsWithTheSame, ()) {
  Feed feed;
  std::map<std::string, std::string> truth, seen;
  std::size_t events = 0, heard = 0;
  std::uint64_t cursor = 0;
  const auto read = [&](std::size_t most) {
    for (const std::string& one : data_of(feed.take(cursor, most))) {
      const std::size_t sign = one.find('=');
      if (sign == std::string::npos) {
        ++heard;
      } else {
        seen[one.substr(0, sign)] = one.substr(sign + 1);
      }
    }
  };
  for (int i = 0, steps = *rc::gen::inRange(0, 100); i < steps; ++i) {
    switch (*rc::gen::inRange(0, 3)) {
      case 0: {
        const std::string key(1, static_cast<char>('a' + *rc::gen::inRange(0, 4)));
        truth[key] = std::to_string(i);
        feed.set(key, key + "=" + truth[key]);
        break;
      }
      case 1:
        feed.add("event");
        ++events;
        break;
      default:
        read(static_cast<std::size_t>(*rc::gen::inRange(1, 60)));
    }
  }
  while (feed.has_news(cursor)) read(1);

  RC_ASSERT(seen == truth);
  RC_ASSERT(heard == events);
}

}  // namespace
}  // namespace skein::console
