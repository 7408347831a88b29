// SPDX-License-Identifier: Apache-2.0
// Never two different results, never success at one member and failure at another, always an end by
// the deadline: on every course of two UAVs, at every cut of two and three, and in random sessions
// of up to eight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "skein/foundation/random.hpp"
#include "skein/negotiation/area_offer.hpp"
#include "testing/explored_team.hpp"
#include "testing/negotiating_team.hpp"

namespace skein::interaction {
namespace {

using testing::begin_roles;
using testing::Bounds;
using testing::ExploredTeam;
using testing::name_of;
using testing::Team;
using Kind = NegotiationOutcome::Kind;
using Ends = std::set<std::string>;

class EveryCourse : public ::testing::TestWithParam<Bounds> {};

TEST_P(EveryCourse, KeepsTheLaws) {
  ExploredTeam team(GetParam());

  EXPECT_EQ(team.explore(), "");
  EXPECT_GT(team.states(), 100U);
  EXPECT_EQ(team.ends().count("agreed agreed") + team.ends().count("agreed agreed agreed"), 1U);
}

INSTANTIATE_TEST_SUITE_P(OfTwo, EveryCourse,
                         ::testing::Values(Bounds{2, {0}, 0, false, false, 1, 10},
                                           Bounds{2, {1}, 0, false, false, 1, 10},
                                           Bounds{2, {0, 1}, 0, false, true, 5, 4},
                                           Bounds{2, {0}, 1, false, false, 2, 10},
                                           Bounds{2, {1}, 1, true, false, 5, 4},
                                           Bounds{2, {0}, 0, false, false, 2, 10, true},
                                           Bounds{2, {1}, 0, false, false, 2, 10, true},
                                           Bounds{2, {1}, 1, true, false, 5, 4, true}));

// What is possible between two when anything may be lost: never (agreed, failed).
TEST(EveryCourseOfTwo, ComesToOneOfTheseEnds) {
  ExploredTeam team({2, {0}, 0, false, false, 1, 10});

  EXPECT_EQ(team.explore(), "");
  EXPECT_EQ(team.ends(), (Ends{"agreed agreed", "agreed undecided", "failed", "failed failed",
                               "failed undecided"}));
}

/// What happens to the messages of a team from the k-th on.
struct Cut {
  std::size_t members = 2;
  std::size_t first = 0;                                ///< counted over all messages sent
  std::set<std::pair<std::size_t, std::size_t>> links;  ///< from, to
  Duration lasts;
};

class CutTeam {
 public:
  explicit CutTeam(const Cut& cut) : cut_(cut), team_(cut.members, link()) {}

  Team& run() {
    const BeginNegotiation begin = begin_roles(cut_.members);
    for (std::size_t i = 0; i < cut_.members; ++i) team_.begin_when_invited(i, begin);
    team_.begin(cut_.members - 1, begin);
    team_.run_until(MissionTime::seconds(11));
    return team_;
  }
  /// Whether the cut began at all.
  bool was_cut() const { return since_.has_value(); }

 private:
  testing::Link link() {
    return [this](std::size_t from, std::size_t to, MissionTime at) -> std::optional<Duration> {
      if (count_++ == cut_.first) since_ = at;
      const bool cut = since_ && at < *since_ + cut_.lasts && cut_.links.count({from, to}) > 0;
      if (cut) return std::nullopt;
      return Duration::milliseconds(80);
    };
  }

  Cut cut_;
  std::size_t count_ = 0;
  std::optional<MissionTime> since_;
  Team team_;
};

std::vector<std::set<std::pair<std::size_t, std::size_t>>> sets_of_links(std::size_t members) {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < members; ++i) {
    for (std::size_t j = 0; j < members; ++j) {
      if (i != j) all.emplace_back(i, j);
    }
  }
  std::vector<std::set<std::pair<std::size_t, std::size_t>>> sets;
  for (std::size_t mask = 1; mask < (std::size_t{1} << all.size()); ++mask) {
    std::set<std::pair<std::size_t, std::size_t>> one;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((mask >> i & 1U) != 0) one.insert(all[i]);
    }
    sets.push_back(std::move(one));
  }
  return sets;
}

void for_every_cut(std::size_t members, Duration lasts,
                   const std::function<void(Team&, const std::string&)>& check) {
  std::size_t runs = 0;
  for (const auto& links : sets_of_links(members)) {
    for (std::size_t first = 0;; ++first) {
      CutTeam cut({members, first, links, lasts});
      Team& team = cut.run();
      if (!cut.was_cut()) break;
      std::string where = "cut of";
      for (const auto& [from, to] : links) where += " " + name_of(from) + name_of(to);
      check(team, where + " from message " + std::to_string(first) + " on");
      ++runs;
    }
  }
  EXPECT_GT(runs, 10U);
}

std::size_t count(Team& team, Kind kind) {
  std::size_t n = 0;
  for (const auto& [member, end] : team.ends()) n += end.kind == kind ? 1 : 0;
  return n;
}

class CutAtEveryMessage : public ::testing::TestWithParam<std::size_t> {};

TEST_P(CutAtEveryMessage, ForGoodKeepsTheLaws) {
  for_every_cut(GetParam(), Duration::seconds(100), [](Team& team, const std::string& where) {
    EXPECT_EQ(team.outcomes().breaks(), "") << where;
  });
}

// Half of the session is left to hear of the decision: what heals within it leaves nobody in doubt.
TEST_P(CutAtEveryMessage, ThatHealsWithinTheOtherHalfEndsAlikeEverywhere) {
  const std::size_t members = GetParam();
  for_every_cut(members, Duration::seconds(4), [&](Team& team, const std::string& where) {
    EXPECT_EQ(team.outcomes().breaks(), "") << where;
    EXPECT_EQ(count(team, Kind::kUndecided), 0U) << where;
    EXPECT_EQ(team.ends().size(), members) << where;
    EXPECT_TRUE(count(team, Kind::kAgreed) == members || count(team, Kind::kFailed) == members)
        << where << "\n"
        << team.outcomes().text();
  });
}

// A second at most may be lost without failure: it is said again.
TEST_P(CutAtEveryMessage, ThatIsShortEndsInAgreement) {
  const std::size_t members = GetParam();
  for_every_cut(members, Duration::seconds(1), [&](Team& team, const std::string& where) {
    EXPECT_EQ(count(team, Kind::kAgreed), members) << where << "\n" << team.outcomes().text();
  });
}

INSTANTIATE_TEST_SUITE_P(OfTwoAndThree, CutAtEveryMessage, ::testing::Values(2, 3));

/// A channel that carries one message after the other, each in so much time. What would come more
/// than 2 s after it was sent is lost, but not before it was carried (lifespan of the slot).
testing::Link narrow(Duration airtime) {
  return [airtime, free = MissionTime()](std::size_t from, std::size_t,
                                         MissionTime at) mutable -> std::optional<Duration> {
    if (from != 0) return Duration::milliseconds(20);
    free = std::max(free, at) + airtime;
    if (free - at > Duration::seconds(2)) return std::nullopt;
    return free - at;
  };
}

constexpr Duration kMostOfTheLifespan = Duration::milliseconds(1'300);

TEST(WhoInvitesOverANarrowChannel, LeavesItToOthers) {
  Team team(2, narrow(kMostOfTheLifespan));
  team.begin(0, begin_roles(2, Duration::seconds(30)));

  team.run_until(MissionTime::seconds(15));

  EXPECT_LT(static_cast<double>(team.sent()) * kMostOfTheLifespan.to_seconds(), 15 * 0.6);
}

TEST(WhoInvitesOverANarrowChannel, AgreesWithWhoTakesPartLater) {
  const BeginNegotiation begin = begin_roles(2, Duration::seconds(30));
  Team team(2, narrow(kMostOfTheLifespan));
  team.begin(0, begin);
  team.at(MissionTime::seconds(9), [&] { team.begin(1, begin); });

  team.run_until(MissionTime::seconds(31));

  EXPECT_EQ(count(team, Kind::kAgreed), 2U) << team.outcomes().text();
}

// At every instant of a session, each member goes down, for good or to come back.
TEST(ACrashAtAnyTime, KeepsTheLaws) {
  for (std::size_t members = 2; members <= 3; ++members) {
    for (std::size_t who = 0; who < members; ++who) {
      for (int centisecond = 0; centisecond < 100; centisecond += 3) {
        for (const bool comes_back : {false, true}) {
          Team team(members, [](auto, auto, auto) { return Duration::milliseconds(90); });
          team.set_job_time(Duration::milliseconds(70));
          const BeginNegotiation begin = begin_roles(members);
          for (std::size_t i = 0; i < members; ++i) team.begin_when_invited(i, begin);
          team.begin(members - 1, begin);
          const MissionTime when = MissionTime::seconds(centisecond / 100.0);
          team.at(when, [&] { team.crash(who); });
          if (comes_back) team.at(when + Duration::seconds(1), [&] { team.restart(who); });

          team.run_until(MissionTime::seconds(40));

          EXPECT_EQ(team.outcomes().breaks(), "") << name_of(who) << " at " << centisecond;
          if (team.sent() == 0) continue;  // it was dead before it had invited anybody
          for (std::size_t i = 0; i < members; ++i) {
            EXPECT_TRUE(i == who || team.outcomes().all().begin()->second.count(i) == 1) << i;
          }
        }
      }
    }
  }
}

/// A member goes down when the k-th message is sent, which is lost with it or still arrives.
struct CrashAt {
  std::size_t members = 2, who = 0, message = 0;
  bool arrives = false, comes_back = false;
};

class CrashingTeam {
 public:
  explicit CrashingTeam(const CrashAt& crash)
      : crash_(crash),
        team_(crash.members, [this](auto, auto, MissionTime at) { return link(at); }) {}

  Team& run() {
    const BeginNegotiation begin = begin_roles(crash_.members);
    for (std::size_t i = 0; i < crash_.members; ++i) team_.begin_when_invited(i, begin);
    team_.set_job_time(Duration::milliseconds(70));
    team_.begin(crash_.members - 1, begin);
    team_.run_until(MissionTime::seconds(40));
    return team_;
  }
  bool has_crashed() const { return has_crashed_; }

 private:
  std::optional<Duration> link(MissionTime at) {
    if (count_++ != crash_.message) return Duration::milliseconds(90);
    has_crashed_ = true;
    team_.at(at, [this] { team_.crash(crash_.who); });
    if (crash_.comes_back)
      team_.at(at + Duration::seconds(1), [this] { team_.restart(crash_.who); });
    return crash_.arrives ? std::optional(Duration::milliseconds(90)) : std::nullopt;
  }

  CrashAt crash_;
  std::size_t count_ = 0;
  bool has_crashed_ = false;
  Team team_;
};

/// Every member, at every message, whatever becomes of it; how many that are.
std::size_t crashes_of(std::size_t members) {
  std::size_t crashes = 0;
  for (std::size_t who = 0; who < members; ++who) {
    for (const bool arrives : {false, true}) {
      for (const bool comes_back : {false, true}) {
        for (std::size_t message = 0;; ++message, ++crashes) {
          CrashingTeam crash({members, who, message, arrives, comes_back});
          Team& team = crash.run();
          if (!crash.has_crashed()) break;
          EXPECT_EQ(team.outcomes().breaks(), "")
              << name_of(who) << " at message " << message << "\n"
              << team.outcomes().text();
        }
      }
    }
  }
  return crashes;
}

TEST(ACrashAtEveryMessage, KeepsTheLaws) {
  EXPECT_GT(crashes_of(2), 40U);
  EXPECT_GT(crashes_of(3), 100U);
}

// ---- the protocol knows nothing of what is negotiated ----

struct Subject {
  std::string modality;
  Rows parameters;
  std::vector<Rows> offers;  ///< of each member
};

Rows sweeper_at(double x, double speed) {
  Sweeper one;
  one.vehicle.cruise_speed = speed;
  one.vehicle.max_speed = 20;
  one.vehicle.climb_rate = one.vehicle.descent_rate = 3;
  one.vehicle.acceleration = 2;
  one.vehicle.yaw_rate = 0.8;
  one.vehicle.ceiling = 200;
  one.vehicle.energy = {1e8, 100, 1700, 1500, 400, 0.1};
  one.start = {x, -50};
  one.altitude = 50;
  one.swath = 80;
  return offer_of(one);
}

std::vector<Subject> subjects() {
  return {
      {"time-interval",
       {{"duration", "", {60}}},
       {{{"interval", "", {0, 100}}}, {{"interval", "", {20, 90}}, {"interval", "", {0, 200}}}}},
      {"area-sharing",
       {{"area", "", {0, 0, 400, 0, 400, 300, 0, 300}}},
       {sweeper_at(0, 8), sweeper_at(400, 12)}},
      {"perception-positions",
       {{"directions", "", {8}}},
       {{{"direction", "", {0, 5}}, {"direction", "", {3, 1}}},
        {{"direction", "", {4, 2}}, {"direction", "", {7, 0}}}}},
      {"relay-chain",
       {{"link", "", {0, 0, 50}}, {"link", "", {300, 0, 50}}},
       {{{"link", "", {0, 4}}, {"link", "", {1, 9}}},
        {{"link", "", {0, 3}}, {"link", "", {1, 2}}}}}};
}

/// Two agree about it while all links are cut for so long from the k-th message on.
void expect_laws(const Subject& subject, Duration lasts) {
  std::size_t agreed = 0;
  for (std::size_t first = 0;; ++first) {
    std::size_t count = 0;
    std::optional<MissionTime> since;
    Team team(2, [&](auto, auto, MissionTime at) -> std::optional<Duration> {
      if (count++ == first) since = at;
      if (since && at < *since + lasts) return std::nullopt;
      return Duration::milliseconds(80);
    });
    const BeginNegotiation begin{"s",          subject.modality,   testing::names(2),
                                 ModelHash{7}, subject.parameters, Duration::seconds(10)};
    for (std::size_t i = 0; i < 2; ++i) {
      team.begin_when_invited(i, begin);
      team.set_offer(i, subject.offers[i]);
    }
    team.begin(1, begin);
    team.run_until(MissionTime::seconds(11));
    EXPECT_EQ(team.outcomes().breaks(), "") << subject.modality << " cut at " << first;
    for (const auto& [member, end] : team.ends()) agreed += end.kind == Kind::kAgreed ? 1 : 0;
    if (!since) break;
  }
  EXPECT_GT(agreed, 1U) << subject.modality << ": else the laws hold because nothing happens";
}

TEST(EveryModality, KeepsTheLawsAtEveryCut) {
  for (const Subject& subject : subjects()) {
    expect_laws(subject, Duration::seconds(1));
    expect_laws(subject, Duration::seconds(100));
  }
}

/// A session of up to eight UAVs with losses, delays that reorder, cuts, crashes and restarts.
class RandomSession {
 public:
  explicit RandomSession(std::uint64_t seed, NegotiationLimits limits = {})
      : random_(seed),
        n_(2 + random_.below(7)),
        loss_(random_.chance(0.3) ? 0 : random_.uniform(0, 0.5)),
        team_(
            n_,
            [this](std::size_t from, std::size_t to, MissionTime at) {
              return delay(from, to, at);
            },
            limits) {
    if (seed % 3 == 0) team_.make_results_jobs();
  }

  Team& run() {
    const BeginNegotiation begin = begin_roles(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      team_.begin_when_invited(i, begin);
      Rows costs = testing::role_costs(i);
      for (Row& row : costs) row.numbers[0] = random_.uniform(0, 100);
      if (random_.chance(0.2)) costs.pop_back();
      team_.set_offer(i, costs);
    }
    for (std::size_t i = 0; i < 2; ++i) cuts_.push_back(any_cut());
    const std::size_t openers = 1 + random_.below(2);
    for (std::size_t i = 0; i < openers; ++i) {
      const std::size_t who = random_.below(n_);
      BeginNegotiation own = begin;
      own.parameters[0].text = name_of(who);
      team_.at(any_time(1), [this, who, own] { team_.begin(who, own); });
    }
    if (random_.chance(0.4)) crash();
    team_.set_job_time(Duration::seconds(random_.uniform(0, 2)));
    team_.run_until(MissionTime::seconds(300));
    return team_;
  }

 private:
  struct LinkCut {
    std::size_t one = 0, other = 0;
    MissionTime from, until;
  };
  MissionTime any_time(double most) { return MissionTime::seconds(random_.uniform(0, most)); }
  LinkCut any_cut() {
    const MissionTime from = any_time(10);
    return {random_.below(n_), random_.below(n_), from,
            from + Duration::seconds(random_.uniform(0, 15))};
  }
  void crash() {
    const std::size_t who = random_.below(n_);
    const MissionTime when = any_time(6);
    team_.at(when, [this, who] { team_.crash(who); });
    if (random_.chance(0.5)) return;
    team_.at(when + Duration::seconds(random_.uniform(0.1, 5)), [this, who] {
      team_.restart(who);
      if (random_.chance(0.5)) team_.begin(who, begin_roles(n_));
    });
  }
  std::optional<Duration> delay(std::size_t from, std::size_t to, MissionTime at) {
    for (const LinkCut& cut : cuts_) {
      const bool these =
          (cut.one == from && cut.other == to) || (cut.one == to && cut.other == from);
      if (these && at >= cut.from && at < cut.until) return std::nullopt;
    }
    if (random_.chance(loss_)) return std::nullopt;
    return Duration::seconds(random_.uniform(0.01, random_.chance(0.05) ? 3 : 0.3));
  }

  Random random_;
  std::size_t n_;
  double loss_;
  std::vector<LinkCut> cuts_;
  Team team_;
};

std::uint64_t random_sessions() {
  const char* more = std::getenv("SKEIN_SESSIONS");
  return more == nullptr ? 1000 : std::strtoull(more, nullptr, 10);
}

TEST(RandomSessions, KeepTheLaws) {
  std::size_t agreed = 0, failed = 0, undecided = 0;
  for (std::uint64_t seed = 1; seed <= random_sessions(); ++seed) {
    RandomSession session(seed);
    Team& team = session.run();
    ASSERT_EQ(team.outcomes().breaks(), "") << "seed " << seed << "\n" << team.outcomes().text();
    agreed += count(team, Kind::kAgreed) > 0 ? 1 : 0;
    failed += count(team, Kind::kFailed) > 0 ? 1 : 0;
    undecided += count(team, Kind::kUndecided) > 0 ? 1 : 0;
  }
  RecordProperty("undecided", static_cast<int>(undecided));
  EXPECT_GT(agreed, random_sessions() / 4) << "else the laws hold because nothing happens";
  EXPECT_GT(failed, random_sessions() / 10);
}

// What is forgotten, or not heard, is never a reason for two different ends.
TEST(RandomSessions, KeepTheLawsHoweverFewSessionsOfOneAreHeard) {
  std::size_t agreed = 0, unheard = 0;
  for (const std::size_t few : {0, 1, 2}) {
    NegotiationLimits limits;
    limits.sessions_of_one = few;
    for (std::uint64_t seed = 1; seed <= random_sessions() / 4; ++seed) {
      RandomSession session(seed, limits);
      Team& team = session.run();
      ASSERT_EQ(team.outcomes().breaks(), "") << few << " sessions of one, seed " << seed;
      agreed += count(team, Kind::kAgreed) > 0 ? 1 : 0;
      for (const std::string& why : team.rejected())
        unheard += why.starts_with("it tells of more than") ? 1 : 0;
    }
  }
  EXPECT_GT(agreed, random_sessions() / 8) << "else the laws hold because nothing happens";
  EXPECT_GT(unheard, 0U);
}

TEST(RandomSessions, AllSessionsOfOneAreHeard) {
  for (std::uint64_t seed = 1; seed <= random_sessions() / 4; ++seed) {
    RandomSession session(seed);
    for (const std::string& why : session.run().rejected())
      ASSERT_FALSE(why.starts_with("it tells of more than")) << "seed " << seed << ": " << why;
  }
}

// The same messages whatever the order of a map or of a run.
TEST(RandomSessions, AreTheSameAgain) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomSession one(seed), other(seed);
    Team& first = one.run();
    Team& again = other.run();
    EXPECT_EQ(first.outcomes().text(), again.outcomes().text());
    EXPECT_EQ(first.sent(), again.sent());
  }
}

}  // namespace
}  // namespace skein::interaction
