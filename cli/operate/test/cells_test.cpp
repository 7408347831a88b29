// SPDX-License-Identifier: Apache-2.0
#include "../src/cells.hpp"

#include <gtest/gtest.h>

namespace skein::operate_tool {
namespace {

TEST(Cells, FillTheirWidth) { EXPECT_EQ(cell(8, "marvin"), "marvin  "); }

// "7 joint:cooperative-mapping" ran into "revision 26".
TEST(Cells, KeepApartFromTheNextWhatIsLonger) {
  EXPECT_EQ(cell(8, "a-long-name") + "next", "a-long-name  next");
  EXPECT_EQ(cell(8, "7 chars") + "next", "7 chars  next");
}

}  // namespace
}  // namespace skein::operate_tool
