// SPDX-License-Identifier: Apache-2.0
// A run as facts with names.
#include "facts.hpp"

#include <gtest/gtest.h>

#include "story.hpp"

namespace skein::compare_tool {
namespace {

std::map<std::string, Fact> facts_in(const std::string& section, std::vector<Record> records) {
  for (Section& one : facts_of(run_of(std::move(records))))
    if (one.name == section) return one.facts;
  return {};
}

TEST(Facts, OfTheOutcomeAreHowAndWhenItEnded) {
  const auto facts = facts_in("outcome", {finished(100), line(102, "sim", "telemetry")});

  EXPECT_EQ(facts.at("mission"), (Fact{"finished", 100, {}}));
  EXPECT_EQ(facts.at("last line").at, 102);
}

TEST(Facts, OfATaskAreWhenItBeganAndWasOver) {
  const auto facts =
      facts_in("tasks", {task(1, "scheduled"), task(5, "started"), task(6, "running"),
                         task(40, "aborted").with("reason", "wind")});

  EXPECT_EQ(facts.at("marvin task 104 goto, begun").at, 5);
  EXPECT_EQ(facts.at("marvin task 104 goto, over"), (Fact{"aborted: wind", 40, {}}));
  EXPECT_EQ(facts.size(), 2U);
}

TEST(Facts, OfAGoalAreItsLastStateAndWhy) {
  const auto facts =
      facts_in("goals", {goal(1, "received"), goal(9, "failed").with("why", "no energy")});

  EXPECT_EQ(facts.at("marvin goal 7 map Z"), (Fact{"failed: no energy", 9, {}}));
}

TEST(Facts, OfDecisionsCountOperatorsAndRefusalsAndFollowDegrees) {
  const auto decided = [](double at, const char* what) {
    return line(at, "marvin", "decision").with("uav", "marvin").with("operator", what);
  };
  const auto degree = [](double at, int now) {
    return line(at, "marvin", "degree").with("uav", "marvin").with("degree", now);
  };
  const auto facts = facts_in(
      "decisions",
      {degree(0, 4), decided(5, "repair"), decided(9, "repair"), degree(20, 1),
       line(3, "marvin", "request")
           .with("uav", "marvin")
           .with("request", "START")
           .with("accepted", false)
           .with("why", "busy"),
       line(4, "marvin", "request")
           .with("uav", "marvin")
           .with("request", "START")
           .with("accepted", true),
       line(6, "ground", "owner").with("task", 3).with("stage", "owned").with("owners", "karma")});

  EXPECT_EQ(facts.at("marvin decides repair").value, 2);
  EXPECT_EQ(facts.at("marvin degree").text, "4, then 1");
  EXPECT_EQ(facts.at("marvin refuses START: busy").value, 1);
  EXPECT_EQ(facts.at("team task 3").text, "owned by karma");
  EXPECT_EQ(facts.size(), 4U);
}

TEST(Facts, OfExpectationsSayWhatWasSeenInstead) {
  const auto verdict = [](const char* name, bool passed) {
    return line(9, "runner", "expectation")
        .with("name", name)
        .with("passed", passed)
        .with("seen", "never");
  };
  const auto facts = facts_in("expectations", {verdict("flies", true), verdict("lands", false)});

  EXPECT_EQ(facts.at("flies").text, "met");
  EXPECT_EQ(facts.at("lands").text, "not met: never");
}

TEST(Facts, OfMeasuresSayWhyThereIsNone) {
  const auto facts = facts_in("measures", {finished(100)});

  EXPECT_EQ(facts.at("mission-duration").value, 100);
  EXPECT_EQ(facts.at("distance-flown").text, "no telemetry");
}

}  // namespace
}  // namespace skein::compare_tool
