// SPDX-License-Identifier: Apache-2.0
// Requests of operators in words, and whom they command.
#include "skein/ground_orders/operator_request.hpp"

#include <gmock/gmock.h>

#include <set>
#include <string>

namespace skein::ground_station {
namespace {

template <class Deed>
Deed to(const std::string& uav) {
  Deed deed;
  deed.uav = uav;
  return deed;
}

TEST(OperatorDeed, IsSaidWithItsObject) {
  CloseAir closed;
  closed.volume.name = "tower";
  SetDegree degree = to<SetDegree>("marvin");
  degree.change.degree = 4;
  LetGo passed = to<LetGo>("heliv");
  passed.to = "anna";

  EXPECT_EQ(to_text(Action(to<TakeInHand>("marvin"))), "take_in_hand marvin");
  EXPECT_EQ(to_text(Action(closed)), "close_air tower");
  EXPECT_EQ(to_text(Action(OpenAir{"tower"})), "open_air tower");
  EXPECT_EQ(to_text(Action(degree)), "degree marvin 4");
  EXPECT_EQ(to_text(Action(Finish{})), "finish");
  EXPECT_EQ(to_text(JudgeAlarm{AlarmId(1), AlarmState::kInfirmed}), "judge_alarm 1 infirmed");
  EXPECT_EQ(to_text(passed), "let_go heliv to anna");
  EXPECT_EQ(to_text(to<LetGo>("heliv")), "let_go heliv");
  EXPECT_EQ(to_text(Answer{"yes"}), "answer yes");
}

TEST(OperatorDeed, OfEachKindHasAWordOfItsOwn) {
  const std::vector<Action> all{SendPlan{},
                                AbortTasks{},
                                SendMessage{},
                                UpdateConditions{},
                                SendMission{},
                                CancelMission{},
                                SetDegree{},
                                TakeInHand{},
                                GiveBack{},
                                ResumePlan{},
                                DropPlan{},
                                CloseAir{},
                                OpenAir{},
                                TellWorld{},
                                SendGlobalMission{},
                                DeclareLost{},
                                DeclareFound{},
                                PlayRole{},
                                Finish{}};
  std::set<std::string> words;
  for (const Action& one : all) {
    const std::string text = to_text(OperatorDeed(one));
    words.insert(text.substr(0, text.find(' ')));
  }

  EXPECT_EQ(words.size(), all.size());
  EXPECT_EQ(all.size(), std::variant_size_v<Action>);
}

TEST(OperatorDeed, CommandsTheUavItIsFor) {
  EXPECT_EQ(commanded_by(Action(to<SendPlan>("marvin"))), "marvin");
  EXPECT_EQ(commanded_by(Action(to<GiveBack>("marvin"))), "marvin");
  EXPECT_EQ(commanded_by(to<SteerTo>("marvin")), "marvin");
}

// Else nobody could declare lost, or ask for, what another has in hand.
TEST(OperatorDeed, CommandsNobodyWhereItOnlySpeaksOfAUav) {
  EXPECT_EQ(commanded_by(Action(to<DeclareLost>("marvin"))), "");
  EXPECT_EQ(commanded_by(Action(to<DeclareFound>("marvin"))), "");
  EXPECT_EQ(commanded_by(to<AskForUav>("marvin")), "");
  EXPECT_EQ(commanded_by(to<KeepUav>("marvin")), "");
  EXPECT_EQ(commanded_by(to<LetGo>("marvin")), "");
  EXPECT_EQ(commanded_by(Answer{"yes"}), "");
}

// ---- names of states ----

TEST(States, HaveNamesOfTheirOwn) {
  const std::set<std::string_view> commands{
      to_text(CommandState::kIssued), to_text(CommandState::kDelivered),
      to_text(CommandState::kAcknowledged), to_text(CommandState::kRefused),
      to_text(CommandState::kExpired)};
  const std::set<std::string_view> held{to_text(HeldState::kHeld), to_text(HeldState::kResumed),
                                        to_text(HeldState::kDropped)};

  EXPECT_EQ(commands.size(), 5U);
  EXPECT_EQ(held.size(), 3U);
}

TEST(States, AfterWhichNothingFollowsAreThreeOfFive) {
  EXPECT_FALSE(is_settled(CommandState::kIssued));
  EXPECT_FALSE(is_settled(CommandState::kDelivered));
  EXPECT_TRUE(is_settled(CommandState::kAcknowledged));
  EXPECT_TRUE(is_settled(CommandState::kRefused));
  EXPECT_TRUE(is_settled(CommandState::kExpired));
}

}  // namespace
}  // namespace skein::ground_station
