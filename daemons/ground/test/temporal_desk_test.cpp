// SPDX-License-Identifier: Apache-2.0
#include "skein/ground/temporal_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/team_translation/meetings.hpp"

namespace skein::ground {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr temporal::Ticks kSecond = 1'000'000'000;

temporal::Frontier coming(temporal::Ticks seconds) {
  const temporal::Ticks at = seconds * kSecond;
  return {{{500, {"heliv", "marvin"}, {"heliv", "marvin"}}}, {{0, 2, at, at, at}}};
}

class Desk {
 public:
  explicit Desk(bool supervises = true) : desk_(roster_, supervises) {}

  std::optional<node::Effects> hear(const std::string& from, const std::string& about,
                                    const temporal::Frontier& frontier) {
    return give(node::Received{number(from), translation::to_wire(about, frontier)});
  }
  std::optional<node::Effects> give(const node::Input& input) {
    return desk_.hear(input, MissionTime::seconds(1));
  }
  node::NodeNumber number(const std::string& name) const { return roster_.find(name)->number; }

 private:
  node::Roster roster_{{"marvin", "heliv", "karma"}};
  TemporalDesk desk_;
};

std::vector<node::Send> sent(const std::optional<node::Effects>& effects) {
  std::vector<node::Send> found;
  for (const node::Effect& effect : effects.value())
    if (const auto* send = std::get_if<node::Send>(&effect)) found.push_back(*send);
  return found;
}

TEST(TemporalDesk, TellsWhoMeetsOneWhenThatComes) {
  Desk desk;

  const auto words = sent(desk.hear("heliv", "heliv", coming(40)));

  ASSERT_THAT(words, SizeIs(1));
  EXPECT_EQ(words[0].to, desk.number("marvin"));
  const auto& word = std::get<wire::PlanFrontier>(words[0].sample);
  EXPECT_EQ(word.uav, "heliv");
  EXPECT_EQ(word.header.instance, desk.number("heliv").value());
  EXPECT_EQ(word.arcs.at(0).soonest, 40 * kSecond);
}

TEST(TemporalDesk, NobodySpeaksForAnother) {
  EXPECT_THAT(Desk().hear("karma", "heliv", coming(40)).value(), IsEmpty());
}

TEST(TemporalDesk, WhatMakesNoSenseIsAsIfItHadNotCome) {
  temporal::Frontier wrong = coming(40);
  wrong.arcs.push_back({2, 2, 1, 1, 1});

  EXPECT_THAT(Desk().hear("heliv", "heliv", wrong).value(), IsEmpty());
}

// It may have begun, unheard, what it had not begun at its last word.
TEST(TemporalDesk, OfWhoIsOutOfReachTheLastWordCounts) {
  Desk desk;
  const temporal::Ticks way = 30 * kSecond;
  desk.hear("heliv", "heliv",
            {coming(0).meetings, {{temporal::Frontier::kPresent, 2, way, way, way}}});

  const auto words = sent(desk.give(node::Reachability{desk.number("heliv"), false, false}));

  ASSERT_THAT(words, SizeIs(1));
  const auto& word = std::get<wire::PlanFrontier>(words[0].sample);
  EXPECT_EQ(word.arcs.at(0).from, temporal::Frontier::kOrigin);
  EXPECT_EQ(word.arcs.at(0).soonest, 31 * kSecond);
}

TEST(TemporalDesk, WhereItIsNotAskedForItSaysNothing) {
  EXPECT_THAT(Desk(false).hear("heliv", "heliv", coming(40)).value(), IsEmpty());
}

TEST(TemporalDesk, LeavesEverythingElseToOthers) {
  Desk desk;

  EXPECT_FALSE(desk.give(node::Wakeup{}));
  EXPECT_FALSE(desk.give(node::Received{desk.number("heliv"), wire::PlanBoard{}}));
}

}  // namespace
}  // namespace skein::ground
