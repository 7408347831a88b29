// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/wire_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "skein/blackboard/wire.hpp"

namespace skein::wire {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string line_of(const std::string& slot) {
  std::istringstream all(layout());
  for (std::string line; std::getline(all, line);)
    if (line.rfind(slot + " ", 0) == 0) return line;
  return "";
}

TEST(WireLayout, HasALineForEachSlot) {
  const std::string all = layout();

  EXPECT_EQ(static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')), kSlotCount);
  for (std::size_t slot = 0; slot < kSlotCount; ++slot)
    EXPECT_NE(line_of(std::string(slot_name(static_cast<Slot>(slot)))), "") << slot;
}

TEST(WireLayout, TellsNamesKindsAndWidthsOfFields) {
  EXPECT_THAT(line_of("Clock"), HasSubstr("{header {origin u32; instance u32; "));
  EXPECT_THAT(line_of("Telemetry"), HasSubstr("position {x f32; y f32; z f32; }; "));
  EXPECT_THAT(line_of("TaskRequest"), HasSubstr("numbers f64[]; "));
  EXPECT_THAT(line_of("TaskEvent"), HasSubstr("enum(scheduled|started|running|"));
}

// By the IDL itself, which no program of ours reads: each name of a field is there.
TEST(WireLayout, HasEachFieldOfTheIdl) {
  const std::string all = layout();
  const std::regex member(R"(^\s+[A-Za-z_:<>0-9, ]+\s([a-z_0-9]+)(\[\d+\])?;)");
  std::set<std::string> missing;
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(SKEIN_IDL)) {
    if (entry.path().extension() != ".idl") continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      std::smatch found;
      if (!std::regex_search(line, found, member)) continue;
      ++seen;
      if (all.find(found[1].str() + " ") == std::string::npos) missing.insert(found[1].str());
    }
  }
  EXPECT_GT(seen, 100U);
  EXPECT_THAT(missing, ::testing::IsEmpty());
}

TEST(WireLayout, MarkIsSixteenDigitsAndAlwaysTheSame) {
  EXPECT_EQ(layout_mark().size(), 16U);
  EXPECT_EQ(layout_mark().find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(layout_mark(), layout_mark());
}

}  // namespace
}  // namespace skein::wire
