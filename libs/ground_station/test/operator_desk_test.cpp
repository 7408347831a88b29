// SPDX-License-Identifier: Apache-2.0
// Operators at a ground station: through GroundControl, as they meet it.
#include "skein/ground_station/operator_desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "skein/foundation/fingerprint.hpp"
#include "skein/ground_station/ground_control.hpp"
#include "testing/builders.hpp"
#include "testing/one_ground.hpp"

namespace skein::ground_station {
namespace {

using testing::a_step;
using testing::at;
using testing::control;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::only;
using ::testing::SizeIs;
using Effects = std::vector<GroundControl::Effect>;

OperatorRequest request(const std::string& who, std::uint64_t number,
                        std::vector<OperatorDeed> deeds) {
  Fingerprint print;
  for (const OperatorDeed& deed : deeds) print.put(to_text(deed));
  return {who, number, print.value(), std::move(deeds), {}};
}

OperatorDeed take(const std::string& uav) { return Action(TakeInHand{uav, false}); }
OperatorDeed give_back(const std::string& uav) { return Action(GiveBack{uav}); }
OperatorDeed abort_all(const std::string& uav) { return Action(AbortTasks{uav, std::nullopt}); }
OperatorDeed message(const std::string& uav) { return Action(SendMessage{uav, "hallo"}); }

/// A ground station of two UAVs at degree 3 with operators.
class Desk : public ::testing::Test {
 protected:
  Desk() : ground_(control({{"marvin", 3, {}}, {"heliv", 3, {}}}, script())) {}

  static Script script() {
    Script script;
    script.steps.push_back(a_step("go", {OnOperator{"start"}}));
    return script;
  }

  /// The one answer to it.
  OperatorAnswered ask(const OperatorRequest& asked, double seconds) {
    effects_ = ground_.handle(asked, at(seconds));
    const auto answers = only<OperatorAnswered>(effects_);
    EXPECT_THAT(answers, SizeIs(1));
    return answers.empty() ? OperatorAnswered() : answers.front();
  }
  std::string holder(const std::string& uav) const { return ground_.desk().hand_of(uav).holder; }

  GroundControl ground_;
  Effects effects_;
};

TEST_F(Desk, TakesAUavInHandAndTellsWhenTheUavHasAnswered) {
  const OperatorAnswered answer = ask(request("ada", 1, {take("marvin")}), 1);

  EXPECT_TRUE(answer.accepted);
  EXPECT_FALSE(answer.complete);
  ASSERT_THAT(answer.commands, SizeIs(1));
  EXPECT_EQ(answer.commands[0].what, "DEGREE 1");
  EXPECT_EQ(holder("marvin"), "ada");
  EXPECT_THAT(only<HandChanged>(effects_), SizeIs(1));
  const auto after =
      ground_.handle(RequestReplyReceived{answer.commands[0].command, true, ""}, at(2));
  ASSERT_THAT(only<OperatorAnswered>(after), SizeIs(1));
  EXPECT_TRUE(only<OperatorAnswered>(after)[0].complete);
  EXPECT_EQ(only<OperatorAnswered>(after)[0].commands[0].state, CommandState::kAcknowledged);
}

TEST_F(Desk, DoesARequestOnceHoweverOftenItIsAsked) {
  const OperatorAnswered first = ask(request("ada", 1, {take("marvin")}), 1);
  const OperatorAnswered again = ask(request("ada", 1, {take("marvin")}), 2);

  EXPECT_THAT(only<SendRequest>(effects_), IsEmpty());
  ASSERT_THAT(again.commands, SizeIs(1));
  EXPECT_EQ(again.commands[0].command, first.commands[0].command);
}

TEST_F(Desk, RefusesAnotherRequestUnderAUsedNumberAndTellsOfTheFirstAsBefore) {
  ask(request("ada", 1, {take("marvin")}), 1);

  const OperatorAnswered other = ask(request("ada", 1, {take("heliv")}), 2);

  EXPECT_FALSE(other.accepted);
  EXPECT_THAT(other.problems, ElementsAre(HasSubstr("was another request")));
  EXPECT_EQ(holder("heliv"), "");
  EXPECT_TRUE(ask(request("ada", 1, {take("marvin")}), 3).accepted);
}

TEST_F(Desk, NumbersOfTwoOperatorsAreTheirOwn) {
  EXPECT_TRUE(ask(request("ada", 1, {take("marvin")}), 1).accepted);
  EXPECT_TRUE(ask(request("bo", 1, {take("heliv")}), 1).accepted);
  EXPECT_EQ(holder("marvin"), "ada");
  EXPECT_EQ(holder("heliv"), "bo");
}

TEST_F(Desk, NobodyCommandsAUavInHandOfAnother) {
  ask(request("ada", 1, {take("marvin")}), 1);

  const OperatorAnswered answer =
      ask(request("bo", 1, {take("marvin"), abort_all("marvin"), message("heliv")}), 2);

  EXPECT_FALSE(answer.accepted);
  EXPECT_THAT(answer.problems, ElementsAre(HasSubstr("in hand of ada"), HasSubstr("of ada")));
  EXPECT_THAT(only<SendRequest>(effects_), IsEmpty()) << "none of it is done";
  EXPECT_EQ(holder("marvin"), "ada");
}

TEST_F(Desk, AUavThatIsNotKeptPassesToWhoAsked) {
  ask(request("ada", 1, {take("marvin")}), 1);
  ask(request("bo", 1, {AskForUav{"marvin"}}), 10);
  EXPECT_EQ(ground_.next_wakeup(), at(40));

  const auto effects = ground_.handle(Tick{}, at(40));

  EXPECT_EQ(holder("marvin"), "bo");
  EXPECT_THAT(only<HandChanged>(effects), SizeIs(1));
}

TEST_F(Desk, AUavThatIsKeptStays) {
  ask(request("ada", 1, {take("marvin")}), 1);
  ask(request("bo", 1, {AskForUav{"marvin"}}), 10);
  ask(request("ada", 2, {KeepUav{"marvin"}}), 20);

  ground_.handle(Tick{}, at(50));

  EXPECT_EQ(holder("marvin"), "ada");
}

TEST_F(Desk, LettingGoGivesItToWhoIsNamed) {
  ask(request("ada", 1, {take("marvin")}), 1);

  ask(request("ada", 2, {LetGo{"marvin", "bo"}}), 2);

  EXPECT_EQ(holder("marvin"), "bo");
  EXPECT_THAT(ask(request("ada", 3, {abort_all("marvin")}), 3).problems,
              ElementsAre(HasSubstr("in hand of bo")));
}

TEST_F(Desk, TellsEveryProblemOfARequest) {
  const OperatorAnswered answer =
      ask(request("ada", 1,
                  {AskForUav{"marvin"}, KeepUav{"heliv"}, give_back("marvin"), Answer{"statr"},
                   JudgeAlarm{AlarmId(7), AlarmState::kConfirmed}, SteerTo{"marvin", {{1, 2, 3}}},
                   take("gone")}),
          1);

  EXPECT_THAT(answer.problems,
              ElementsAre(HasSubstr("nobody has marvin"), HasSubstr("not in your hand"),
                          HasSubstr("cannot be given back"), HasSubstr("did you mean 'start'?"),
                          HasSubstr("no alarm 7"), HasSubstr("take it in hand first"),
                          HasSubstr("not in the air"), HasSubstr("unknown UAV 'gone'")));
}

TEST_F(Desk, RefusesWhatIsNoRequestAndStillAnswers) {
  for (const auto& [who, number] : {std::pair<std::string, std::uint64_t>{"", 1},
                                    {"ada", 0},
                                    {std::string(65, 'a'), 1},
                                    {"a\nb", 1}}) {
    const OperatorAnswered answer = ask(request(who, number, {take("marvin")}), 1);
    EXPECT_FALSE(answer.accepted);
    EXPECT_TRUE(answer.complete);
    EXPECT_EQ(answer.who, who);
  }
  EXPECT_EQ(holder("marvin"), "");
}

TEST_F(Desk, AnswersAStepThatWaitsForAnOperator) {
  EXPECT_THAT(ground_.answers(), ElementsAre("start"));

  EXPECT_TRUE(ask(request("ada", 1, {Answer{"start"}}), 1).complete);

  EXPECT_THAT(only<StepDone>(effects_), SizeIs(1));
  EXPECT_THAT(ground_.answers(), IsEmpty());
}

TEST_F(Desk, SteersAUavInHandAtOnceWithTasksOfItsOwn) {
  world::Telemetry flying;
  flying.uav = "marvin";
  flying.state.airborne = true;
  ground_.handle(flying, at(0));
  ask(request("ada", 1, {take("marvin"), SteerTo{"marvin", {{1, 2, 30}}}}), 1);
  const OperatorAnswered second = ask(request("ada", 2, {SteerTo{"marvin", {{5, 6, 30}}}}), 2);

  ASSERT_THAT(second.commands, SizeIs(1));
  EXPECT_EQ(second.commands[0].what, "START 390000001 goto");
}

// What drives never is in the air.
TEST_F(Desk, SteersWhatDrivesWhereItStands) {
  const SteerTo way{"marvin", {{1, 2, 0}}};
  SteerTo driven = way;
  driven.drives = true;

  EXPECT_FALSE(ask(request("ada", 1, {take("marvin"), way}), 1).accepted);
  EXPECT_TRUE(ask(request("ada", 2, {take("marvin"), driven}), 1).accepted);
}

TEST_F(Desk, TellsOfAnAcceptedRequestWhatCouldNotBeDone) {
  const OperatorAnswered answer = ask(request("ada", 1, {Action(ResumePlan{"marvin"})}), 1);

  EXPECT_TRUE(answer.accepted);
  EXPECT_TRUE(answer.complete);
  EXPECT_THAT(answer.problems, ElementsAre(HasSubstr("no plan of 'marvin' is held")));
}

// What the team says of a mission comes after the request was taken on; until then it is not done.
TEST_F(Desk, AnswersAGlobalMissionOnceTheTeamHasTakenOrRefusedIt) {
  SendGlobalMission send;
  send.mission.id = mission::MissionId(2);
  effects_ = ground_.handle(request("ada", 1, {Action(send)}), at(1));
  ASSERT_THAT(only<OperatorAnswered>(effects_), IsEmpty());
  const auto given = only<GiveGlobalMission>(effects_);
  ASSERT_THAT(given, SizeIs(1));
  const GlobalMissionChanged refused{given[0].mission.id, GlobalStage::kRefused,
                                     "task 23: no UAV 'echo'"};

  const auto after = only<OperatorAnswered>(ground_.handle(refused, at(1)));

  ASSERT_THAT(after, SizeIs(1));
  EXPECT_TRUE(after[0].complete);
  EXPECT_THAT(after[0].problems,
              ElementsAre("global mission 2 is refused: task 23: no UAV 'echo'"));

  effects_ = ground_.handle(request("ada", 2, {Action(send)}), at(2));
  const GlobalMissionChanged taken{send.mission.id, GlobalStage::kGiven, ""};
  const auto done = only<OperatorAnswered>(ground_.handle(taken, at(2)));
  ASSERT_THAT(done, SizeIs(1));
  EXPECT_TRUE(done[0].complete);
  EXPECT_THAT(done[0].problems, IsEmpty());
}

TEST_F(Desk, RemembersSoManyRequestsAndKnowsOfOlderOnesThatTheyAreOld) {
  for (std::uint64_t number = 1; number <= OperatorDesk::kRequestsKept + 10; ++number) {
    ask(request("ada", number, {KeepUav{"marvin"}}), 1);  // refused, and so complete
  }

  const OperatorAnswered old = ask(request("ada", 1, {take("marvin")}), 2);

  EXPECT_THAT(old.problems, ElementsAre(HasSubstr("too old")));
  EXPECT_EQ(holder("marvin"), "");
}

TEST_F(Desk, ListensToSoManyOperatorsAndAnswersTheOthersToo) {
  for (std::size_t i = 0; i < OperatorDesk::kOperators; ++i) {
    ask(request("operator " + std::to_string(i), 1, {KeepUav{"marvin"}}), 1);
  }

  EXPECT_THAT(ask(request("one more", 1, {take("marvin")}), 2).problems,
              ElementsAre("there are too many operators"));
}

// ---- laws, whatever operators do ----

const std::vector<std::string> kWho = {"ada", "bo", "cy"};
const std::vector<std::string> kUavs = {"marvin", "heliv"};

rc::Gen<OperatorDeed> any_deed() {
  return rc::gen::exec([]() -> OperatorDeed {
    const std::string uav = *rc::gen::elementOf(kUavs);
    switch (*rc::gen::inRange(0, 8)) {
      case 0:
      case 1:
        return take(uav);
      case 2:
        return give_back(uav);
      case 3:
        return AskForUav{uav};
      case 4:
        return KeepUav{uav};
      case 5:
        return LetGo{uav, *rc::gen::elementOf(std::vector<std::string>{"", "ada", "bo"})};
      case 6:
        return message(uav);
      default:
        return abort_all(uav);
    }
  });
}

/// What the laws know of: answers and commands, never how the desk came to them.
struct Ledger {
  std::map<std::pair<std::string, std::uint64_t>, std::vector<OperatorAnswered>> answers;
  std::map<CommandNumber, std::vector<CommandState>> commands;

  void take(const Effects& effects) {
    for (const auto& one : only<OperatorAnswered>(effects)) {
      answers[{one.who, one.number}].push_back(one);
    }
    for (const auto& one : only<CommandChanged>(effects)) {
      commands[one.command].push_back(one.state);
    }
  }
};

// Who commanded a UAV by an accepted request had it in hand, or nobody had.
void check_hands(const OperatorRequest& asked, const Effects& effects,
                 const std::map<std::string, std::string>& holders) {
  for (const auto& one : only<OperatorAnswered>(effects)) {
    if (one.who != asked.who || one.number != asked.number || !one.accepted) continue;
    if (asked.deeds.empty()) continue;
    const std::string uav = commanded_by(asked.deeds.front());
    if (uav.empty()) continue;
    RC_ASSERT(holders.at(uav).empty() || holders.at(uav) == asked.who);
  }
}

RC_GTEST_PROP(DeskLaws, EveryRequestIsAnsweredDoneOnceAndCompleteAndNobodyIsCommandedByTwo, ()) {
  GroundControl ground = control({{"marvin", 3, {}}, {"heliv", 4, {}}});
  Ledger ledger;
  std::map<std::string, std::uint64_t> numbers;
  std::vector<OperatorRequest> said;
  std::set<CommandNumber> open;
  double now = 1;
  const int steps = *rc::gen::inRange(1, 60);
  for (int i = 0; i < steps; ++i) {
    now += *rc::gen::inRange(0, 15);
    const int what = *rc::gen::inRange(0, 4);
    Effects effects;
    if (what == 0 && !open.empty()) {  // a UAV answers one of its commands
      const CommandNumber command = *rc::gen::elementOf(open);
      effects =
          ground.handle(RequestReplyReceived{command, *rc::gen::arbitrary<bool>(), ""}, at(now));
      open.erase(command);
    } else {
      const bool again = what == 1 && !said.empty();
      const std::string who = *rc::gen::elementOf(kWho);
      const OperatorRequest asked =
          again ? *rc::gen::elementOf(said) : request(who, ++numbers[who], {*any_deed()});
      std::map<std::string, std::string> holders;
      for (const auto& uav : kUavs) holders[uav] = ground.desk().hand_of(uav).holder;
      ledger.take(ground.handle(Tick{}, at(now)));
      for (const auto& uav : kUavs) holders[uav] = ground.desk().hand_of(uav).holder;
      effects = ground.handle(asked, at(now));
      if (again) {
        RC_ASSERT(only<SendRequest>(effects).empty());
        RC_ASSERT(only<HandChanged>(effects).empty());
      } else {
        check_hands(asked, effects, holders);
      }
      RC_ASSERT(only<OperatorAnswered>(effects).size() >= 1U);
      said.push_back(asked);
    }
    for (const auto& sent : only<SendRequest>(effects)) open.insert(sent.command);
    ledger.take(effects);
  }
  ledger.take(ground.handle(Tick{}, at(now + 1000)));  // what was not answered has expired

  for (const OperatorRequest& asked : said) {
    const auto& answers = ledger.answers[{asked.who, asked.number}];
    RC_ASSERT(!answers.empty());
    RC_ASSERT(answers.back().complete);
    for (const OperatorAnswered& one : answers) {
      RC_ASSERT(one.accepted == answers.front().accepted);
      RC_ASSERT(one.commands.size() == answers.front().commands.size());
    }
  }
  for (const auto& [command, states] : ledger.commands) {
    RC_ASSERT(states.front() == CommandState::kIssued);
    RC_ASSERT(states.size() == 2U || states.size() == 3U);
    RC_ASSERT(states.size() == 2U || states[1] == CommandState::kDelivered);
    RC_ASSERT(is_settled(states.back()));
  }
}

}  // namespace
}  // namespace skein::ground_station
