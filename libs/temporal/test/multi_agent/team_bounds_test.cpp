// SPDX-License-Identifier: Apache-2.0
// Agents that tell each other dates (DIP-L), and those that tell whole networks (DIP-G), against
// Floyd and Warshall on the network of a whole team, whatever the order in which words come.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "skein/temporal/team_dates.hpp"
#include "skein/temporal/team_supervisor.hpp"
#include "test_cases.hpp"
#include "testing/random_team.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;

const std::vector<std::string> kBoth{"heliv", "marvin"};

/// Goes from one meeting to the next, 10 ns each.
Frontier round_of(const std::vector<Meeting>& meetings) {
  Frontier frontier{meetings, {}};
  for (std::uint32_t node = 2; node < Frontier::arrival_of(meetings.size()); ++node)
    frontier.arcs.push_back({node == 2 ? 0 : node - 1, node, 10, 10, 10});
  return frontier;
}

/// They tell each other all that changed until nothing does.
class Talk {
 public:
  void plans(const std::string& name, const Frontier& own) {
    agents_.try_emplace(name, name).first->second.say(own);
  }
  const TeamDates& of(const std::string& name) const { return agents_.at(name); }

  /// Which words come first, and which are lost and come again, is drawn. Returns how many were
  /// told; nothing: it does not end.
  std::optional<int> settle(Random& random, int most = 4'000) {
    int words = 0;
    while (true) {
      std::vector<std::pair<std::string, std::string>> due;
      for (const auto& [from, dates] : agents_)
        for (const auto& [to, other] : agents_)
          if (from != to && dates.bounds_for(to) != heard_[{from, to}]) due.emplace_back(from, to);
      if (due.empty()) return words;
      if (++words > most) return std::nullopt;
      const auto& [from, to] = due[random.below(due.size())];
      const Frontier word = agents_.at(from).bounds_for(to);
      EXPECT_EQ(fault_of(word), std::nullopt);
      heard_[{from, to}] = word;
      agents_.at(to).hear(from, word);
    }
  }

 private:
  std::map<std::string, TeamDates> agents_;
  std::map<std::pair<std::string, std::string>, Frontier> heard_;
};

TEST(TeamBounds, AreDatesWithWhatOthersSaidInThem) {
  const Meeting first{1, {"heliv", "karma"}, {"heliv", "karma"}}, second{2, kBoth, kBoth};
  Talk talk;
  Random random(1);
  talk.plans("karma", {{first}, {{0, 2, 500, 700, 500}}});
  talk.plans("heliv", round_of({first, second}));
  talk.plans("marvin", round_of({second}));
  ASSERT_TRUE(talk.settle(random));

  const Frontier word = talk.of("heliv").bounds_for("marvin");
  EXPECT_THAT(word.meetings, ::testing::ElementsAre(second));
  EXPECT_THAT(word.arcs, ::testing::Contains(FrontierArc{0, 2, 511, 711, kMinusInfinite}));
  EXPECT_THAT(word.bases, ::testing::ElementsAre(FrontierBasis{2, {{"heliv", MeetingId{1}}}}));
  EXPECT_EQ(talk.of("marvin").dates(MissionTime()).at(2).soonest, MissionTime::nanoseconds(511));
}

// Heliv's date rests on marvin's: marvin's being later and then sooner again leaves no trace.
TEST(TeamBounds, NobodyFindsHisOwnDateInAnothersAfterItChanged) {
  const Meeting first{1, kBoth, kBoth}, second{2, kBoth, kBoth};
  Talk talk;
  Random random(1);
  talk.plans("heliv", round_of({first, second}));
  talk.plans("marvin", round_of({first, second}));
  ASSERT_TRUE(talk.settle(random));
  const auto before = talk.of("marvin").dates(MissionTime());

  Frontier late = round_of({first, second});
  late.arcs.push_back({0, 2, 900, 900, 900});
  talk.plans("marvin", late);
  ASSERT_TRUE(talk.settle(random));
  EXPECT_EQ(talk.of("marvin").dates(MissionTime()).at(2).soonest, MissionTime::nanoseconds(911));
  talk.plans("marvin", round_of({first, second}));
  ASSERT_TRUE(talk.settle(random));

  EXPECT_EQ(talk.of("marvin").dates(MissionTime()), before);
}

TEST(TeamBounds, TwoThatWaitForEachOtherSeeIt) {
  const Meeting first{1, kBoth, kBoth}, second{2, kBoth, kBoth};
  Talk talk;
  Random random(1);
  talk.plans("heliv", round_of({second, first}));
  talk.plans("marvin", round_of({first, second}));
  ASSERT_TRUE(talk.settle(random));

  EXPECT_EQ(talk.of("marvin").dates(MissionTime()).at(1).soonest, MissionTime::max());
  EXPECT_EQ(talk.of("heliv").dates(MissionTime()).at(2).behind, MeetingId{1});
  talk.plans("heliv", round_of({first, second}));
  ASSERT_TRUE(talk.settle(random));
  EXPECT_NE(talk.of("marvin").dates(MissionTime()).at(1).soonest, MissionTime::max());
}

// What the dates of a circle rested on is handed around in it: an end that is no more would be for
// ever.
TEST(TeamBounds, TwoThatWaitForEachOtherForgetWhatIsOver) {
  const Meeting gone{3, {"heliv", "karma"}, {"heliv", "karma"}}, first{1, kBoth, kBoth},
      second{2, kBoth, kBoth};
  Talk talk;
  Random random(1);
  talk.plans("karma", round_of({gone}));
  talk.plans("heliv", round_of({gone, second, first}));
  talk.plans("marvin", round_of({first, second}));
  ASSERT_TRUE(talk.settle(random));
  const auto rests_on = [&](const std::string& name, const std::string& other) {
    std::set<MeetingId> meetings;
    for (const FrontierBasis& basis : talk.of(name).bounds_for(other).bases)
      for (const EndOf& end : basis.ends)
        if (end.agent == "heliv") meetings.insert(end.meeting);
    return meetings;
  };
  ASSERT_TRUE(rests_on("marvin", "heliv").contains(gone.id));

  talk.plans("karma", {});
  talk.plans("heliv", round_of({second, first}));
  ASSERT_TRUE(talk.settle(random));

  EXPECT_FALSE(rests_on("heliv", "marvin").contains(gone.id));
  EXPECT_FALSE(rests_on("marvin", "heliv").contains(gone.id));
  EXPECT_EQ(talk.of("marvin").dates(MissionTime()).at(1).soonest, MissionTime::max());
}

TEST(TeamBounds, WhoHasNoMeetingsTellsNothing) {
  TeamDates dates("marvin");
  EXPECT_THAT(dates.bounds_for("heliv").meetings, IsEmpty());
}

/// How often it was so.
struct Counts {
  bool limits_of_never = true;  ///< of what never comes limits are judged too
  int all = 0, needed = 0, found_needed = 0, never = 0, endless = 0;
};

void compare(const TeamDates& dates, const RandomTeam& team, const std::string& agent,
             Counts& counts) {
  auto found = dates.dates(team.now());
  const auto expected = team.dates_of(agent);
  std::erase_if(found, [&](const auto& one) {  // that it gives way is all that is said of it
    return one.second.behind && !expected.contains(one.first);
  });
  ASSERT_EQ(found.size(), expected.size()) << agent;
  for (const auto& [meeting, one] : found) {
    const OracleDates& right = expected.at(meeting);
    ASSERT_EQ(one.soonest, right.soonest) << agent << meeting;
    ASSERT_EQ(one.slowest, right.slowest) << agent << meeting;
    const bool never = one.soonest == MissionTime::max();
    if (one.needed && !right.contradicted && (counts.limits_of_never || !never)) {
      ASSERT_TRUE(right.needed) << agent << meeting;
      ASSERT_GE(*one.needed, *right.needed) << agent << meeting;
    }
    ++counts.all;
    counts.never += never ? 1 : 0;
    counts.endless += !never && one.slowest == MissionTime::max() ? 1 : 0;
    counts.needed += right.needed ? 1 : 0;
    counts.found_needed += one.needed == right.needed && right.needed ? 1 : 0;
  }
}

/// Not all is heard before the next change.
void talk_while_plans_change(std::uint64_t seed, bool orders, Counts& counts) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  RandomTeam team(seed, orders);
  Random random(seed + 77);
  Talk talk;
  for (int change = 0; change < 4; ++change) {
    team.change();
    for (const std::string& agent : team.agents()) talk.plans(agent, team.plan_of(agent));
    if (change % 2 == 0 && random.below(2) == 0) {
      talk.settle(random, static_cast<int>(random.below(6)));
      continue;
    }
    ASSERT_TRUE(talk.settle(random)) << "does not end";
    for (const std::string& agent : team.agents()) compare(talk.of(agent), team, agent, counts);
  }
}

TEST(TeamBounds, AreThoseOfTheWholeTeamWhateverComesFirst) {
  const auto seeds = skein::testing::cases<std::uint64_t>(150, 10'000);
  Counts counts;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    talk_while_plans_change(seed, false, counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.never, counts.all / 100);
  EXPECT_GT(counts.needed, counts.all / 10);
  EXPECT_GT(counts.found_needed, counts.needed * 3 / 4);
}

TEST(TeamBounds, WithOrdersBetweenWaysInThemAreThoseOfTheWholeTeam) {
  const auto seeds = skein::testing::cases<std::uint64_t>(150, 10'000);
  Counts counts;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    talk_while_plans_change(seed, true, counts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(counts.never, counts.all / 100);
  EXPECT_GT(counts.endless, counts.all / 20);
}

// Heliv leaves marvin's air between 100 and 300; marvin tells karma, whom it meets behind that.
TEST(TeamBounds, WhoMeetsOneThatWaitsForItsAirIsToldByWhen) {
  const MeetingId order = order_of("marvin");
  const Meeting then{1, {"karma", "marvin"}, {"karma"}}, leaves{order, {"heliv"}, {"marvin"}};
  Talk talk;
  Random random(1);
  talk.plans("heliv", {{leaves}, {{0, 2, 100, 300, kMinusInfinite}}});
  talk.plans("marvin",
             {{leaves, then},
              {{Frontier::kPresent, 4, 10, 10, 10}, {3, 4, kMinusInfinite, 10, kMinusInfinite}}});
  talk.plans("karma", {{then}, {{0, 2, 5, 5, 5}}});
  ASSERT_TRUE(talk.settle(random));

  const PartnerDates dates = talk.of("karma").dates(MissionTime()).at(1);
  EXPECT_EQ(dates.soonest, MissionTime::nanoseconds(10));
  EXPECT_EQ(dates.slowest, MissionTime::nanoseconds(311));
  EXPECT_EQ(dates.last, "marvin");
}

/// Words of a supervisor, of which the last of each counts.
class Supervised {
 public:
  explicit Supervised(const RandomTeam& team) : supervisor_(team.agents()) {
    for (const std::string& agent : team.agents()) agents_.emplace(agent, TeamDates(agent));
  }
  void plans(const std::string& name, const Frontier& whole) {
    agents_.at(name).say(eliminated(whole));
    for (const TeamSupervisor::Word& word : supervisor_.hear(name, whole)) {
      EXPECT_EQ(fault_of(word.frontier), std::nullopt);
      agents_.at(word.to).hear(word.about, word.frontier);
    }
  }
  const TeamDates& of(const std::string& name) const { return agents_.at(name); }

 private:
  TeamSupervisor supervisor_;
  std::map<std::string, TeamDates> agents_;
};

void supervise(std::uint64_t seed, bool orders, Counts& counts) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  RandomTeam team(seed, orders);
  Supervised supervised(team);
  for (int change = 0; change < 4; ++change) {
    team.change();
    for (const std::string& agent : team.agents()) supervised.plans(agent, team.network_of(agent));
    for (const std::string& agent : team.agents())
      compare(supervised.of(agent), team, agent, counts);
  }
}

TEST(TeamSupervisor, TellsTheDatesOfTheWholeTeam) {
  const auto seeds = skein::testing::cases<std::uint64_t>(150, 10'000);
  Counts counts;
  counts.limits_of_never = false;
  for (const bool orders : {false, true}) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      supervise(seed, orders, counts);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(counts.endless, counts.all / 40);
}

TEST(TeamSupervisor, TellsOnlyWhatChangedAndToWhomItConcerns) {
  const Meeting meeting{1, kBoth, kBoth};
  TeamSupervisor supervisor({"heliv", "karma", "marvin"});
  const auto words = supervisor.hear("heliv", round_of({meeting}));

  ASSERT_THAT(words, ::testing::SizeIs(1));
  EXPECT_EQ(words[0].to, "marvin");
  EXPECT_EQ(words[0].about, "heliv");
  EXPECT_THAT(supervisor.hear("heliv", round_of({meeting})), IsEmpty());
  EXPECT_THAT(supervisor.hear("a stranger", round_of({meeting})), IsEmpty());
}

TEST(TeamSupervisor, WhoGivesWayOfTwoThatWaitForEachOtherFindsIt) {
  const Meeting first{1, kBoth, kBoth}, second{2, kBoth, kBoth};
  TeamSupervisor supervisor(kBoth);
  TeamDates heliv("heliv"), marvin("marvin");
  const auto plans = [&](TeamDates& own, const std::string& name, const Frontier& plan) {
    own.say(plan);
    for (const TeamSupervisor::Word& word : supervisor.hear(name, plan))
      (word.to == "heliv" ? heliv : marvin).hear(word.about, word.frontier);
  };
  plans(heliv, "heliv", round_of({second, first}));
  plans(marvin, "marvin", round_of({first, second}));

  EXPECT_EQ(heliv.dates(MissionTime()).at(2).behind, MeetingId{1});
  EXPECT_EQ(marvin.dates(MissionTime()).at(1).behind, std::nullopt);
  EXPECT_EQ(marvin.dates(MissionTime()).at(1).soonest, MissionTime::max());
}

// What an agent does of all others' networks in DIP-G, and the supervisor in CIP.
TEST(WholeNetworks, ComeToTheSameAsWhatIsLeftOfThem) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomTeam team(seed);
    team.change();
    for (const std::string& agent : team.agents()) {
      const Frontier whole = team.network_of(agent);
      EXPECT_EQ(fault_of(whole), std::nullopt);
      EXPECT_EQ(eliminated(whole), team.plan_of(agent)) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace skein::temporal::testing
