// SPDX-License-Identifier: Apache-2.0
// What a decision node does by itself once it has lost the ground (spec 1.2).
#include <cmath>
#include <memory>

#include "skein/supervisor/way_home.hpp"
#include "testing/bench.hpp"
#include "testing/deliberating.hpp"

namespace skein::ddn {
namespace {

using executive::InsertionMode;
using testing::a_task;
using testing::Bench;
using ::testing::Contains;
using testing::dispatch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::start;
using testing::status;
using testing::telemetry;
using wire::TaskState;

// Own tasks are numbered by the millisecond in which they are made.
std::string own(double seconds, int offset = 0) {
  const auto milliseconds = static_cast<std::uint64_t>(seconds * 1000);
  return std::to_string(functional::kFirstOwnId.value() + milliseconds +
                        static_cast<unsigned>(offset));
}
std::uint64_t own_id(double seconds, int offset = 0) { return std::stoull(own(seconds, offset)); }

void in_the_air(Bench& bench) {
  bench.hear_ground(true);
  bench.from_sim(telemetry(true));
}

void lose_ground_at(Bench& bench, double seconds) {
  bench.set_time(seconds);
  bench.hear_ground(false);
}

TEST(ContactPolicy, ContinueChangesNothing) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kContinue));
  in_the_air(bench);
  bench.from_ground(start(1, a_task(2, "goto")));

  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(100), IsEmpty());
}

TEST(ContactPolicy, HoldWaitsInsteadOfWhatFliesOnceTheDelayIsOver) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(start(1, a_task(2, "goto")));
  bench.from_sim(status(2, TaskState::kRunning));
  lose_ground_at(bench, 10);

  EXPECT_EQ(bench.node().next_wakeup(), testing::at(40));
  EXPECT_THAT(bench.wake_at(39), IsEmpty());
  EXPECT_THAT(bench.wake_at(40), Contains("sim: interrupt 2"));
  EXPECT_THAT(bench.from_sim(status(2, TaskState::kAborted)),
              Contains("sim: dispatch " + own(40) + " wait"));
}

TEST(ContactPolicy, GivesUpWhatIsPlanned) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(start(1, a_task(2, "goto"), InsertionMode::kVut));
  bench.from_ground(start(2, a_task(3, "goto"), InsertionMode::kDep));
  bench.from_ground(start(3, a_task(4, "land"), InsertionMode::kNut));
  lose_ground_at(bench, 10);

  const auto words = bench.wake_at(40);

  EXPECT_THAT(words, Contains("ground: 3 aborted"));
  EXPECT_THAT(words, Contains("ground: 4 aborted"));
  EXPECT_THAT(words, Not(Contains("sim: dispatch 4 land")));
}

// Its partners are told, and do not count on it.
TEST(ContactPolicy, GivesUpWhatIsBeingSynchronised) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  in_the_air(bench);
  bench.from_ground(start(1, testing::rendezvous(5, 510)));
  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(40), Contains("ground: 5 aborted"));
}

TEST(ContactPolicy, ReturnFliesHomeAndLands) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  in_the_air(bench);
  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(40), Contains("sim: dispatch " + own(40) + " goto"));
  EXPECT_EQ(bench.sent<wire::FunctionalRequest>()->parameters,
            (std::vector<wire::Parameter>{{"waypoints", "", {1, 2, 50}}}));
  bench.from_sim(status(own_id(40), TaskState::kRunning));
  EXPECT_THAT(bench.from_sim(status(own_id(40), TaskState::kEnded)),
              Contains("sim: dispatch " + own(40, 1) + " land"));
}

// The landing that was to follow does not begin in the instant between its way and theirs.
TEST(ContactPolicy, WhoTakesItsWayHomeAwayTakesTheLandingAfterItToo) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  in_the_air(bench);
  lose_ground_at(bench, 10);
  bench.wake_at(40);
  bench.from_sim(status(own_id(40), TaskState::kRunning));
  bench.hear_ground(true);

  auto words = bench.from_ground(start(1, a_task(7, "goto"), executive::InsertionMode::kVut));
  const auto more = bench.from_sim(status(own_id(40), TaskState::kAborted));
  words.insert(words.end(), more.begin(), more.end());

  EXPECT_THAT(words, Contains("sim: interrupt " + own(40)));
  EXPECT_THAT(words, Contains("sim: dispatch 7 goto"));
  EXPECT_THAT(words, Not(Contains("sim: dispatch " + own(40, 1) + " land")));
}

// The way home is barred, but it must still come down.
TEST(ContactPolicy, ReturnLandsWhereItIsWhenTheWayHomeFails) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  in_the_air(bench);
  lose_ground_at(bench, 10);
  bench.wake_at(40);

  EXPECT_THAT(bench.from_sim(status(own_id(40), TaskState::kAborted, "no energy")),
              Contains("sim: dispatch " + own(40, 1) + " land"));
}

TEST(ContactPolicy, IsNotCarriedOutWhenTheGroundIsBackBeforeTheDelay) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(start(1, a_task(2, "goto")));
  lose_ground_at(bench, 10);
  bench.set_time(39);
  bench.hear_ground(true);

  EXPECT_THAT(bench.wake_at(100), Not(Contains("sim: interrupt 2")));
  EXPECT_THAT(bench.records("contact"), IsEmpty());
}

TEST(ContactPolicy, LeavesWhatWasBegunWhenTheGroundIsBackAfterIt) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  in_the_air(bench);
  lose_ground_at(bench, 10);
  bench.wake_at(40);
  bench.set_time(50);

  EXPECT_THAT(bench.hear_ground(true), Not(Contains("sim: interrupt " + own(40))));
}

TEST(ContactPolicy, LosingAnotherUavIsNotLosingTheGround) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  in_the_air(bench);
  bench.set_time(10);
  bench.hear(bench.heliv(), false);

  EXPECT_EQ(bench.node().next_wakeup(), std::nullopt);
}

TEST(ContactPolicy, OnTheGroundIsLoggedAndNeedsNothing) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kReturn));
  bench.hear_ground(true);
  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(40), IsEmpty());
  EXPECT_EQ(bench.records("contact").size(), 1U);
}

// What keeps to the ground may be on its way without being in the air.
TEST(ContactPolicy, OfOneThatDrivesHoldStopsItAndReturnDrivesItHome) {
  for (const ContactPolicy policy : {ContactPolicy::kHold, ContactPolicy::kReturn}) {
    DdnConfig config = Bench::with_policy(3, policy);
    config.drives = true;
    Bench bench(config);
    bench.hear_ground(true);
    bench.from_ground(start(1, a_task(2, "goto")));
    bench.from_sim(status(2, TaskState::kRunning));
    lose_ground_at(bench, 10);

    EXPECT_THAT(bench.wake_at(40), Contains("sim: interrupt 2"));
    const auto words = bench.from_sim(status(2, TaskState::kAborted));
    const bool holds = policy == ContactPolicy::kHold;
    EXPECT_THAT(words, Contains("sim: dispatch " + own(40) + (holds ? " wait" : " goto")));
    if (holds) continue;
    bench.from_sim(status(own_id(40), TaskState::kRunning));
    EXPECT_THAT(bench.from_sim(status(own_id(40), TaskState::kEnded)),
                Not(Contains(::testing::HasSubstr("land"))));
  }
}

TEST(ContactPolicy, UsesNewIdsAtTheNextLoss) {
  Bench bench(Bench::with_policy(3, ContactPolicy::kHold));
  in_the_air(bench);
  lose_ground_at(bench, 10);
  bench.wake_at(40);
  bench.from_sim(status(own_id(40), TaskState::kRunning));
  bench.hear_ground(true);
  lose_ground_at(bench, 60);

  bench.wake_at(90);
  EXPECT_THAT(bench.from_sim(status(own_id(40), TaskState::kAborted)),
              Contains("sim: dispatch " + own(90) + " wait"));
}

/// Holds, and knows what it takes to come home.
DdnConfig that_knows_the_way_home() {
  DdnConfig config = testing::deliberating(3, ContactPolicy::kHold);
  auto knowledge = std::make_shared<supervisor::Knowledge>(*config.knowledge);
  knowledge->vehicle.hovers = true;
  knowledge->vehicle.ceiling = 100;
  knowledge->vehicle.acceleration = 2;
  knowledge->vehicle.energy.hover_power = 500;
  knowledge->vehicle.energy.cruise_power = 600;
  config.knowledge = knowledge;
  return config;
}

double least_to_come_home(const DdnConfig& config) {
  return supervisor::least_to_come_home(*config.knowledge, *config.world, testing::at(500),
                                        {0, 0, 0});
}

wire::Telemetry flying_with(double energy) {
  wire::Telemetry sample = telemetry(true);
  sample.energy = static_cast<float>(energy);
  return sample;
}

TEST(ContactPolicy, AHoldEndsWhenTheEnergyLastsNoLongerThanToComeHome) {
  const DdnConfig config = that_knows_the_way_home();
  Bench bench(config);
  const double needed = least_to_come_home(config);
  ASSERT_TRUE(std::isfinite(needed)) << needed;
  bench.hear_ground(true);
  bench.from_sim(flying_with(1));
  lose_ground_at(bench, 10);
  bench.wake_at(40);
  bench.from_sim(status(own_id(40), TaskState::kRunning));
  bench.set_time(500);

  EXPECT_THAT(bench.from_sim(flying_with(needed + 0.01)), Not(Contains(HasSubstr("dispatch"))));
  EXPECT_THAT(bench.from_sim(flying_with(needed - 0.01)), Contains("sim: interrupt " + own(40)));
  EXPECT_THAT(bench.from_sim(status(own_id(40), TaskState::kAborted)),
              Contains("sim: dispatch " + own(500) + " goto"));
}

TEST(ContactPolicy, WhoHasItInHandIsToldOnceThatItsEnergyLastsNoLongerThanToComeHome) {
  const DdnConfig config = that_knows_the_way_home();
  Bench bench(config);
  const double needed = least_to_come_home(config);
  bench.hear_ground(true);
  const auto notices_at = [&](double seconds, double energy) {
    bench.set_time(seconds);
    bench.from_sim(flying_with(energy));
    return bench.records("notice").size();
  };

  EXPECT_EQ(notices_at(500, needed + 0.01), 0U);
  ASSERT_EQ(notices_at(510, needed - 0.01), 1U);
  EXPECT_EQ(bench.records("notice")[0].text("text"),
            "its energy lasts no longer than to come home");
  EXPECT_EQ(notices_at(520, needed - 0.02), 0U);
}

// What it interrupted is not over yet: the wait would begin together with the way home.
TEST(ContactPolicy, AHoldThatHasNotBegunMakesRoomForTheWayHome) {
  const DdnConfig config = that_knows_the_way_home();
  Bench bench(config);
  const double needed = least_to_come_home(config);
  bench.hear_ground(true);
  bench.from_sim(flying_with(1));
  bench.from_ground(start(1, a_task(2, "goto")));
  bench.from_sim(status(2, TaskState::kRunning));
  lose_ground_at(bench, 465);
  bench.wake_at(495);
  bench.set_time(500);
  bench.from_sim(flying_with(needed - 0.01));

  const auto words = bench.from_sim(status(2, TaskState::kAborted));

  EXPECT_THAT(words, Contains("sim: dispatch " + own(500) + " goto"));
  EXPECT_THAT(words, Not(Contains("sim: dispatch " + own(495) + " wait")));
}

// The functional layer remembers ids for the whole mission, a restarted node does not.
TEST(ContactPolicy, UsesNewIdsAfterARestart) {
  const DdnConfig config = Bench::with_policy(3, ContactPolicy::kHold);
  Bench before(config);
  in_the_air(before);
  lose_ground_at(before, 10);
  const auto first = before.wake_at(40);

  Bench after(config);
  after.give(node::Started{2});
  in_the_air(after);
  lose_ground_at(after, 110);
  const auto second = after.wake_at(140);

  EXPECT_THAT(first, Contains("sim: dispatch " + own(40) + " wait"));
  EXPECT_THAT(second, Contains("sim: dispatch " + own(140) + " wait"));
}

// ---- degree 1: the plan is at the ground, the policy on board all the same ----

TEST(ContactPolicyAtDegree1, InterruptsTheGroundsTasksAndBeginsOnceTheyAreOver) {
  Bench bench(Bench::with_policy(1, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(dispatch(4, "goto"));
  bench.from_ground(dispatch(5, "takeshot"));
  bench.from_sim(status(4, TaskState::kRunning));
  bench.from_sim(status(5, TaskState::kRunning));
  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(40), ElementsAre("sim: interrupt 4", "sim: interrupt 5"));
  EXPECT_THAT(bench.from_sim(status(4, TaskState::kAborted)),
              ElementsAre("ground: status 4 aborted"));
  EXPECT_THAT(bench.from_sim(status(5, TaskState::kAborted)),
              ::testing::IsSupersetOf(
                  {std::string("ground: status 5 aborted"), "sim: dispatch " + own(40) + " wait"}));
}

TEST(ContactPolicyAtDegree1, BeginsAtOnceWhenNothingIsUnderWay) {
  Bench bench(Bench::with_policy(1, ContactPolicy::kReturn));
  in_the_air(bench);
  bench.from_ground(dispatch(4, "goto"));
  bench.from_sim(status(4, TaskState::kEnded));
  lose_ground_at(bench, 10);

  EXPECT_THAT(bench.wake_at(40), Contains("sim: dispatch " + own(40) + " goto"));
}

TEST(ContactPolicyAtDegree1, KeepsItsOwnStatusesFromTheGroundsPlan) {
  Bench bench(Bench::with_policy(1, ContactPolicy::kHold));
  in_the_air(bench);
  lose_ground_at(bench, 10);
  bench.wake_at(40);

  const auto words = bench.from_sim(status(own_id(40), TaskState::kRunning));

  EXPECT_THAT(words, ElementsAre("ground: " + own(40) + " running"));
}

TEST(ContactPolicyAtDegree1, AContactRegainedBeforeTheDelayLeavesTheGroundsTasksAlone) {
  Bench bench(Bench::with_policy(1, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(dispatch(4, "goto"));
  lose_ground_at(bench, 10);
  bench.set_time(20);
  bench.hear_ground(true);

  EXPECT_THAT(bench.wake_at(100), IsEmpty());
  EXPECT_THAT(bench.from_sim(status(4, TaskState::kEnded)), ElementsAre("ground: status 4 ended"));
}

// The ground is back while its tasks are being interrupted: what was begun goes on, and the ground
// is told of everything.
TEST(ContactPolicyAtDegree1, AContactRegainedAmidTheInterruptionIsToldOfTheEnd) {
  Bench bench(Bench::with_policy(1, ContactPolicy::kHold));
  in_the_air(bench);
  bench.from_ground(dispatch(4, "goto"));
  bench.from_sim(status(4, TaskState::kRunning));
  lose_ground_at(bench, 10);
  bench.wake_at(40);
  bench.hear_ground(true);

  EXPECT_THAT(bench.from_sim(status(4, TaskState::kAborted)),
              ::testing::IsSupersetOf(
                  {std::string("ground: status 4 aborted"), "sim: dispatch " + own(40) + " wait"}));
}

}  // namespace
}  // namespace skein::ddn
