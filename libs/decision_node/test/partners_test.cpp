// SPDX-License-Identifier: Apache-2.0
// How long a silent partner is waited for. The lease is 100 s.
#include "partners.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/mission/lost_uav.hpp"
#include "testing/flown_node.hpp"

namespace skein::decision_node {
namespace {

using testing::all;
using ::testing::Contains;
using testing::FlownNode;

class APartner : public ::testing::Test {
 protected:
  APartner() { partners.start(MissionTime::seconds(0)); }
  void heard(double when) { partners.contact({"heliv", false, true}, MissionTime::seconds(when)); }
  void silent(double when) {
    partners.contact({"heliv", false, false}, MissionTime::seconds(when));
  }
  std::string given_up(double waits, double now) {
    return partners.given_up("heliv", MissionTime::seconds(waits), MissionTime::seconds(now))
        .value_or("");
  }

  Partners partners{Duration::seconds(100)};
};

TEST_F(APartner, ThatIsHeardIsWaitedForForAnyTime) {
  heard(5);
  EXPECT_EQ(given_up(10, 10'000), "");
}

TEST_F(APartner, ThatFallsSilentIsGivenUpAfterItsLease) {
  heard(5);
  silent(50);
  EXPECT_EQ(given_up(10, 149), "");
  EXPECT_EQ(partners.gives_up_at("heliv", MissionTime::seconds(10)), MissionTime::seconds(150));
  EXPECT_EQ(given_up(10, 150), "no contact with 'heliv' since 50 s");
}

TEST_F(APartner, OfWhomNothingWasEverHeardIsSilentFromTheBeginning) {
  EXPECT_EQ(given_up(0, 100), "no contact with 'heliv' since 0 s, when this node began");
  silent(120);
  EXPECT_EQ(given_up(0, 130), "no contact with 'heliv' since 0 s, when this node began");
}

TEST_F(APartner, ThatIsSilentAlreadyIsWaitedForForALease) {
  heard(5);
  silent(50);
  EXPECT_EQ(given_up(200, 299), "");
  EXPECT_EQ(given_up(200, 300), "no contact with 'heliv' since 50 s");
}

// Found by random missions (--partners --merged --long-deaths 1020028): dead itself for nine
// minutes, it gave up one that had been heard by all others.
TEST_F(APartner, ThatWasSilentBeforeThisNodeDiedIsSilentFromWhenItIsBack) {
  heard(5);
  silent(50);

  partners.resume(MissionTime::seconds(600));

  EXPECT_EQ(given_up(10, 699), "");
  EXPECT_EQ(given_up(10, 700), "no contact with 'heliv' since 600 s, when this node began");
}

TEST_F(APartner, ThatWasHeardBeforeThisNodeDiedIsWaitedFor) {
  heard(5);
  partners.resume(MissionTime::seconds(600));
  EXPECT_EQ(given_up(10, 10'000), "");
}

// Found by random missions (--robots 950007).
TEST_F(APartner, WhoseWordsComeByWayOfTheGroundIsWaitedForAsLongAsThatIsHeard) {
  const auto ground = [&](double when, bool reachable) {
    partners.contact({"ground", true, reachable}, MissionTime::seconds(when));
  };
  const auto ends = [&] {
    return partners.gives_up_past_ground_at("heliv", MissionTime::seconds(10));
  };
  heard(5);
  silent(50);
  ground(5, true);
  EXPECT_EQ(ends(), std::nullopt);

  ground(70, false);
  EXPECT_EQ(ends(), MissionTime::seconds(170));

  heard(80);
  EXPECT_EQ(ends(), std::nullopt);
}

TEST_F(APartner, ThatComesBackWithinTheLeaseIsAsBefore) {
  heard(5);
  silent(50);
  heard(140);
  EXPECT_EQ(given_up(10, 1000), "");
  silent(1000);
  EXPECT_EQ(given_up(10, 1099), "");
}

TEST_F(APartner, ThatIsGivenUpIsWaitedForByNothingElse) {
  heard(5);
  silent(50);
  given_up(10, 150);
  EXPECT_EQ(given_up(300, 299), "");
  EXPECT_NE(given_up(300, 300), "");
  heard(400);
  EXPECT_EQ(given_up(300, 10'000), "");
}

TEST_F(APartner, ThatIsDeclaredLostIsGivenUpAtOnceUntilItIsHeardAnew) {
  heard(5);
  partners.declare_lost("heliv");
  EXPECT_EQ(given_up(10, 10), "'heliv' is declared lost");
  silent(20);
  EXPECT_EQ(given_up(10, 20), "'heliv' is declared lost");
  heard(30);
  EXPECT_EQ(given_up(10, 30), "");
}

TEST_F(APartner, ThatIsFoundAgainIsWaitedForThoughItWasNeverOutOfReach) {
  heard(5);
  partners.declare_lost("heliv");
  partners.declare_found("heliv");
  EXPECT_EQ(given_up(10, 10), "");
}

TEST_F(APartner, IsNotTheGroundStation) {
  heard(5);
  partners.contact({"heliv", true, false}, MissionTime::seconds(10));
  EXPECT_EQ(given_up(10, 10'000), "");
}

executive::Start waiting_for_heliv() {
  executive::Start start = testing::start_of(1, "synchronise");
  start.task.synchronisation = executive::Synchronisation{551, {"heliv"}, {"marvin"}, {}};
  return start;
}

std::vector<std::string> aborted(const Effects& effects) {
  std::vector<std::string> reasons;
  for (const TaskChanged& one : all<TaskChanged>(effects))
    if (one.event.state == executive::TaskState::kAborted) reasons.push_back(one.event.reason);
  return reasons;
}

TEST(DeclaredLost, EndsTheWaitOfASynchronisationAtOnceAtAnyDegree) {
  for (const int degree : {2, 3}) {
    FlownNode marvin(degree);
    marvin.answer_to(waiting_for_heliv());
    const Effects effects =
        marvin.give(Command{{1, 1}, executive::ProcessMessage{mission::lost_message("heliv")}});
    EXPECT_THAT(aborted(effects), Contains("'heliv' is declared lost")) << degree;
  }
}

TEST(DeclaredLost, AndFoundAgainItIsWaitedFor) {
  FlownNode marvin(3);
  const auto told = [&](std::uint64_t number, const std::string& message) {
    return marvin.give(Command{{1, number}, executive::ProcessMessage{message}});
  };
  told(1, mission::lost_message("heliv"));
  told(2, mission::found_message("heliv"));
  marvin.answer_to(waiting_for_heliv());
  EXPECT_THAT(aborted(marvin.give(Tick{})), ::testing::IsEmpty());
}

TEST(DeclaredLost, OfAStrangerNothingFollows) {
  FlownNode marvin(3);
  marvin.answer_to(waiting_for_heliv());
  const Effects effects = marvin.give(Command{{1, 1}, executive::ProcessMessage{"lost karma"}});
  EXPECT_THAT(aborted(effects), ::testing::IsEmpty());
}

// Its script decides how long is waited.
TEST(DeclaredLost, BelowDegree4SilenceAloneEndsNoWait) {
  FlownNode marvin(3);
  marvin.answer_to(waiting_for_heliv());
  marvin.give(Contact{"heliv", false, false});
  EXPECT_THAT(aborted(marvin.wake_at(10'000)), ::testing::IsEmpty());
}

}  // namespace
}  // namespace skein::decision_node
