// SPDX-License-Identifier: Apache-2.0
#include "row.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/entries.hpp"

namespace skein::store {
namespace {

TEST(Row, WhatIsReadIsWhatWasWritten) {
  for (const node::LogEntry& entry : testing::one_of_each()) {
    const auto read = entry_of(row_of(entry));

    ASSERT_TRUE(read.has_value()) << read.error().why;
    EXPECT_EQ(testing::to_text(*read), testing::to_text(entry));
  }
}

TEST(Row, EveryKindHasAName) {
  std::set<std::string> names;
  std::set<std::size_t> kinds;
  for (const node::LogEntry& entry : testing::one_of_each()) {
    names.insert(row_of(entry).kind);
    kinds.insert(entry.input.index());
  }

  EXPECT_EQ(names.size(), kinds.size());
  EXPECT_EQ(kinds.size(), std::variant_size_v<node::LoggedInput>);
}

struct Wrong {
  const char* name;
  Row row;
  const char* why;
};

class WrongRow : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongRow, IsRefusedWithTheReason) {
  const auto read = entry_of(GetParam().row);

  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().why, GetParam().why);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, WrongRow,
    ::testing::Values(
        Wrong{"NoKind", {0, "dreamt", 1, "", 0, 0, 0, {}}, "there is no input of kind 'dreamt'"},
        Wrong{"NoPeer", {0, "reachability", 0, "", 0, 0, 1, {}}, "no node has the number 0"},
        Wrong{"HugePeer",
              {0, "acknowledged", 1LL << 40, "", 0, 0, 1, {}},
              "no node has the number 1099511627776"},
        Wrong{"NoSlot", {0, "received", 1, "Gossip", 0, 0, 0, {}}, "there is no slot 'Gossip'"}),
    [](const auto& one) { return one.param.name; });

TEST(WrongRow, OfASampleCutShortSaysWhichField) {
  Row row = row_of(testing::one_of_each()[8]);
  row.body.resize(row.body.size() - 5);

  const auto read = entry_of(row);

  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().why.substr(0, 10 + row.slot.size() + 2), "malformed " + row.slot + ": ");
}

RC_GTEST_PROP(Row, WhateverTheBytesNothingBreaks, (std::uint8_t which, std::uint16_t at)) {
  const auto entries = testing::one_of_each();
  Row row = row_of(entries[which % entries.size()]);
  if (row.body.empty()) return;
  row.body[at % row.body.size()] ^= static_cast<std::uint8_t>(1 + at % 255);

  const auto read = entry_of(row);

  RC_ASSERT(read.has_value() || !read.error().why.empty());
}

}  // namespace
}  // namespace skein::store
