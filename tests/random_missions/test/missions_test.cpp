// SPDX-License-Identifier: Apache-2.0
// Random missions keep the laws of truth (libs/laws). SKEIN_MISSIONS says how many;
// the command skein_random_missions plays any others.
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "skein/laws/laws.hpp"
#include "skein/mission_lab/generate.hpp"
#include "skein/storm_tool/judge.hpp"
#include "test_cases.hpp"

namespace skein::mission_lab {
namespace {

using storm_tool::Case;
using storm_tool::JudgeOptions;
using storm_tool::Verdict;

/// Seconds of processor time for a mission.
constexpr int kPatience = 120;

std::uint64_t missions() {
  const char* wanted = std::getenv("SKEIN_MISSIONS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10)
                           : testing::cases<std::uint64_t>(75, 5000);
}

// Each mission that breaks a law, with its breaches.
std::string breaches(const Kinds& kinds, std::uint64_t missions,
                     Mission (*draw)(std::uint64_t, const Kinds&) = generate,
                     std::uint64_t first = 1) {
  std::uint64_t seed = first;
  std::string text;
  JudgeOptions options;
  options.patience = kPatience;
  options.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  judge(
      [&](Case& next) {
        if (seed >= first + missions) return false;
        next = {std::to_string(seed), to_yaml(draw(seed, kinds), ".."),
                SKEIN_SOURCE_DIR "/scenarios/comets/drawn.yaml"};
        ++seed;
        return true;
      },
      options,
      [&](const Case& what, const Verdict& verdict) {
        if (!verdict.valid) text += "mission " + what.name + ": " + verdict.problem + "\n";
        if (!verdict.violations.empty()) {
          text += "mission " + what.name + ":\n" + laws::to_text(verdict.violations);
        }
      });
  return text;
}

TEST(RandomMissions, KeepTheLawsWhateverGoesWrong) { EXPECT_EQ(breaches({}, missions()), ""); }

TEST(RandomMissions, KeepTheLawsWhenNothingGoesWrong) {
  EXPECT_EQ(breaches(kClean, missions()), "");
}

// Ground station, simulator and decision nodes, up to three times: a node that comes back with what
// it knew is excused nothing.
TEST(RandomMissions, KeepTheLawsWhenDaemonsDieAndComeBack) {
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, missions() / 6), "");
  deaths = kClean;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, missions() / 6), "");
}

// At degree 5: no task begun twice, none without an owner once the network has healed.
TEST(RandomMissions, TeamsKeepTheLawsWhenNothingGoesWrongAndWhenSomethingDoes) {
  EXPECT_EQ(breaches(kClean, missions() / 10, generate_team), "");
  Kinds trouble;
  trouble.deaths = true;
  EXPECT_EQ(breaches(trouble, missions() / 10, generate_team), "");
}

// Two to eight UAVs that merge their ways: they keep their separation, and all of them move on.
TEST(RandomMissions, UavsWhoseWaysCrossKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_crossing), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_crossing), "");
}

// Two to five UAVs that meet: nobody comes before it was foretold, and what fails says why.
TEST(RandomMissions, UavsThatMeetKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_meetings), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_meetings), "");
}

// One of them dies, is cut off or stays away in whatever phase: who waits for it does so for its
// lease.
TEST(RandomMissions, UavsWhosePartnersStayAwayKeepTheLaws) {
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, missions() / 5, generate_partners), "");
}

// Areas mapped together, one or two, with work before and after them.
TEST(RandomMissions, UavsThatMapTogetherKeepTheLawsAndAchieveAll) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_sharing), "");
}

// One of them leaves, comes late, is cut off or dies, and may come back to it.
TEST(RandomMissions, UavsThatMapTogetherWithoutOneForAWhileKeepTheLaws) {
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches({}, missions() / 10, generate_sharing), "");
  EXPECT_EQ(breaches(deaths, missions() / 10, generate_sharing), "");
}

// They watch, escort or pursue what moves, from places that they agree on.
TEST(RandomMissions, UavsThatEscortTogetherKeepTheLawsAndAchieveAll) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_escorts), "");
}

// One of them leaves, is cut off or is taken in hand; the ground station plays for another.
TEST(RandomMissions, UavsThatEscortWithoutOneForAWhileKeepTheLaws) {
  EXPECT_EQ(breaches({}, missions() / 5, generate_escorts), "");
}

// Over what they are to do, their pads and their ways, from the start or as they fly.
TEST(RandomMissions, UavsOverWhichAirClosesForATimeKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_closures), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_closures), "");
}

// However plans are kept consistent, dates are foretold and kept.
TEST(RandomMissions, UavsThatMeetKeepTheLawsByEachAlgorithm) {
  for (const char* consistency : {"dip-l", "dip-g", "cip"}) {
    Kinds kinds;
    kinds.consistency = consistency;
    EXPECT_EQ(breaches(kinds, missions() / 10, generate_meetings), "") << consistency;
  }
}

// A joint task of two of them between their meetings: nobody waits for ever for one who waits for
// it.
TEST(RandomMissions, UavsThatMeetAndActJointlyKeepTheLaws) {
  Kinds kinds;
  kinds.gatherings = true;
  EXPECT_EQ(breaches(kinds, missions() / 10, generate_meetings), "");
}

// At one height, so that each is in the way of others: nobody waits for air to the end.
TEST(RandomMissions, UavsThatMeetAtOneHeightKeepTheLaws) {
  Kinds kinds;
  kinds.orders = true;
  EXPECT_EQ(breaches(kinds, missions() / 5, generate_meetings), "");
}

// Both: who has nothing to do but to wait for partners is in nobody's way for ever.
TEST(RandomMissions, UavsThatActJointlyAtOneHeightKeepTheLaws) {
  Kinds kinds;
  kinds.gatherings = kinds.orders = true;
  EXPECT_EQ(breaches(kinds, missions() / 5, generate_meetings), "");
}

// One to four UAVs over fires that spread: what is followed was where it was said to be.
TEST(RandomMissions, UavsOverFiresThatSpreadKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_fires), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_fires), "");
}

// A team, others with missions of their own, robots, fires, relays and operators.
TEST(RandomMissions, OfAllOfItAtOnceKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 10, generate_mixed), "");
}

// Taken over by the ground station while it waits for its air; dates handed around a circle (2).
TEST(RandomMissions, OfAllOfItAtOnceKeepTheLawsTheyBrokeOnce) {
  EXPECT_EQ(breaches({}, 1, generate_mixed, 7), "");
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, 1, generate_mixed, 1028), "");
  EXPECT_EQ(breaches(kClean, 1, generate_mixed, 2057), "");
}

// Operators fly them by elementary tasks, wrong ones too.
TEST(RandomMissions, VehiclesThatOperatorsFlyByHandKeepTheLaws) {
  EXPECT_EQ(breaches({}, missions() / 2, generate_orders), "");
}

// Left behind for a plan to wait for (169, 781); landed while it got out of the way (682); refused
// with a reason that was there no more (all with a wrong order and ways that are merged); left in
// the air at degree 4 with little energy after its deliberation was stopped (7256).
TEST(RandomMissions, VehiclesThatOperatorsFlyByHandKeepTheLawsTheyBrokeOnce) {
  for (const std::uint64_t seed : {169, 682, 771, 781, 7256})
    EXPECT_EQ(breaches({}, 1, generate_orders, seed), "") << seed;
}

// Two to six vehicles, some of which keep to the ground.
TEST(RandomMissions, RobotsOnTheGroundKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_robots), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_robots), "");
}

// Two to six UAVs, some of whom are heard past relays alone: nothing is lost without a word.
TEST(RandomMissions, UavsThatAreHeardPastRelaysKeepTheLaws) {
  EXPECT_EQ(breaches(kClean, missions() / 5, generate_relays), "");
  EXPECT_EQ(breaches({}, missions() / 5, generate_relays), "");
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, missions() / 5, generate_relays), "");
}

// What others said of their ways and meetings is known again to who was away.
TEST(RandomMissions, WhatUavsAgreedUponSurvivesTheDeathOfDaemons) {
  Kinds deaths;
  deaths.deaths = true;
  EXPECT_EQ(breaches(deaths, missions() / 10, generate_crossing), "");
  EXPECT_EQ(breaches(deaths, missions() / 10, generate_robots), "");
  deaths.gatherings = true;
  EXPECT_EQ(breaches(deaths, missions() / 10, generate_meetings), "");
}

}  // namespace
}  // namespace skein::mission_lab
