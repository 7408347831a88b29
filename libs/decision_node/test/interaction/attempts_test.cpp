// SPDX-License-Identifier: Apache-2.0
// A joint task that is tried again waits for a silent partner as one, not anew each time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/joint_host.hpp"

namespace skein::decision_node {
namespace {

using interaction::JointPhase;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Heliv is silent from 0 s on; its lease is 200 s.
class Attempts : public ::testing::Test {
 protected:
  Attempts() {
    at(0);
    host.partners().start(host.bus().now());
    interaction.start();
    host.partners().contact({"heliv", false, false}, host.bus().now());
  }
  static Config config() {
    Config config = testing::stood_in_config("relay");
    config.partner_lease = Duration::seconds(200);
    return config;
  }
  void at(double seconds) { host.bus().begin(MissionTime::seconds(seconds)); }
  /// Loads it as a task of the plan that could begin at once, `until` then at the latest.
  void load(std::uint64_t id, double until) {
    supervisor::LoadJointTask asked{testing::watching(), {{Duration(), Duration::seconds(until)}}};
    asked.task.id = executive::TaskId(id);
    asked.task.time.start_before = MissionTime::seconds(until);
    interaction.load(asked);
  }
  void run(double from, double until) {
    for (double now = from; now < until; ++now) {
      at(now);
      interaction.time_passes();
    }
  }

  testing::LoneJointHost host{config()};
  Interaction interaction{host};
};

// Found by random missions (--partners 800023).
TEST_F(Attempts, OneThatFollowsAnotherAtOnceGoesOnWaiting) {
  load(7, 100);
  run(1, 110);
  ASSERT_THAT(host.not_loaded, SizeIs(1));
  load(8, 400);
  run(111, 199);
  ASSERT_THAT(host.not_loaded, SizeIs(1));
  run(199, 202);
  ASSERT_THAT(host.not_loaded, SizeIs(2));
  EXPECT_THAT(host.not_loaded.back(), HasSubstr("no contact with 'heliv' since 0 s"));
}

TEST_F(Attempts, OneThatIsMadeLaterHasALeaseOfItsOwn) {
  load(7, 100);
  run(1, 150);
  ASSERT_THAT(host.not_loaded, SizeIs(1));
  load(8, 900);
  run(151, 340);
  EXPECT_THAT(host.not_loaded, SizeIs(1));
  run(340, 360);
  EXPECT_THAT(host.not_loaded, SizeIs(2));
}

// Found by random missions (--sharing 329): tried for a minute each time, it never had done without
// who refused it, and its partners had.
TEST_F(Attempts, WhoHasTakenNoPartSinceTheFirstIsNotWaitedForAnew) {
  host.partners().contact({"heliv", false, true}, host.bus().now());
  load(7, 50);
  JointTaskTold refused;
  refused.status.uav = "heliv";
  refused.status.subject = testing::joint().subject;
  refused.status.phase = interaction::JointPhase::kNotLoaded;
  refused.status.why = "no energy";
  interaction.hear(refused);
  run(1, 62);
  ASSERT_THAT(host.not_loaded, SizeIs(1));
  load(8, 400);
  ASSERT_THAT(host.not_loaded, SizeIs(2));
  EXPECT_EQ(host.not_loaded.back(), "'heliv' takes no part: no energy");
}

class Refused : public Attempts {
 protected:
  // At 10 s Heliv takes no part; this node is dead from 20 s to 300 s.
  Refused() {
    host.partners().contact({"heliv", false, true}, host.bus().now());
    load(7, 900);
    at(10);
    heliv_is(JointPhase::kNotLoaded);
    run(11, 20);
    at(300);
    interaction.refusals().resume(host.bus().now());
  }
  void heliv_is(JointPhase phase) {
    JointTaskTold told;
    told.at = host.bus().now();
    told.status.uav = "heliv";
    told.status.subject = testing::joint().subject;
    told.status.phase = phase;
    told.status.why = "no energy";
    interaction.hear(told);
  }
};

// What Heliv said since is not read yet.
TEST_F(Refused, BackAfterMinutesItDoesNotBelieveForGoodWhatItHeardBefore) {
  run(300, 302);
  ASSERT_THAT(host.not_loaded, IsEmpty());

  heliv_is(JointPhase::kLoading);
  run(302, 500);
  EXPECT_THAT(host.not_loaded, IsEmpty());
}

TEST_F(Refused, WhoSaysNothingElseTakesNoPartThenEither) {
  run(300, 359);
  ASSERT_THAT(host.not_loaded, IsEmpty());

  run(359, 400);
  ASSERT_THAT(host.not_loaded, SizeIs(1));
  EXPECT_EQ(host.not_loaded.back(), "'heliv' takes no part: no energy");
}

// Found by missions of an outsider (256): the executive was told that it is aborted, which it was.
TEST_F(Attempts, OneThatGoesOnUnderAnotherNumberWasNotStartedUnderThat) {
  load(7, 400);
  interaction.due(executive::TaskId(7), false);
  load(7, 300);
  load(8, 400);
  interaction.leave(executive::TaskId(8), "not wanted");
  EXPECT_THAT(host.inputs, IsEmpty());

  load(9, 400);
  interaction.due(executive::TaskId(9), false);
  load(9, 300);
  interaction.leave(executive::TaskId(9), "not wanted");
  EXPECT_THAT(host.inputs, SizeIs(1)) << "the executive had started that one";
}

}  // namespace
}  // namespace skein::decision_node
