// SPDX-License-Identifier: Apache-2.0
#include "skein/temporal_files/link_changes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnostics_text.hpp"

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const Stnu kNetwork{{"v0", "a", "b"}, 0, {}, {}};

std::string errors(const std::string& text) { return errors_of(read_changes(text, kNetwork, "f")); }

TEST(ReadChanges, KeepsTheirOrderAndTheSameTwoNodesAsOftenAsWanted) {
  const auto read = read_changes(R"([{"from":"a","to":"b","min":1.5,"max":null},
                                     {"from":"a","to":"b","min":null,"max":2},
                                     {"from":"v0","to":"a","min":0,"max":0}])",
                                 kNetwork);

  ASSERT_EQ(errors_of(read), "");
  EXPECT_THAT(*read, ElementsAre(Arc{1, 2, 1'500'000'000, kInfinite},
                                 Arc{1, 2, kMinusInfinite, 2 * kTicksPerSecond}, Arc{0, 1, 0, 0}));
}

TEST(ReadChanges, NamesEachErrorWithItsPlace) {
  EXPECT_THAT(errors(R"([{"from":"a","to":"c","min":1,"max":2}])"),
              HasSubstr("f:1:19: [0].to: unknown node 'c'"));
  EXPECT_THAT(errors(R"([{"from":"a","to":"b","min":3,"max":2}])"),
              HasSubstr("min 3 is greater than max 2"));
  EXPECT_THAT(errors(R"([{"from":"a","to":"a","min":0,"max":2}])"), HasSubstr("to itself"));
  EXPECT_THAT(errors(R"([{"from":"a","to":"b","min":0}])"), HasSubstr("missing key 'max'"));
  EXPECT_THAT(errors(R"({"from":"a"})"), HasSubstr("expected an array"));
  EXPECT_THAT(errors("[,]"), HasSubstr("not JSON"));
}

}  // namespace
}  // namespace skein::temporal
