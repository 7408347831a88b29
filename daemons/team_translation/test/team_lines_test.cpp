// SPDX-License-Identifier: Apache-2.0
// What the event log says of sales and owners.
#include "skein/team_translation/team_lines.hpp"

#include <gtest/gtest.h>

namespace skein::translation {
namespace {

using auction::MemberNumber;
using auction::TaskNumber;

const Writer kWriter{MissionTime::seconds(3), "marvin"};

std::string line_of(const auction::SaleEffect& effect) {
  const auto lines = sale_lines(kWriter, effect, team::Roster({"marvin", "heliv"}));
  return lines.empty() ? "" : to_json(lines.front());
}

TEST(TeamLines, ASaleSaysToWhomForWhatAndWhoCameNext) {
  auction::Sold sold;
  sold.task = TaskNumber(11);
  sold.members = {MemberNumber(0)};
  sold.value.first = 12.34567;
  EXPECT_EQ(line_of(sold),
            R"({"at":3,"node":"marvin","kind":"sale","state":"sold","task":11,"to":"marvin",)"
            R"("value":12.346,"why":"nobody else could"})");

  sold.trade = true;
  sold.next_best = auction::Sold::Rival{{MemberNumber(1)}, {0, 15, 0}};
  EXPECT_EQ(line_of(sold),
            R"({"at":3,"node":"marvin","kind":"sale","state":"traded","task":11,"to":"marvin",)"
            R"("value":12.346,"next_best":"heliv","next_value":15})");
}

TEST(TeamLines, WhatNobodyTakesIsToldWithTheReasonOfEach) {
  auction::Unsold unsold;
  unsold.task = TaskNumber(11);
  unsold.reasons = {{MemberNumber(0), "no camera"}, {MemberNumber(1), "too far"}};
  EXPECT_EQ(line_of(unsold), R"({"at":3,"node":"marvin","kind":"sale","state":"unsold","task":11,)"
                             R"("why":"marvin: no camera; heliv: too far"})");
}

TEST(TeamLines, WhoIsDroppedAndWhatContradictsItselfIsTold) {
  EXPECT_EQ(line_of(auction::Dropped{MemberNumber(1), 2, "did not answer a call"}),
            R"({"at":3,"node":"marvin","kind":"sale","state":"dropped","uav":"heliv",)"
            R"("why":"did not answer a call"})");
  auction::Rejected rejected;
  rejected.contradictions = {{{TaskNumber(1), TaskNumber(2)}, "too long"}};
  EXPECT_EQ(line_of(rejected),
            R"({"at":3,"node":"marvin","kind":"sale","state":"rejected","tasks":"1 2",)"
            R"("why":"too long"})");
  EXPECT_EQ(line_of(auction::Ended{}), "");
}

TEST(TeamLines, AnOwnerIsToldWithTheStageTheSaleAndWhy) {
  team::TaskStanding standing;
  standing.task = mission::GoalId(11);
  standing.statement = "look P1";
  standing.stage = auction::Stage::kOwned;
  standing.owners = {"marvin", "heliv"};
  standing.sale = 4;
  standing.why = "sold to marvin, heliv for 3 s";

  EXPECT_EQ(to_json(owner_line(kWriter, standing)),
            R"({"at":3,"node":"marvin","kind":"owner","task":11,"statement":"look P1",)"
            R"("stage":"owned","sale":4,"owners":"marvin, heliv",)"
            R"("why":"sold to marvin, heliv for 3 s"})");
}

TEST(TeamLines, TheTokenIsTakenInATermAndLost) {
  EXPECT_EQ(to_json(token_line(kWriter, true, 2)),
            R"({"at":3,"node":"marvin","kind":"token","uav":"marvin","state":"taken","term":2})");
  EXPECT_EQ(to_json(token_line(kWriter, false, 0)),
            R"({"at":3,"node":"marvin","kind":"token","uav":"marvin","state":"lost"})");
}

}  // namespace
}  // namespace skein::translation
