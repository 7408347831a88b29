// SPDX-License-Identifier: Apache-2.0
// A UAV in its team: it bids at degree 5 only, does what it was granted, and tells how that ended.
#include "skein/decision_node/decision_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level_world.hpp"
#include "skein/team/global_mission.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using auction::Stage;
using auction::TaskNumber;
using testing::all;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Marvin, number 0 of marvin, heliv and the ground; it knows how to "look PLACE".
Config config(int degree) {
  Config config;
  config.uav = "marvin";
  config.others = {"heliv"};
  config.degree = degree;
  auto knowledge = std::make_shared<supervisor::Knowledge>();
  knowledge->uav = "marvin";
  knowledge->vehicle.cruise_speed = 5;
  knowledge->vehicle.max_speed = 10;
  knowledge->vehicle.climb_rate = knowledge->vehicle.descent_rate = 2;
  knowledge->vehicle.ceiling = 200;
  knowledge->vehicle.energy.capacity = 1e6;
  knowledge->team = {"marvin", "heliv"};
  knowledge->vocabulary.tasks["look"] = {"look", {mission::ParameterKind::kPlace}, {}};
  auto world = std::make_shared<world::World>(skein::testing::level_world(1000));
  const std::string come_down(supervisor::kComeDown);
  knowledge->vocabulary.tasks[come_down] = {come_down, {}, {}};
  world->places["P1"] = {100, 0, 0};
  config.knowledge = knowledge;
  config.world = world;
  config.team = team::Config{team::Roster({"marvin", "heliv", "ground"}), {}, 1};
  return config;
}

class Marvin {
 public:
  explicit Marvin(int degree) : Marvin(config(degree)) {}
  explicit Marvin(Config config) : node_(std::move(config)) {
    give(Started{});
    world::Telemetry telemetry;
    telemetry.uav = "marvin";
    give(telemetry);
  }
  Effects give(const Input& input) { return node_.handle(input, now_); }
  // The holder of the token says what the book says.
  Effects hear(std::shared_ptr<const auction::Ledger> ledger) {
    return give(TeamTold{"heliv", auction::Beat{ledger->term, ledger->revision, ledger}});
  }
  Effects at_degree(int degree) {
    return give(Command{{1, ++commands_}, mission::ChangeDegree{degree}});
  }
  void wait(double seconds) { now_ = now_ + Duration::seconds(seconds); }

 private:
  MissionTime now_;
  DecisionNode node_;
  std::uint64_t commands_ = 0;
};

std::shared_ptr<auction::Ledger> book(Stage stage, std::uint64_t revision = 1,
                                      const std::string& place = "P1") {
  auto ledger = std::make_shared<auction::Ledger>();
  ledger->term = 2;
  ledger->revision = revision;
  auction::LedgerEntry& entry = ledger->entries[TaskNumber(11)];
  entry.task.number = TaskNumber(11);
  mission::HighLevelTask task;
  task.id = mission::GoalId(11);
  task.name = "look";
  task.arguments = {place};
  entry.task.work = std::make_shared<const team::Order>(task, "operator");
  entry.stage = stage;
  if (stage != Stage::kForSale) entry.owners = {auction::MemberNumber(0)};
  entry.sale = 7;
  ledger->routes[auction::MemberNumber(0)] = {TaskNumber(11)};
  return ledger;
}

auction::Status status_in(const Effects& effects) {
  auction::Status last;
  for (const SendTeam& sent : all<SendTeam>(effects)) {
    if (const auto* status = std::get_if<auction::Status>(&sent.message)) last = *status;
  }
  return last;
}

std::vector<std::string> noted(const Effects& effects) {
  std::vector<std::string> states;
  for (const TeamTaskNoted& one : all<TeamTaskNoted>(effects)) states.push_back(one.state);
  return states;
}

std::shared_ptr<const auction::Catalogue> lot() {
  auction::Task task;
  task.number = TaskNumber(11);
  return std::make_shared<const auction::Catalogue>(auction::Lot{{task}, {}});
}

auction::ToMember call() {
  return auction::Call{auction::SaleNumber(1), 1, lot(), {}, 0, {TaskNumber(11)}, 0, false};
}

TEST(Team, AtDegreeFiveItSaysThatItBidsAndBelowThatItOnlyVotes) {
  Marvin five(5), four(4);

  EXPECT_TRUE(status_in(five.hear(book(Stage::kForSale))).bids);
  EXPECT_FALSE(status_in(four.hear(book(Stage::kForSale))).bids);
  EXPECT_THAT(all<SendTeam>(four.give(TeamTold{"heliv", auction::VoteRequest{9, false, 9, 9}})),
              SizeIs(1));
}

TEST(Team, ItOffersWithoutAnyEffectOnItsPlanAndSaysWhat) {
  Marvin marvin(5);
  marvin.hear(book(Stage::kForSale));

  const Effects effects = marvin.give(TeamTold{"heliv", call()});

  EXPECT_THAT(all<supervisor::StartDeliberation>(effects), IsEmpty());
  const auto bids = all<BidNoted>(effects);
  ASSERT_THAT(bids, SizeIs(1));
  EXPECT_GT(bids[0].added.value_or(0), 0);
  EXPECT_THAT(all<SendTeam>(effects), SizeIs(1));
}

TEST(Team, WhyItDoesNotBidIsSaidToo) {
  Marvin marvin(5);
  marvin.hear(book(Stage::kForSale, 1, "nowhere"));

  const auto bids = all<BidNoted>(marvin.give(TeamTold{"heliv", call()}));

  ASSERT_THAT(bids, SizeIs(1));
  EXPECT_EQ(bids[0].added, std::nullopt);
  EXPECT_THAT(bids[0].objection, HasSubstr("nowhere"));
}

TEST(Team, WhatIsOnlyOwnedIsNotBegunAndItAsksForAGoAhead) {
  Marvin marvin(5);

  const Effects effects = marvin.hear(book(Stage::kOwned));

  EXPECT_THAT(all<supervisor::StartDeliberation>(effects), IsEmpty());
  EXPECT_THAT(status_in(effects).wants, ElementsAre(auction::Claim{TaskNumber(11), 7}));
}

TEST(Team, WhatIsGrantedGoesToItsSupervisorAsAGoalOfThatNumberOnce) {
  Marvin marvin(5);

  const Effects effects = marvin.hear(book(Stage::kGranted));
  const Effects again = marvin.hear(book(Stage::kGranted, 2));

  EXPECT_THAT(noted(effects), ElementsAre("begun"));
  EXPECT_THAT(all<supervisor::StartDeliberation>(effects), SizeIs(1));
  const auto goals = all<supervisor::GoalChanged>(effects);
  ASSERT_FALSE(goals.empty());
  EXPECT_EQ(goals[0].status.id, mission::GoalId(11));
  EXPECT_EQ(goals[0].status.asked_by, "operator, by the team");
  EXPECT_THAT(noted(again), IsEmpty());
}

TEST(Team, WhatTheSupervisorRefusesIsPutBackWithItsReasonAndNotBidForAgain) {
  Marvin marvin(5);

  const Effects effects = marvin.hear(book(Stage::kGranted, 1, "nowhere"));
  const Effects told = marvin.hear(book(Stage::kGranted, 2, "nowhere"));

  EXPECT_THAT(noted(effects), ElementsAre("begun", "put-back"));
  EXPECT_THAT(status_in(told).stopped, ElementsAre(auction::Claim{TaskNumber(11), 7}));
  EXPECT_THAT(status_in(told).stopped_why, ElementsAre(HasSubstr("nowhere")));
  const auto bids = all<BidNoted>(marvin.give(TeamTold{"heliv", call()}));
  ASSERT_THAT(bids, SizeIs(1));
  EXPECT_THAT(bids[0].objection, HasSubstr("it tried"));
}

TEST(Team, AtDegreeFourWhatItOwnsGoesBackToTheTeam) {
  Marvin marvin(5);
  marvin.hear(book(Stage::kOwned));

  marvin.at_degree(4);
  const Effects told = marvin.hear(book(Stage::kOwned, 2));

  EXPECT_FALSE(status_in(told).bids);
  EXPECT_THAT(status_in(told).stopped, ElementsAre(auction::Claim{TaskNumber(11), 7}));
  EXPECT_THAT(status_in(told).stopped_why, ElementsAre("degree 4"));
}

TEST(Team, WhatHasNotBegunIsWithdrawnFromTheSupervisorWithTheDegree) {
  for (const int degree : {4, 3, 1}) {
    Marvin marvin(5);
    marvin.hear(book(Stage::kGranted));

    const Effects effects = marvin.at_degree(degree);

    const std::string why = "degree " + std::to_string(degree);
    EXPECT_THAT(noted(effects), ElementsAre("put-back")) << degree;
    const auto goals = all<supervisor::GoalChanged>(effects);
    ASSERT_FALSE(goals.empty());
    EXPECT_EQ(goals.back().status.why, "cancelled by marvin itself, for the team: " + why);
    EXPECT_THAT(status_in(marvin.hear(book(Stage::kGranted, 2))).stopped_why, ElementsAre(why));
  }
}

TEST(Team, WhatIsGrantedToOneThatHasLeftIsNotBegun) {
  Marvin marvin(4);

  EXPECT_THAT(noted(marvin.hear(book(Stage::kGranted))), IsEmpty());
  EXPECT_THAT(status_in(marvin.hear(book(Stage::kGranted, 2))).stopped, SizeIs(1));
}

TEST(Team, BackAtDegreeFiveItBidsAgain) {
  Marvin marvin(5);
  marvin.at_degree(4);
  marvin.at_degree(5);

  EXPECT_TRUE(status_in(marvin.hear(book(Stage::kForSale))).bids);
}

// Marvin in the air at degree 5, with a book that says that task 11 is not done.
class Aloft : public Marvin {
 public:
  explicit Aloft(Stage stage) : Aloft(config(5), book(stage)) {}
  Aloft(Config config, std::shared_ptr<const auction::Ledger> book) : Marvin(std::move(config)) {
    for (const std::string peer : {"heliv", "ground"}) reach(peer, true);
    give(testing::flying(true));
    hear(std::move(book));
  }
  void reach(const std::string& peer, bool reachable) {
    give(Contact{peer, peer == "ground", reachable});
  }
  /// Whether it gives itself the goal to come down within that time.
  bool comes_down_within(int seconds) {
    bool comes = false;
    for (int i = 0; i < seconds; ++i) {
      wait(1);
      for (const supervisor::GoalChanged& goal : all<supervisor::GoalChanged>(give(Tick{})))
        comes = comes || goal.status.asked_by ==
                             "marvin itself: most of the team are out of reach since 0 s";
    }
    return comes;
  }
};

constexpr int kPolicyAndRest = 70;  // the time of its contact-loss policy, then ten seconds [s]

TEST(Team, WhoReachesNoMajorityComesHomeOnceItsContactLossPolicyIsDueThoughItMayHaveWork) {
  for (const Stage stage : {Stage::kForSale, Stage::kOwned}) {
    Aloft marvin(stage);
    marvin.reach("heliv", false);
    marvin.reach("ground", false);

    EXPECT_FALSE(marvin.comes_down_within(kPolicyAndRest - 1));
    EXPECT_TRUE(marvin.comes_down_within(3));
  }
}

TEST(Team, WhoReachesAMajorityWaitsForItsWork) {
  Aloft cut_from_one(Stage::kForSale), back_in_time(Stage::kForSale);
  cut_from_one.reach("ground", false);
  back_in_time.reach("ground", false);
  back_in_time.reach("heliv", false);
  EXPECT_FALSE(back_in_time.comes_down_within(kPolicyAndRest - 15));

  back_in_time.reach("heliv", true);

  EXPECT_FALSE(back_in_time.comes_down_within(3 * kPolicyAndRest));
  EXPECT_FALSE(cut_from_one.comes_down_within(3 * kPolicyAndRest));
}

TEST(Team, WhoReachesMostOfThoseThatAreNotDeclaredLostWaitsForItsWork) {
  Config of_five = config(5);
  of_five.team->roster = team::Roster({"marvin", "heliv", "karma", "ressac", "ground"});
  const auto without_two = book(Stage::kForSale);
  for (const unsigned lost : {2U, 3U})
    without_two->losses.declare(auction::MemberNumber(lost), true);
  Aloft marvin(of_five, without_two);

  for (const std::string peer : {"heliv", "karma", "ressac"}) marvin.reach(peer, false);

  EXPECT_FALSE(marvin.comes_down_within(3 * kPolicyAndRest));
}

TEST(Team, AStrangerIsNotHeard) {
  Marvin marvin(5);

  EXPECT_THAT(marvin.give(TeamTold{"karma", auction::Beat{2, 1, book(Stage::kGranted)}}),
              IsEmpty());
}

TEST(Team, WithoutATeamDegreeFiveIsRefusedAndNothingIsSaid) {
  Config alone = config(4);
  alone.team.reset();
  DecisionNode node(alone);
  node.handle(Started{}, MissionTime());

  const Effects effects = node.handle(Command{{1, 1}, mission::ChangeDegree{5}}, MissionTime());

  ASSERT_THAT(all<Answer>(effects), SizeIs(1));
  EXPECT_THAT(all<Answer>(effects)[0].why, HasSubstr("no team in the scenario"));
  EXPECT_THAT(all<SendTeam>(node.handle(Tick{}, MissionTime::seconds(60))), IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
