// SPDX-License-Identifier: Apache-2.0
#include "language/cursor.hpp"

#include <gtest/gtest.h>

namespace skein::htn {
namespace {

TEST(Cursor, LooksAheadAsFarAsTheTextGoes) {
  Cursor cursor{"(a)"};
  EXPECT_EQ(cursor.peek(), '(');
  EXPECT_EQ(cursor.peek(2), ')');
  EXPECT_EQ(cursor.peek(3), '\0');
  cursor.at = 2;
  EXPECT_EQ(cursor.peek(), ')');
  EXPECT_EQ(cursor.peek(1), '\0');
}

TEST(Cursor, IsAtTheEndAfterTheLastByte) {
  Cursor cursor{"(a)"};
  cursor.at = 2;
  EXPECT_FALSE(cursor.at_end());
  cursor.at = 3;
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(cursor.offset(), 3U);
  EXPECT_TRUE(Cursor{""}.at_end());
}

TEST(Cursor, KnowsWhatWasRead) {
  Cursor cursor{"(abc)"};
  cursor.at = 4;
  EXPECT_EQ(cursor.since(1), "abc");
  EXPECT_EQ(cursor.since(4), "");
}

}  // namespace
}  // namespace skein::htn
