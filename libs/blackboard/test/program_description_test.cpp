// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/program_description.hpp"

#include <gtest/gtest.h>

#include "skein/blackboard/wire_layout.hpp"

namespace skein::blackboard {
namespace {

TEST(ProgramDescription, OfThisProgramNamesTheLayoutOfItsSamples) {
  EXPECT_EQ(program_description().layout, wire::layout_mark());
  EXPECT_FALSE(program_description().version.empty());
}

TEST(ProgramDescription, IsReadBackFromItsText) {
  EXPECT_EQ(parse_program_description(to_text(program_description())), program_description());
}

TEST(ProgramDescription, SaysWhichScenarioTheProgramFlies) {
  const ProgramDescription flying = program_description("189abcdef");
  EXPECT_EQ(to_text(flying), to_text(program_description()) + " scenario 189abcdef");
  EXPECT_EQ(parse_program_description(to_text(flying)), flying);
}

TEST(ProgramDescription, IsNothingInWhatOtherProgramsSay) {
  for (const char* text : {"", "skein", "skein 0.1.0", "skein 0.1.0 layout", "rviz 1 layout 2",
                           "skein 0.1.0 mark 77", "skein 0.1.0 layout 77 and more",
                           "skein 0.1.0 layout 77 scenario", "skein 0.1.0 layout 77 scenario 1 2"})
    EXPECT_FALSE(parse_program_description(text)) << text;
}

}  // namespace
}  // namespace skein::blackboard
