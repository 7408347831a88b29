// SPDX-License-Identifier: Apache-2.0
// Instants of a run as the rest of the world counts them.
#include "skein/foundation/unix_time.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

namespace skein {
namespace {

// date -u -d 2005-05-19T09:00:00Z +%s
TEST(EpochOf, IsWhatDateSays) {
  EXPECT_EQ(epoch_of("2005-05-19T09:00:00Z"), 1116493200ULL * 1'000'000'000);
  EXPECT_EQ(epoch_of("1970-01-01T00:00:01Z"), 1'000'000'000ULL);
}

TEST(EpochOf, WhatIsNoInstantIsTheBeginning) {
  for (const char* text : {"", "soon", "2005-02-31T09:00:00Z", "1960-01-01T00:00:00Z", "2005-05-19",
                           "2005-05-19T09:00:00", "2005-05-19T09:00:00Z and more",
                           "2005-05-19T24:00:00Z", "2005-05-19T09:60:00Z", "2005-13-01T00:00:00Z"})
    EXPECT_EQ(epoch_of(text), 0U) << text;
}

// What 64 bits of nanoseconds hold since 1970: up to 2262-04-11T23:47:16Z.
TEST(EpochOf, WhatNanosecondsDoNotReachIsTheBeginning) {
  EXPECT_EQ(epoch_of("2262-04-11T23:47:16Z"), 9'223'372'036ULL * 1'000'000'000);
  for (const char* text : {"2262-04-11T23:47:17Z", "2300-01-01T00:00:00Z", "9999-12-31T23:59:59Z"})
    EXPECT_EQ(epoch_of(text), 0U) << text;
}

// The days since 1970 as Fliegel and Van Flandern count them (CACM 11, 1968): another formula.
std::int64_t julian_day(std::int64_t y, std::int64_t m, std::int64_t d) {
  return d - 32075 + 1461 * (y + 4800 + (m - 14) / 12) / 4 +
         367 * (m - 2 - (m - 14) / 12 * 12) / 12 - 3 * ((y + 4900 + (m - 14) / 12) / 100) / 4;
}

TEST(UtcTextLaws, EveryDayIsThatOfTheJulianCount) {
  for (int year = 1970; year < 2262; year += 1) {
    for (int month = 1; month <= 12; ++month) {
      const std::int64_t day = julian_day(year, month, 28) - julian_day(1970, 1, 1);
      char text[32];
      std::snprintf(text, sizeof text, "%04d-%02d-28T23:59:59Z", year, month);
      const auto seconds = static_cast<std::uint64_t>(day * 86400 + 86399);
      EXPECT_EQ(epoch_of(text), seconds * 1'000'000'000) << text;
      EXPECT_EQ(utc_text(seconds * 1'000'000'000), text);
    }
  }
}

TEST(UnixTime, CountsFromTheEpochAndNeverBeforeTheBeginning) {
  EXPECT_EQ(unix_time(1000, MissionTime::nanoseconds(5)), 1005U);
  EXPECT_EQ(unix_time(1000, MissionTime::nanoseconds(-5)), 995U);
  EXPECT_EQ(unix_time(0, MissionTime::nanoseconds(-5)), 0U);
}

TEST(UtcText, IsReadBackByEpochOf) {
  for (const char* text : {"2005-05-19T09:00:00Z", "1970-01-01T00:00:00Z", "2026-12-31T23:59:59Z"})
    EXPECT_EQ(utc_text(epoch_of(text)), text);
}

// date -u -d @1116493201.25 +%FT%T.%3NZ
TEST(UtcText, HasThousandthsWhereThereAreSome) {
  EXPECT_EQ(utc_text(1116493201ULL * 1'000'000'000 + 250'999'999), "2005-05-19T09:00:01.250Z");
}

}  // namespace
}  // namespace skein
