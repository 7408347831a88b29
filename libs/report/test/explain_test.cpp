// SPDX-License-Identifier: Apache-2.0
#include "skein/report/explain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plan_builders.hpp"

namespace skein::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Explain, TellsOfATaskWhereItComesFromAndWhenItWasAndShouldHaveBeen) {
  const auto text = explain(testing::deliberated(), "karma", 101);

  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text,
            "karma\n"
            "  101 goto\n"
            "    for        701 general-gotoxyz P1\n"
            "    asked      mission 7, asked by step detection\n"
            "    by way of  general-gotoxyz > fly\n"
            "    after      ended 100\n"
            "    start      4.0 to 6.0 s planned, 5.0 s actually\n"
            "    end        20.0 to 30.0 s planned, 40.0 s actually (ended)\n"
            "    dates of   revision 1 of the plan, 2.0 s\n"
            "Decisions that concern it\n"
            "  1.0 s  operator 0 user request\n"
            "    cause      mission 7\n"
            "    inputs     goals 701 702\n"
            "    outcome    accepted\n"
            "    took       50 ms\n"
            "  31.0 s  operator 6 repair: drop\n"
            "    cause      task 101 overdue by 1.0 s\n"
            "    inputs     goal 702\n"
            "    outcome    1 task left\n"
            "    took       50 ms\n");
}

TEST(Explain, OfAUavTellsAllItsGoalsTasksAndDecisions) {
  const auto text = explain(testing::deliberated(), "karma", std::nullopt);

  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, HasSubstr("701 general-gotoxyz P1 (mission 7, asked by step detection)"));
  EXPECT_THAT(*text, HasSubstr("received 1.0 s, planned 2.0 s, failed 31.0 s: no way to Z"));
  EXPECT_THAT(*text, HasSubstr("  102 goto\n"));
  EXPECT_THAT(*text, HasSubstr("not actually"));
  EXPECT_THAT(*text, HasSubstr("operator 6 repair: drop"));
}

TEST(Explain, ANumberWithinAnotherConcernsNobody) {
  Journal journal = testing::deliberated();
  journal.decisions = {testing::decision(9, 1, "2 cancel", "task 1010", "goals 7011", "")};

  const auto text = explain(journal, "karma", 101);

  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, Not(HasSubstr("Decisions")));
}

TEST(Explain, OfATaskOfARoleTellsWhichConditionBeganIt) {
  const auto read = testing::salvage(
      R"({"at":47,"node":"uav2","kind":"role-task","uav":"uav2","joint":"watch(P1) of uav1, uav2","role":"perceive","componel":"t14","block":"b15","task":500047000,"of":2,"type":"goto","because":"b13 ended"}
{"at":47,"node":"uav2","kind":"task","uav":"uav2","task":500047000,"type":"goto","state":"scheduled"}
{"at":48,"node":"uav2","kind":"task","uav":"uav2","task":500047000,"type":"goto","state":"started"}
{"at":49,"node":"uav2","kind":"task","uav":"uav2","task":500047000,"type":"goto","state":"running"}
{"at":50,"node":"sim","kind":"telemetry","uav":"uav2","position":[0,0,0],"velocity":[0,0,0],"heading":0,"energy":1,"airborne":true}
{"at":61,"node":"uav2","kind":"task","uav":"uav2","task":500047000,"type":"goto","state":"aborted","reason":"no energy"}
)");

  const auto text = explain(read.journal, "uav2", 500047000);
  const auto all = explain(read.journal, "uav2", std::nullopt);

  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text,
            "uav2\n"
            "  500047000 goto\n"
            "    for        2 watch(P1) of uav1, uav2\n"
            "    role       perceive: t14 of block b15\n"
            "    asked      when b13 ended, 47.0 s\n"
            "    start      48.0 s actually\n"
            "    end        61.0 s actually (aborted)\n"
            "    because    no energy\n");
  EXPECT_THAT(*all, HasSubstr("Tasks of its roles\n  500047000 goto\n"));
}

TEST(Explain, RefusesUavsAndTasksThatTheLogDoesNotKnow) {
  const Journal journal = testing::deliberated();

  const auto uav = explain(journal, "karna", std::nullopt);
  const auto task = explain(journal, "karma", 999);

  ASSERT_FALSE(uav.has_value());
  EXPECT_THAT(uav.error().why, HasSubstr("did you mean 'karma'?"));
  ASSERT_FALSE(task.has_value());
  EXPECT_THAT(task.error().why,
              HasSubstr("no plan of karma ever held a task 999, and no role asked for it"));
}

TEST(Explain, OfAUavWithoutPlansSaysSo) {
  Journal journal;
  journal.telemetry = {testing::telemetry(0, "a", {0, 0, 0})};

  const auto text = explain(journal, "a", std::nullopt);

  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(*text, "a\nHigh-level tasks: none\nElementary tasks: none\nDecisions: none\n");
}

}  // namespace
}  // namespace skein::report
