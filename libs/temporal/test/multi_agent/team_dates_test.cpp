// SPDX-License-Identifier: Apache-2.0
// When the others come, by examples and against Floyd and Warshall on the network of a whole team.
#include "skein/temporal/team_dates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "test_cases.hpp"
#include "testing/random_team.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;

constexpr Ticks kSecond = kTicksPerSecond;
MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

const Meeting kMeeting{501, {"heliv", "marvin"}, {"heliv", "marvin"}};

/// Comes to the meeting between so many seconds, is done a second after at the earliest.
Frontier coming(Ticks soonest, Ticks slowest, Meeting meeting = kMeeting) {
  Frontier frontier{{std::move(meeting)}, {}};
  const Ticks most = slowest == kInfinite ? kInfinite : slowest * kSecond;
  const Ticks fixed = slowest == kInfinite ? kMinusInfinite : most;
  frontier.arcs = {{0, 2, soonest * kSecond, most, fixed}, {2, 3, kSecond, kSecond, kSecond}};
  return frontier;
}
/// It is to be done with it by then.
Frontier until(Frontier frontier, Ticks seconds) {
  frontier.arcs.push_back({3, 0, kMinusInfinite, kMinusInfinite, -seconds * kSecond});
  return frontier;
}

TeamDates marvins(const Frontier& own, const Frontier& others) {
  TeamDates dates("marvin");
  dates.say(own);
  dates.hear("heliv", others);
  return dates;
}

TEST(TeamDates, AMeetingEndsNoEarlierThanTheOtherComes) {
  const auto dates = marvins(coming(10, 20), coming(40, 70)).dates(at(0));

  EXPECT_EQ(dates.at(501).soonest, at(40));
  EXPECT_EQ(dates.at(501).slowest, at(70));
  EXPECT_EQ(dates.at(501).last, "heliv");
  EXPECT_FALSE(dates.at(501).all_there);
}

TEST(TeamDates, WhoWasToComeBeforeNowComesNow) {
  Frontier others = coming(40, 70);
  others.arcs.push_back({Frontier::kPresent, 2, 0, 0, 0});

  EXPECT_EQ(marvins(coming(10, 20), others).dates(at(60)).at(501).soonest, at(60));
}

TEST(TeamDates, WhoHasComeIsThere) {
  Frontier others = coming(40, 40);
  EXPECT_FALSE(marvins(coming(10, 20), others).dates(at(41)).at(501).all_there);

  others.arcs.push_back({2, 0, kMinusInfinite, kMinusInfinite, -40 * kSecond});
  EXPECT_TRUE(marvins(coming(10, 20), others).dates(at(41)).at(501).all_there);
}

TEST(TeamDates, ItHasToBeThereWhenTheOtherIsToBeDone) {
  const auto dates = marvins(coming(10, 20), until(coming(40, 70), 90)).dates(at(0));

  ASSERT_TRUE(dates.at(501).needed);
  EXPECT_EQ(*dates.at(501).needed, MissionTime::nanoseconds(90 * kSecond - 1));
  EXPECT_EQ(dates.at(501).needed_by, "heliv");
}

TEST(TeamDates, ItsOwnBoundsAreNoBodyElses) {
  EXPECT_EQ(marvins(until(coming(10, 20), 30), coming(40, 70)).dates(at(0)).at(501).needed,
            std::nullopt);
}

TEST(TeamDates, WhomNoFigureBoundsComesAtNoKnownDate) {
  const auto dates = marvins(coming(10, 20), coming(40, kInfinite)).dates(at(0));

  EXPECT_EQ(dates.at(501).soonest, at(40));
  EXPECT_EQ(dates.at(501).slowest, MissionTime::max());
}

TEST(TeamDates, OfAMeetingThatTheOtherDoesNotPlanNothingIsKnown) {
  EXPECT_THAT(marvins(coming(10, 20), {}).dates(at(0)), IsEmpty());

  TeamDates dates = marvins(coming(10, 20), coming(40, 70));
  dates.forget("heliv");
  EXPECT_THAT(dates.dates(at(0)), IsEmpty());
}

// Late is better than never.
TEST(TeamDates, OfAMeetingThatOnlyTheOtherPlansTheDatesAreKnownBeforeButNoNeed) {
  const auto dates = marvins({}, until(coming(40, 70), 90)).dates(at(0));

  EXPECT_EQ(dates.at(501).soonest, at(40));
  EXPECT_EQ(dates.at(501).needed, std::nullopt);
}

TEST(TeamDates, WhoOnlySendsWaitsForNobody) {
  const Meeting signal{502, {"marvin"}, {"heliv"}};
  const auto dates =
      marvins(coming(10, 20, signal), until(coming(40, 70, signal), 90)).dates(at(0));

  EXPECT_EQ(dates.at(502).soonest, MissionTime());
  EXPECT_FALSE(dates.at(502).all_there);
  EXPECT_EQ(dates.at(502).needed, MissionTime::nanoseconds(90 * kSecond - 1));
}

/// Goes from one meeting to the next.
Frontier round_of(const std::vector<Meeting>& meetings) {
  Frontier frontier{meetings, {}};
  for (std::uint32_t node = 2; node < Frontier::arrival_of(meetings.size()); ++node)
    frontier.arcs.push_back({node == 2 ? 0 : node - 1, node, 0, 0, 0});
  return frontier;
}
/// With both in both.
Frontier two(MeetingId first, MeetingId second) {
  const std::vector<std::string> both{"heliv", "marvin"};
  return round_of({{first, both, both}, {second, both, both}});
}

// Heliv has not begun the 30 s of its way at its last word: it may have begun at once.
TEST(TeamDates, OfWhoIsOutOfReachNothingIsSaidAboutTheTimeSince) {
  const std::vector<std::string> both{"heliv", "marvin"};
  const Frontier way{{{1, both, both}},
                     {{Frontier::kPresent, 2, 30 * kSecond, 40 * kSecond, 40 * kSecond}}};
  TeamDates dates = marvins(round_of({{1, both, both}}), way);
  EXPECT_EQ(dates.dates(at(20)).at(1).soonest, at(50));
  EXPECT_EQ(dates.dates(at(80)).at(1).soonest, at(110));

  dates.out_of_reach("heliv", at(20));
  EXPECT_EQ(dates.dates(at(80)).at(1).soonest, at(50));
  EXPECT_EQ(dates.dates(at(80)).at(1).slowest, at(60));
  dates.out_of_reach("heliv", std::nullopt);
  EXPECT_EQ(dates.dates(at(80)).at(1).soonest, at(110));
}

// Marvin waits at 1 and goes on to 2; heliv the other way round.
TEST(TeamDates, TwoThatWaitForEachOtherNeverCome) {
  const auto dates = marvins(two(1, 2), two(2, 1)).dates(at(0));

  EXPECT_EQ(dates.at(1).soonest, MissionTime::max());
  EXPECT_EQ(dates.at(2).soonest, MissionTime());  // there he can be met
}

TEST(TeamDates, OfTwoThatWaitForEachOtherOneGivesWay) {
  TeamDates helivs("heliv");
  helivs.say(two(2, 1));
  helivs.hear("marvin", two(1, 2));

  EXPECT_EQ(marvins(two(1, 2), two(2, 1)).dates(at(0)).at(1).behind, std::nullopt);
  EXPECT_EQ(helivs.dates(at(0)).at(2).behind, MeetingId{1});
}

// Heliv at 1, waits for karma; marvin for heliv, and karma, for marvin, at 2 and 3.
TEST(TeamDates, WhoIsAlreadyThereGivesNoWayBeforeOneWhoIsNot) {
  const auto meets = [](MeetingId id, const char* a, const char* b) {
    return Meeting{id, {a, b}, {a, b}};
  };
  const Meeting first = meets(1, "heliv", "karma"), second = meets(2, "heliv", "marvin"),
                third = meets(3, "karma", "marvin");
  const auto all = [&](const char* self, bool marvin_is_there) {
    TeamDates dates(self);
    Frontier marvins = round_of({third, second});
    if (marvin_is_there) marvins.arcs.push_back({2, 0, kMinusInfinite, kMinusInfinite, 0});
    dates.hear("heliv", round_of({second, first}));
    dates.hear("karma", round_of({first, third}));
    dates.hear("marvin", marvins);
    return dates.dates(at(0));
  };

  EXPECT_EQ(all("marvin", false).at(3).behind, MeetingId{2});
  EXPECT_EQ(all("heliv", false).at(2).behind, std::nullopt);
  EXPECT_EQ(all("marvin", true).at(3).behind, std::nullopt);
  EXPECT_EQ(all("heliv", true).at(2).behind, MeetingId{1});
}

// Marvin meets heliv at 3 and 1, heliv marvin at 1 and 3; in between marvin would meet at 2 whom
// nobody hears of any more.
TEST(TeamDates, WhoGivesWayWithAMeetingThatOthersHaveGivenUpIsToldSo) {
  const Meeting first{1, {"heliv", "marvin"}, {"heliv", "marvin"}};
  const Meeting given_up{2, {"heliv", "karma", "marvin"}, {"heliv", "karma", "marvin"}};
  const Meeting third{3, {"heliv", "marvin"}, {"heliv", "marvin"}};
  TeamDates dates("marvin");
  dates.say(round_of({third, given_up, first}));
  dates.hear("heliv", round_of({first, third}));
  dates.hear("karma", {});

  const auto all = dates.dates(at(0));

  ASSERT_TRUE(all.contains(2));
  EXPECT_EQ(all.at(2).behind, MeetingId{1});
  EXPECT_EQ(all.at(2).last, "") << "nothing is known of its date";
  EXPECT_EQ(all.at(3).behind, std::nullopt);
}

// ---- orders between ways ----

const MeetingId kOrder = order_of("marvin");

/// Marvin flies 10 s once heliv has left his air, and comes then to the meeting with karma.
Frontier waiting_for_air() {
  const Meeting order{kOrder, {"heliv"}, {"marvin"}}, then{1, {"karma", "marvin"}, {"karma"}};
  return {{order, then},
          {{Frontier::kPresent, 4, 10, 10, 10}, {3, 4, kMinusInfinite, 10, kMinusInfinite}}};
}
Frontier leaving_between(Ticks soonest, Ticks slowest) {
  return {{{kOrder, {"heliv"}, {"marvin"}}}, {{0, 2, soonest, slowest, kMinusInfinite}}};
}
Frontier karmas() { return {{{1, {"karma", "marvin"}, {"karma"}}}, {{0, 2, 5, 5, 5}}}; }

TEST(TeamDates, OrdersBetweenWaysHaveNumbersOfTheirOwn) {
  EXPECT_TRUE(is_order(kOrder));
  EXPECT_NE(kOrder, order_of("heliv"));
  EXPECT_FALSE(is_order(501));
}

// He may get air elsewhere before: what comes of it is no earlier for that.
TEST(TeamDates, WhoWaitsForAirFliesAtTheLatestWhenTheOtherHasLeftIt) {
  TeamDates karma("karma");
  karma.say(karmas());
  karma.hear("marvin", waiting_for_air());
  karma.hear("heliv", leaving_between(100, 300));
  TeamDates marvin("marvin");
  marvin.say(waiting_for_air());
  marvin.hear("heliv", leaving_between(100, 300));

  EXPECT_EQ(karma.dates(MissionTime()).at(1).soonest, MissionTime::nanoseconds(10));
  EXPECT_EQ(karma.dates(MissionTime()).at(1).slowest, MissionTime::nanoseconds(311));
  EXPECT_EQ(marvin.dates(MissionTime()).at(kOrder).slowest, MissionTime::nanoseconds(300));
  EXPECT_EQ(marvin.dates(MissionTime()).at(kOrder).last, "heliv");
}

TEST(TeamDates, WhoseAirIsWaitedForWaitsForNobody) {
  TeamDates heliv("heliv");
  heliv.say(leaving_between(100, 300));
  heliv.hear("marvin", waiting_for_air());

  EXPECT_THAT(heliv.dates(MissionTime()), IsEmpty());
}

// Heliv leaves only after the meeting to which marvin comes behind his flight.
TEST(TeamDates, AnOrderThatWaitsForItselfHasNoFigure) {
  Frontier heliv{{{kOrder, {"heliv"}, {"marvin"}}, {1, {"marvin"}, {"heliv"}}},
                 {{0, 4, 1, 1, 1}, {4, 5, 1, 1, 1}, {5, 2, 1, 1, 1}}};
  Frontier marvin = waiting_for_air();
  marvin.meetings[1] = {1, {"marvin"}, {"heliv"}};
  const auto dates = marvins(marvin, heliv).dates(MissionTime());

  EXPECT_EQ(dates.at(kOrder).slowest, MissionTime::max());
  EXPECT_NE(dates.at(kOrder).soonest, MissionTime::max());
}

/// Each goes to its meetings in an order of its own.
std::map<std::string, std::vector<Meeting>> random_rounds(Random& random) {
  std::map<std::string, std::vector<Meeting>> rounds;
  for (MeetingId id = 1; id <= 2 + random.below(4); ++id) {
    std::vector<std::string> all;
    for (const char* name : {"a", "b", "c", "d"})
      if (random.below(3) != 0) all.emplace_back(name);
    for (const std::string& name : all) {
      auto& round = rounds[name];
      round.insert(round.begin() + static_cast<std::ptrdiff_t>(random.below(round.size() + 1)),
                   {id, all, all});
    }
  }
  return rounds;
}

TEST(TeamDates, WhoGiveWayPartAllThatWaitForEachOther) {
  const auto seeds = skein::testing::cases<std::uint64_t>(300, 10'000);
  int parted = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Random random(seed);
    auto rounds = random_rounds(random);
    for (int step = 0;; ++step) {
      ASSERT_LT(step, 40) << "seed " << seed;
      bool never = false;
      std::map<std::string, std::map<MeetingId, MeetingId>> give_way;
      for (const auto& [name, own] : rounds) {
        TeamDates dates(name);
        for (const auto& [other, round] : rounds) dates.hear(other, round_of(round));
        for (const auto& [id, found] : dates.dates(at(0))) {
          never = never || found.soonest == MissionTime::max();
          if (found.behind) give_way[name][id] = *found.behind;
        }
      }
      ASSERT_EQ(never, !give_way.empty()) << "seed " << seed;
      if (!never) break;
      ++parted;
      for (const auto& [name, moves] : give_way) {
        for (const auto& [id, behind] : moves) {
          auto& round = rounds[name];
          const auto is = [](MeetingId which) {
            return [which](const Meeting& one) { return one.id == which; };
          };
          const auto from = std::find_if(round.begin(), round.end(), is(id));
          const auto to = std::find_if(from, round.end(), is(behind));
          ASSERT_NE(to, round.end()) << "seed " << seed;
          std::rotate(from, std::next(from), std::next(to));
        }
      }
    }
  }
  EXPECT_GT(parted, static_cast<int>(seeds) / 4);
}

// Whatever frontiers come over the radio.
TEST(TeamDates, OfFrontiersWithoutSenseAreSomeDates) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    TeamDates dates("a");
    for (const char* name : {"a", "b", "c"}) {
      Frontier frontier;
      const std::size_t meetings = random.below(5);
      for (std::size_t i = 0; i < meetings; ++i)
        frontier.meetings.push_back({random.below(4) + 10 * i, {"a", "b"}, {"b", "a", "c", "c"}});
      const auto figure = [&]() -> Ticks {
        if (random.below(4) == 0) return kMinusInfinite;
        return static_cast<Ticks>(random.below(2 * std::uint64_t{kFarthest})) - kFarthest;
      };
      const auto inner = static_cast<std::uint32_t>(random.below(4));
      const std::uint32_t nodes = Frontier::arrival_of(meetings) + inner;
      for (std::size_t i = 0; i < 3 * nodes; ++i) {
        const auto from = static_cast<std::uint32_t>(random.below(nodes));
        const auto to = static_cast<std::uint32_t>(random.below(nodes));
        const Ticks slowest = random.below(5) == 0 ? kInfinite : figure();
        if (from != to) frontier.arcs.push_back({from, to, figure(), slowest, figure()});
      }
      for (std::size_t i = 2; i < Frontier::arrival_of(meetings); ++i)
        if (random.below(3) == 0)
          frontier.bases.push_back(
              {static_cast<std::uint32_t>(i), {{"a", 10 * random.below(4)}, {"c", 1}}});
      ASSERT_EQ(fault_of(frontier), std::nullopt);
      dates.hear(name, frontier);
    }
    for (const char* name : {"b", "c", "d"})
      EXPECT_LE(dates.bounds_for(name).meetings.size(), kMostMeetings);

    for (const auto& [meeting, found] : dates.dates(at(100)))
      EXPECT_TRUE(found.last.empty() || found.last == "a" || found.last == "b") << meeting;
  }
}

// ---- against the whole ----

struct Found {
  int all = 0, never = 0, needed = 0, endless = 0;
};

/// Plans change four times; each time all hear the last words, and each agent's dates are compared.
void hear_and_compare(std::uint64_t seed, bool orders, Found& found) {
  RandomTeam team(seed, orders);
  for (int change = 0; change < 4; ++change) {
    team.change();
    team.deliver();
    for (const std::string& agent : team.agents()) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + agent);
      auto known = team.heard_by(agent).dates(team.now());
      const auto expected = team.dates_of(agent);
      std::erase_if(known, [&](const auto& one) {  // that it gives way is all that is said of it
        return one.second.behind && !expected.contains(one.first);
      });
      ASSERT_EQ(known.size(), expected.size());
      for (const auto& [meeting, dates] : known) {
        const OracleDates& right = expected.at(meeting);
        ASSERT_EQ(dates.soonest, right.soonest) << meeting;
        ASSERT_EQ(dates.slowest, right.slowest) << meeting;
        ASSERT_EQ(dates.needed, right.needed) << meeting;
        const bool never = dates.soonest == MissionTime::max();
        ++found.all;
        found.never += never ? 1 : 0;
        found.needed += dates.needed ? 1 : 0;
        found.endless += !never && dates.slowest == MissionTime::max() ? 1 : 0;
      }
    }
  }
}

TEST(TeamDates, AreThoseOfTheWholeTeamOnceAllHaveHeardTheLastWords) {
  const auto seeds = skein::testing::cases<std::uint64_t>(300, 10'000);
  Found found;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    hear_and_compare(seed, false, found);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found.needed, found.all / 10);
  EXPECT_GT(found.never, found.all / 100);
  EXPECT_LT(found.never, found.all / 2);
}

// Who waits for its air comes by when those in its way have left, and who meets it knows.
TEST(TeamDates, WithOrdersBetweenWaysAreThoseOfTheWholeTeam) {
  const auto seeds = skein::testing::cases<std::uint64_t>(300, 10'000);
  Found found;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    hear_and_compare(seed, true, found);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(found.needed, found.all / 20);
  EXPECT_GT(found.endless, found.all / 20);
  EXPECT_LT(found.never, found.all / 2);
}

// Who was cut off has the last word that it heard, and nothing else is wanted once the cut is over.
TEST(TeamDates, AfterACutOneLastWordOfEachServes) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomTeam team(seed), quiet(seed);
    for (int change = 0; change < 6; ++change) {
      team.change();
      quiet.change();
      quiet.deliver();
      if (change % 3 == 2) team.deliver();
    }
    for (const std::string& agent : team.agents())
      ASSERT_EQ(team.heard_by(agent).dates(team.now()), quiet.heard_by(agent).dates(quiet.now()))
          << "seed " << seed;
  }
}

}  // namespace
}  // namespace skein::temporal::testing
