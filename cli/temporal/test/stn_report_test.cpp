// SPDX-License-Identifier: Apache-2.0
#include "stn_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace skein::temporal_tool {
namespace {

using temporal::kInfinite;
using temporal::kTicksPerSecond;
using temporal::LinkKind;
using ::testing::HasSubstr;

const temporal::Stnu kNetwork{
    {"v0", "a\"b"}, 0, {{0, 1, 0, kInfinite}}, {{0, 1, kTicksPerSecond, 5 * kTicksPerSecond / 2}}};
const std::vector<ConflictPart> kParts{{{LinkKind::kContingent, 0}, LinkBound::kMax},
                                       {{LinkKind::kRequirement, 0}, LinkBound::kMin}};

TEST(TableText, LinesUpColumnsByCharactersNotBytes) {
  EXPECT_EQ(table_text({{"→", "x"}, {"abc", "yy"}, {"a"}}, " "), " →    x\n abc  yy\n a\n");
  EXPECT_EQ(table_text({}, " "), "");
}

TEST(DurationText, ChoosesItsUnit) {
  EXPECT_EQ(duration_text(0.0000123), "12 µs");
  EXPECT_EQ(duration_text(0.0123), "12.3 ms");
  EXPECT_EQ(duration_text(12.345), "12.35 s");
}

TEST(SummaryText, CountsWhatThereIs) {
  EXPECT_EQ(summary_text({kNetwork, temporal::Format::kPlain}),
            "STNU, 2 nodes, 1 requirement, 1 contingent link (plain)");
  EXPECT_EQ(summary_text({{{"v0"}, 0, {}, {}}, temporal::Format::kJson}),
            "STN, 1 node, 0 requirements (json)");
}

TEST(ConflictText, NamesLinkBoundAndInterval) {
  EXPECT_EQ(conflict_text(kNetwork, kParts, Paint(false)),
            "  v0 → a\"b  max 2.5  of [1, 2.5], contingent\n"
            "  v0 → a\"b  min 0    of ≥ 0\n");
}

TEST(Paint, ColoursOnlyWhenOn) {
  EXPECT_EQ(Paint(false).bad("x"), "x");
  EXPECT_EQ(Paint(true).bad("x"), "\033[1;31mx\033[0m");
}

TEST(VerdictJson, IsTheObjectOfTheSpecification) {
  const auto json = nlohmann::json::parse(verdict_json(kNetwork, {true, false, kParts, 0.25}));

  EXPECT_EQ(json.at("consistent"), true);
  EXPECT_EQ(json.at("controllable"), false);
  EXPECT_EQ(json.at("seconds"), 0.25);
  ASSERT_EQ(json.at("conflict").size(), 2U);
  EXPECT_EQ(json.at("conflict")[0],
            nlohmann::json::parse(
                R"({"from":"v0","to":"a\"b","min":1,"max":2.5,"contingent":true,"bound":"max"})"));
  EXPECT_EQ(json.at("conflict")[1].at("max"), nullptr);
}

TEST(VerdictJson, SaysNullForWhatWasNotAsked) {
  EXPECT_THAT(verdict_json(kNetwork, {true, std::nullopt, {}, 0}),
              HasSubstr(R"("controllable": null, "conflict": [])"));
}

}  // namespace
}  // namespace skein::temporal_tool
