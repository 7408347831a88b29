// SPDX-License-Identifier: Apache-2.0
// A joint task that is not agreed on: how often it is tried, and for how long. "marvin" and "heliv"
// are its members.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "skein/decision_node/stand_in.hpp"
#include "testing/flown_node.hpp"
#include "testing/negotiating_partner.hpp"
#include "testing/stood_in.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskState;
using interaction::JointPhase;
using interaction::SessionMessage;
using testing::all;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Stands in for "marvin"; heliv answers each session, and can play no role.
class NotAgreedOn : public ::testing::Test {
 protected:
  NotAgreedOn() {
    give(testing::flying(true));
    give(PlayJointTask{testing::watching_task()});
  }

  void give(const StandInInput& input) {
    std::deque<StandInEffects> open{stand_in_.handle(input, now_)};
    while (!open.empty()) {
      const StandInEffects effects = std::move(open.front());
      open.pop_front();
      for (const auto& one : all<SendNegotiation>(effects.said))
        for (const SessionMessage& answer :
             heliv_.answers(interaction::SessionMessageReceived{one.message}, now_))
          open.push_back(stand_in_.handle(answer, now_));
      for (const auto& one : all<NegotiationNoted>(effects.said))
        if (one.state == "failed") failed_.push_back(now_);
      for (const Notice& one : all<Notice>(effects.said)) notices_.push_back(one.text);
      for (const auto& one : effects.changed)
        if (is_terminal(one.state)) over_.push_back(one.reason);
    }
  }

  /// Marvin's telemetry and heliv's come each second.
  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      now_ = now_ + Duration::seconds(1);
      world::Telemetry own = testing::flying(true), other = own;
      own.state.position = place_;
      other.uav = "heliv";
      give(own);
      give(PartnerSeen{other});
      give(Tick{});
    }
  }

  /// What heliv says of the joint task.
  void tell(JointPhase phase, const std::string& why) { tell({phase, why, std::nullopt}); }
  void tell_engaged(MissionTime until) { tell({JointPhase::kLoading, "", until}); }

  struct Said {
    JointPhase phase;
    std::string why;
    std::optional<MissionTime> start;
  };
  void tell(const Said& said) {
    JointTaskTold told;
    told.status.uav = "heliv";
    told.status.subject = testing::joint().subject;
    told.status.phase = said.phase;
    told.status.why = said.why;
    told.status.agreed_start = said.start;
    told.at = now_;
    give(told);
  }

  std::size_t failed_since(MissionTime from) const {
    return static_cast<std::size_t>(
        std::count_if(failed_.begin(), failed_.end(), [&](MissionTime at) { return at > from; }));
  }

  MissionTime now_ = MissionTime::seconds(10);
  world::Vector3 place_ = world::Vector3::Zero();
  std::vector<MissionTime> failed_;  ///< sessions
  std::vector<std::string> notices_, over_;

 private:
  StandIn stand_in_{testing::stood_in_config("relay")};
  testing::NegotiatingPartner heliv_{failure("it can play no role: watch: no viewpoint")};
};

// Found by an outsider: 120 s of processor time for 539 s of a mission.
TEST_F(NotAgreedOn, WhatIsRefusedForOneReasonIsAskedEverMoreRarely) {
  run(60);
  EXPECT_GE(failed_.size(), 10U);
  const MissionTime then = now_;
  run(120);
  EXPECT_GE(failed_since(then), 5U);
  EXPECT_LE(failed_since(then), 8U);
}

TEST_F(NotAgreedOn, TheReasonIsSaidOnce) {
  run(300);
  EXPECT_THAT(notices_, ElementsAre(HasSubstr("heliv: it can play no role: watch: no viewpoint")));
}

TEST_F(NotAgreedOn, WhoIsElsewhereNowAsksAtOnce) {
  run(120);
  const MissionTime then = now_;
  place_ = {200, 0, 0};
  run(3);
  EXPECT_EQ(failed_since(then), 1U);
}

TEST_F(NotAgreedOn, WithoutAPartnerThatTakesNoPartForAMinuteItIsNotLoaded) {
  run(5);
  tell(JointPhase::kNotLoaded, "no role needs what it has");
  run(40);
  EXPECT_THAT(over_, IsEmpty());
  run(40);
  EXPECT_THAT(over_, ElementsAre("'heliv' takes no part: no role needs what it has"));
}

TEST_F(NotAgreedOn, APartnerThatComesBackToItIsWaitedFor) {
  tell(JointPhase::kNotLoaded, "no role needs what it has");
  run(30);
  tell(JointPhase::kLoading, "");
  run(100);
  EXPECT_THAT(over_, IsEmpty());
}

// Found by an outsider (157): it did the joint task alone.
TEST_F(NotAgreedOn, WhoIsEngagedByAnEarlierOneIsWaitedForAsLongAsThat) {
  tell_engaged(MissionTime::seconds(900));
  run(900);
  EXPECT_THAT(over_, IsEmpty());
  run(60);
  EXPECT_THAT(over_, SizeIs(1)) << "a minute later";
}

TEST_F(NotAgreedOn, WhoIsEngagedNoMoreIsWaitedForAMinute) {
  tell_engaged(MissionTime::seconds(900));
  run(700);
  tell(JointPhase::kLoading, "");
  run(50);
  EXPECT_THAT(over_, IsEmpty());
  run(20);
  EXPECT_THAT(over_, SizeIs(1));
}

/// Heliv is not heard at all, and answers nothing.
class OfASilentPartner : public ::testing::Test {
 protected:
  OfASilentPartner() {
    give(testing::flying(true));
    give(PlayJointTask{testing::watching_task()});
  }
  void give(const StandInInput& input) {
    for (const auto& one : stand_in_.handle(input, now_).changed)
      if (is_terminal(one.state)) over_.push_back(one.reason);
  }
  void run_until(double seconds) {
    while (now_ < MissionTime::seconds(seconds)) {
      now_ = now_ + Duration::seconds(1);
      give(testing::flying(true));
      give(Tick{});
    }
  }
  static Config config() {
    Config config = testing::stood_in_config("relay");
    config.partner_lease = Duration::seconds(200);
    return config;
  }

  MissionTime now_ = MissionTime::seconds(10);
  std::vector<std::string> over_;
  StandIn stand_in_{config()};
};

// It counts as heard when it is asked for, and as silent 5 s later.
TEST_F(OfASilentPartner, ItIsNotLoadedAfterTheLease) {
  run_until(214);
  EXPECT_THAT(over_, IsEmpty());
  run_until(216);
  EXPECT_THAT(over_, ElementsAre("no contact with 'heliv' since 15 s"));
}

TEST_F(OfASilentPartner, OnceItIsDeclaredLostItIsNotLoaded) {
  run_until(60);
  give(PartnerLost{"heliv"});
  EXPECT_THAT(over_, ElementsAre("'heliv' is declared lost"));
}

TEST(Loading, WhoFitsNoRoleTellsItsPartners) {
  Config config = testing::stood_in_config("relay");
  auto library = std::make_shared<interaction::Library>(*config.interaction);
  for (auto& [name, role] : library->roles) role.requirements.push_back({"device", "sonar"});
  config.interaction = library;
  StandIn stand_in(config);
  stand_in.handle(testing::flying(true), MissionTime::seconds(10));

  const auto effects =
      stand_in.handle(PlayJointTask{testing::watching_task()}, MissionTime::seconds(10));

  const auto told = all<JointTaskChanged>(effects.said);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].partners, ElementsAre("heliv"));
  EXPECT_EQ(told[0].status.phase, JointPhase::kNotLoaded);
  EXPECT_THAT(told[0].status.why, HasSubstr("sonar"));
}

}  // namespace
}  // namespace skein::decision_node
