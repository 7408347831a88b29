// SPDX-License-Identifier: Apache-2.0
// A joint task that comes after another one in the plan of "marvin". "heliv" is the partner in
// both.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "testing/flown_node.hpp"
#include "testing/joint_host.hpp"
#include "testing/negotiating_partner.hpp"

namespace skein::decision_node {
namespace {

using executive::TaskId;
using interaction::JointPhase;
using interaction::JointTaskStatus;
using interaction::SessionMessage;
using testing::all;

constexpr TaskId kFirst{7}, kSecond{8};

/// Heliv takes part in the second, and in the first while it `has_first`. Each could begin at once.
class TwoInARow : public ::testing::Test {
 protected:
  TwoInARow() {
    host_.bus().begin(now_);
    host_.partners().start(now_);
    host_.partners().contact({"heliv", false, true}, now_);
    interaction_.start();
    interaction_.vehicle_told(testing::flying(true));
    host_.plan = {kFirst, kSecond};
    load(kFirst, 60);
    load(kSecond, 90);
    exchange();
  }

  void load(TaskId id, double duration) {
    mission::ElementaryTask task = testing::watching("marvin heliv", duration);
    task.id = id;
    interaction_.load({std::move(task), {{Duration(), Duration::max()}}});
  }

  void run(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      now_ = now_ + Duration::seconds(1);
      host_.bus().begin(now_);
      interaction_.time_passes();
      exchange();
    }
  }

  /// Heliv says that it has left the first one.
  void first_is_left() {
    host_.bus().begin(now_);
    JointTaskTold told;
    told.status.uav = "heliv";
    told.status.subject = of(kFirst).subject;
    told.status.phase = JointPhase::kAborted;
    told.at = now_;
    interaction_.hear(told);
    exchange();
  }

  void without_first() { host_.plan = {kSecond}; }

  /// What marvin said of it last.
  const JointTaskStatus& of(TaskId id) const { return said_.at(id.value()); }
  const std::vector<JointPhase>& phases(TaskId id) const { return phases_.at(id.value()); }

  /// The executive asks for it.
  void due(TaskId id) {
    host_.bus().begin(now_);
    interaction_.due(id, false);
    exchange();
  }

  bool has_first = false;

 private:
  /// Until neither says anything more.
  void exchange() {
    std::deque<SessionMessage> to_heliv;
    const auto note = [&] {
      const Effects effects = host_.bus().end();
      host_.bus().begin(now_);
      for (const auto& one : all<SendNegotiation>(effects)) to_heliv.push_back(one.message);
      for (const auto& one : all<JointTaskChanged>(effects)) {
        said_[one.status.task] = one.status;
        auto& phases = phases_[one.status.task];
        if (phases.empty() || phases.back() != one.status.phase) phases.push_back(one.status.phase);
      }
    };
    note();
    while (!to_heliv.empty()) {
      const SessionMessage message = to_heliv.front();
      to_heliv.pop_front();
      for (const SessionMessage& answer :
           heliv_.answers(interaction::SessionMessageReceived{message}, now_)) {
        interaction_.hear(answer);
        note();
      }
    }
  }

  testing::NegotiatingPartner::Offer offer(const interaction::Terms& terms) const {
    if (!has_first && terms.subject.starts_with(of(kFirst).subject))
      return failure("no such joint task here");
    if (terms.modality == "time-interval")
      return interaction::Rows{{"interval", "", {now_.to_seconds(), 1e9}}};
    return interaction::Rows{{"watch", "", {1}}};
  }

  MissionTime now_ = MissionTime::seconds(10);
  testing::LoneJointHost host_;
  Interaction interaction_{host_};
  std::map<std::uint64_t, JointTaskStatus> said_;
  std::map<std::uint64_t, std::vector<JointPhase>> phases_;
  testing::NegotiatingPartner heliv_{[this](const auto& terms) { return offer(terms); }};
};

// Found by an outsider (157): its partner began, and did alone what it could not begin yet.
TEST_F(TwoInARow, NoStartIsOfferedBeforeTheFirstIsAgreedOn) {
  run(60);
  ASSERT_EQ(of(kFirst).phase, JointPhase::kLoading);
  EXPECT_EQ(of(kSecond).phase, JointPhase::kLoading);
  EXPECT_EQ(of(kSecond).holders.size(), 2U) << "roles are agreed on meanwhile";
  EXPECT_EQ(of(kSecond).agreed_start, MissionTime::seconds(10) + LoadingTime::kTryFor)
      << "so long it may wait for the first";
}

TEST_F(TwoInARow, OnceTheFirstIsAgreedOnSoIsTheSecond) {
  run(60);
  has_first = true;
  run(30);
  EXPECT_EQ(of(kFirst).phase, JointPhase::kLoaded);
  EXPECT_EQ(of(kSecond).phase, JointPhase::kLoaded);
}

// Found over DDS on a loaded machine: its chronicle went from loading to running.
TEST_F(TwoInARow, OneThatMayBeginAsItIsAgreedOnIsSaidToBeLoadedAllTheSame) {
  due(kFirst);
  has_first = true;
  run(30);
  std::vector<JointPhase> first = phases(kFirst);
  first.resize(3);
  EXPECT_THAT(first, ::testing::ElementsAre(JointPhase::kLoading, JointPhase::kLoaded,
                                            JointPhase::kRunning));
}

TEST_F(TwoInARow, OnceTheFirstIsNotInThePlanAnyMoreTheSecondIsAgreedOn) {
  run(600);
  ASSERT_EQ(of(kFirst).phase, JointPhase::kNotLoaded);
  run(5);
  EXPECT_EQ(of(kSecond).phase, JointPhase::kLoading) << "its plan is being made anew";
  without_first();
  run(5);
  EXPECT_EQ(of(kSecond).phase, JointPhase::kLoaded);
}

TEST_F(TwoInARow, OnceTheFirstIsLeftTheStartOfTheSecondDoesNotStand) {
  has_first = true;
  run(30);
  ASSERT_EQ(of(kSecond).phase, JointPhase::kLoaded);
  has_first = false;
  first_is_left();
  EXPECT_EQ(of(kSecond).phase, JointPhase::kLoading);
}

}  // namespace
}  // namespace skein::decision_node
