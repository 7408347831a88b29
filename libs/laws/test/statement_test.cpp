// SPDX-License-Identifier: Apache-2.0
#include "statement.hpp"

#include <gtest/gtest.h>

#include "skein/mission/high_level_task.hpp"

namespace skein::laws {
namespace {

TEST(Statement, IsReadBackAsItWasWritten) {
  for (const char* text :
       {"perceive P1 120 [start-after 20.5, end-before 300]", "general-land",
        "perform-tour (A1 A2 P1)", "general-gotoxyz (1 -2.5 40)", "synchro 500 (a b) (a b)"}) {
    EXPECT_EQ(mission::to_text(task_from(text)), text);
  }
}

}  // namespace
}  // namespace skein::laws
