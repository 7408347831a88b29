// SPDX-License-Identifier: Apache-2.0
// Instants of a run as the rest of the world counts them.
#include "skein/foundation/unix_time.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

// date -u -d 2005-05-19T09:00:00Z +%s
TEST(EpochOf, IsWhatDateSays) {
  EXPECT_EQ(epoch_of("2005-05-19T09:00:00Z"), 1116493200ULL * 1'000'000'000);
  EXPECT_EQ(epoch_of("1970-01-01T00:00:01Z"), 1'000'000'000ULL);
}

TEST(EpochOf, WhatIsNoInstantIsTheBeginning) {
  for (const char* text : {"", "soon", "2005-02-31T09:00:00Z", "1960-01-01T00:00:00Z"})
    EXPECT_EQ(epoch_of(text), 0U) << text;
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
