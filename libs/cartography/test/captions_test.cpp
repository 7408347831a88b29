// SPDX-License-Identifier: Apache-2.0
#include "captions.hpp"

#include <gtest/gtest.h>

namespace skein::cartography {
namespace {

TEST(Captions, WriteTimesAsTheirLengthAsksFor) {
  EXPECT_EQ(seconds(Duration::seconds(0)), "0 s");
  EXPECT_EQ(seconds(Duration::seconds(119)), "119 s");
  EXPECT_EQ(seconds(Duration::seconds(120)), "2:00 min");
  EXPECT_EQ(seconds(Duration::seconds(125)), "2:05 min");
  EXPECT_EQ(seconds(Duration::seconds(3599)), "59:59 min");
  EXPECT_EQ(seconds(Duration::seconds(3600)), "1:00:00 h");
  EXPECT_EQ(seconds(Duration::seconds(36'061)), "10:01:01 h");
  EXPECT_EQ(seconds(Duration::max()), "never");
  EXPECT_EQ(duration_words({Duration::seconds(5), Duration::seconds(60), Duration::max()}),
            "60 s (5 s to never)");
}

TEST(Captions, OfARefusalNameTheFieldIfThereIsOne) {
  EXPECT_EQ(refusal_words({refiners::RefusalKind::kUnreachable, "to", "closed"}),
            "no solution (unreachable, to): closed");
  EXPECT_EQ(refusal_words({refiners::RefusalKind::kUnreachable, "", "closed"}),
            "no solution (unreachable): closed");
}

}  // namespace
}  // namespace skein::cartography
