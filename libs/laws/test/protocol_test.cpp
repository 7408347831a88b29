// SPDX-License-Identifier: Apache-2.0
// The checker of event logs sees what it is there to see.
#include "skein/laws/protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::laws {
namespace {

namespace lines = journal::lines;

using journal::Record;
using journal::record_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Log = std::vector<Record>;

MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

Record task(double seconds, const char* state, const char* node = "marvin") {
  return record_of(at(seconds), node, lines::Task{.uav = "marvin", .task = 1, .state = state});
}
Record command(double seconds, const char* state) {
  return record_of(at(seconds), "ground",
                   lines::Command{.uav = "marvin", .command = 1, .state = state});
}
Record sync(double seconds, const char* direction) {
  return record_of(at(seconds), "marvin",
                   lines::Sync{.id = 551, .from = "heliv", .to = "marvin", .direction = direction});
}
Record message(double seconds, std::uint64_t sequence, const char* direction) {
  return record_of(
      at(seconds), "marvin",
      lines::Message{
          .from = "ground", .to = "marvin", .sequence = sequence, .direction = direction});
}
Record link_of(double seconds, const char* from, const char* to, bool up) {
  return record_of(at(seconds), "sim", lines::Link{.from = from, .to = to, .up = up});
}
Record link(double seconds, bool up) { return link_of(seconds, "ground", "marvin", up); }
Record unsent(double seconds, const char* why) {
  return record_of(at(seconds), "marvin",
                   lines::Unsent{.slot = "TaskEvent", .to = "ground", .why = why});
}
Record fault(double seconds, const char* what, const char* node) {
  return record_of(at(seconds), "runner", lines::Fault{.what = what, .target = node});
}
Record degree(double seconds) {
  return record_of(at(seconds), "marvin", lines::Degree{.uav = "marvin", .degree = 1});
}
Record route(double seconds) {
  return record_of(at(seconds), "ground", lines::Route{.peer = "marvin", .via = "heliv"});
}

TEST(JournalLaws, ATaskGoesOnWithWhoTakesItOver) {
  const Log log{task(1, "scheduled"), task(1, "started"), task(2, "running"), degree(3),
                task(4, "ended", "ground")};
  const Log begun_again{task(1, "scheduled"), task(1, "started"), degree(3),
                        task(4, "scheduled"), task(4, "started"), task(5, "ended")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
  EXPECT_THAT(broken_protocol(begun_again), IsEmpty());
}

// Found by killing each daemon at each event of a hand-over: the UAV has its plan back while the
// ground station does not know yet, and begins what it had taken over itself.
TEST(JournalLaws, BothGoOnWithATaskThatWasHandedToAndFroButEachOnce) {
  const Log log{task(1, "scheduled"), degree(2), degree(3), task(4, "started", "ground"),
                task(5, "scheduled")};
  const Log twice{task(1, "scheduled"), degree(2), degree(3), task(4, "scheduled"),
                  task(5, "scheduled")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
  EXPECT_THAT(broken_protocol(twice),
              ElementsAre(HasSubstr("a task goes from 'scheduled' to 'scheduled'")));
}

TEST(JournalLaws, WhatIsOverIsNotTakenOver) {
  const Log log{task(1, "scheduled"), task(1, "started"), task(2, "ended"), degree(3),
                task(4, "running", "ground")};

  EXPECT_THAT(broken_protocol(log), ElementsAre(HasSubstr("a task goes from '' to 'running'")));
}

// Found by random missions (--long-deaths): back after minutes, its decision node gave up what the
// vehicle had begun meanwhile.
TEST(JournalLaws, WhatTheVehicleHasAnsweredIsNotGivenUpForWantOfAnAnswer) {
  const auto given_up = [](const char* answer, double when, const char* node = "marvin") {
    Record aborted = record_of(at(200), node,
                               lines::Task{.uav = "marvin",
                                           .task = 1,
                                           .state = "aborted",
                                           .reason = {"no answer within the time-out"}});
    return broken_protocol(
        {task(1, "scheduled", node), task(1, "started", node),
         record_of(at(when), "sim", lines::Functional{.uav = "marvin", .task = 1, .state = answer}),
         aborted});
  };

  EXPECT_THAT(given_up("running", 90),
              ElementsAre(HasSubstr("for want of an answer that its UAV was sent")));
  EXPECT_THAT(given_up("ended", 90), ElementsAre(HasSubstr("for want of an answer")));
  EXPECT_THAT(given_up("started", 2), IsEmpty()) << "it waited, and said nothing since";
  EXPECT_THAT(given_up("running", 199.8), IsEmpty()) << "it is on its way";
  EXPECT_THAT(given_up("running", 90, "ground"), IsEmpty()) << "a link may be down";
}

TEST(JournalLaws, AnOrdinaryLifeBreaksNone) {
  const Log log{
      task(1, "scheduled"), task(1, "started"),    task(2, "running"),         task(3, "aborting"),
      task(4, "aborted"),   command(5, "issued"),  command(6, "refused"),      sync(7, "sent"),
      sync(8, "received"),  message(9, 1, "sent"), message(9.1, 1, "received")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
}

// Found by a decision node that told its plans to the functional simulator.
TEST(JournalLaws, NobodySpeaksToWhereNoChannelLeads) {
  EXPECT_THAT(broken_protocol({unsent(1, "no channel to there for this slot")}),
              ElementsAre(HasSubstr("a node speaks to where no channel leads")));
}

TEST(JournalLaws, AMessageMayComePastARelayThatWasToldOf) {
  const Log log{message(1, 1, "sent"), link(2, false), route(3), message(9, 1, "received")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
}

// Found by missions at 9,600 bit/s: a message waited twelve seconds at a relay for its turn.
TEST(JournalLaws, WhatWaitsAtARelayMayComeAfterItsSenderWasCutOff) {
  const Log log{link(1, false), route(2), message(3, 1, "sent"),
                link_of(4, "ground", "heliv", false), message(16, 1, "received")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
}

TEST(JournalLaws, AMessageDoesNotComePastARelayThatHasNoLinkOrThatNobodyTold) {
  const Log untold{message(1, 1, "sent"), link(2, false), message(9, 1, "received")};
  for (const auto& [from, to] : {std::pair("ground", "heliv"), std::pair("heliv", "marvin")}) {
    const Log cut{link(1, false), route(2), link_of(3, from, to, false), message(7, 1, "sent"),
                  message(9, 1, "received")};
    EXPECT_THAT(broken_protocol(cut), ElementsAre(HasSubstr("over a link that is down")));
  }
  EXPECT_THAT(broken_protocol(untold), ElementsAre(HasSubstr("over a link that is down")));
}

// Found by random missions over DDS (--anything --deaths 9005): two talked before the simulator's
// first word, which is of all links that it names none of, had come to them.
TEST(JournalLaws, BeforeTheFirstWordThatAllOtherLinksAreDownAMessageMayCome) {
  const auto log = [](double received) {
    return Log{link_of(0, "*", "*", false), message(0, 1, "sent"),
               message(received, 1, "received")};
  };
  EXPECT_THAT(broken_protocol(log(0)), IsEmpty());
  EXPECT_THAT(broken_protocol(log(9)), ElementsAre(HasSubstr("over a link that is down")));
}

struct Breach {
  std::string name;
  Log log;
  std::string why;
};
class BrokenLaw : public ::testing::TestWithParam<Breach> {};

TEST_P(BrokenLaw, IsSeen) {
  EXPECT_THAT(broken_protocol(GetParam().log), ElementsAre(HasSubstr(GetParam().why)));
}

INSTANTIATE_TEST_SUITE_P(
    JournalLaws, BrokenLaw,
    ::testing::Values(
        Breach{"two_terminal_states",
               {task(1, "scheduled"), task(1, "started"), task(2, "ended"), task(3, "aborted")},
               "from 'ended' to 'aborted'"},
        Breach{"ended_though_interrupted",
               {task(1, "scheduled"), task(1, "started"), task(2, "aborting"), task(3, "ended")},
               "from 'aborting' to 'ended'"},
        Breach{"running_from_nothing", {task(1, "running")}, "from '' to 'running'"},
        Breach{"time_goes_back", {task(2, "scheduled"), task(1, "started")}, "time goes back"},
        Breach{"settled_twice",
               {command(1, "issued"), command(2, "refused"), command(3, "expired")},
               "settled twice"},
        Breach{"delivered_twice",
               {command(1, "issued"), command(2, "delivered"), command(3, "delivered")},
               "delivered twice"},
        Breach{"delivered_after_its_end",
               {command(1, "issued"), command(2, "expired"), command(3, "delivered")},
               "after its end"},
        Breach{"delivered_before_issue", {command(2, "delivered")}, "before its issue"},
        Breach{"acknowledged_undelivered",
               {command(1, "issued"), command(2, "acknowledged")},
               "was not delivered"},
        Breach{"delivered_and_left",
               {command(1, "issued"), command(2, "delivered"), link(100, true)},
               "never settled"},
        Breach{"settled_before_issue", {command(2, "acknowledged")}, "before its issue"},
        Breach{"settled_late", {command(1, "issued"), command(80, "expired")}, "too late"},
        Breach{"never_settled", {command(1, "issued"), link(100, true)}, "never settled"},
        Breach{"sync_from_nowhere", {sync(1, "received")}, "nobody sent"},
        Breach{"message_from_nowhere", {message(1, 3, "received")}, "nobody sent"},
        Breach{"message_twice",
               {message(1, 1, "sent"), message(2, 1, "received"), message(3, 1, "received")},
               "twice or late"},
        Breach{"messages_out_of_order",
               {message(1, 1, "sent"), message(1, 2, "sent"), message(2, 2, "received"),
                message(3, 1, "received")},
               "twice or late"},
        Breach{"malformed", {unsent(1, "malformed")}, "does not take"},
        Breach{"too_long", {unsent(1, "too long")}, "does not take"},
        Breach{"message_over_a_cut",
               {message(1, 1, "sent"), link(2, false), message(4, 1, "received")},
               "a link that is down"}),
    [](const auto& one) { return one.param.name; });

TEST(JournalLaws, ALinkIsNotCutBeforeTheSimulatorIsThereToCutIt) {
  const auto with_message_at = [](double at) {
    return Log{message(1, 1, "sent"),     fault(2, "kill", "sim"),   link(3, false),
               message(5, 1, "received"), fault(6, "resume", "sim"), message(7, 2, "sent"),
               message(at, 2, "received")};
  };

  EXPECT_THAT(broken_protocol(with_message_at(7)), ElementsAre(HasSubstr("a link that is down")));
  Log before = with_message_at(7);
  before.resize(5);
  EXPECT_THAT(broken_protocol(before), IsEmpty());
}

TEST(JournalLaws, ARestartedNodeMayUseItsNumbersAgain) {
  const Log messages{message(1, 1, "sent"),      message(2, 1, "received"),
                     fault(3, "kill", "ground"), fault(4, "restart", "ground"),
                     message(4, 1, "sent"),      message(5, 1, "received")};
  const Log tasks{task(1, "scheduled"), fault(3, "kill", "marvin"), fault(4, "restart", "marvin"),
                  task(4, "scheduled")};

  EXPECT_THAT(broken_protocol(messages), IsEmpty());
  EXPECT_THAT(broken_protocol(tasks), IsEmpty());
}

TEST(JournalLaws, WhatWasSentToANodeMayReachItsNextLife) {
  const Log log{message(1, 1, "sent"), message(2, 1, "received"), fault(3, "kill", "marvin"),
                fault(4, "restart", "marvin"), message(5, 1, "received")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
}

TEST(JournalLaws, WhoIsKilledTakesTheLinesOfItsLastWordsWithItOverDds) {
  const auto breaches = [](const char* killed, double heard, std::optional<Duration> late) {
    const Log log{fault(10, "kill", killed), message(heard, 1, "received")};
    return broken_protocol(log, Duration::seconds(66), late);
  };
  const Duration second = Duration::seconds(1);

  EXPECT_THAT(breaches("ground", 10.9, second), IsEmpty());
  EXPECT_THAT(breaches("ground", 11.1, second), ElementsAre(HasSubstr("nobody sent")));
  EXPECT_THAT(breaches("marvin", 10.9, second), ElementsAre(HasSubstr("nobody sent")));
  EXPECT_THAT(breaches("ground", 10, Duration()), ElementsAre(HasSubstr("nobody sent")))
      << "in virtual time";
}

TEST(JournalLaws, TheRestartOfAnotherNodeForgetsNothing) {
  const Log log{task(1, "scheduled"), task(1, "started"), task(2, "ended"),
                fault(3, "kill", "heliv"), task(4, "scheduled")};

  EXPECT_THAT(broken_protocol(log), ElementsAre(HasSubstr("from 'ended'")));
}

TEST(JournalLaws, AnMleOnBoardAndOneAtTheGroundEachHaveTheirOwnTasks) {
  const Log log{task(1, "scheduled", "marvin"), task(2, "scheduled", "ground")};

  EXPECT_THAT(broken_protocol(log), IsEmpty());
}

TEST(JournalLaws, ACommandMayBeOpenWhenTheRunEndsSoonAfterItsIssue) {
  EXPECT_THAT(broken_protocol({command(50, "issued"), link(100, true)}), IsEmpty());
}

TEST(JournalLaws, ACommandMayBeOpenAsLongAsTheScenarioLetsItLive) {
  scenario::Scenario scenario;
  scenario.ground.script.command_lifetime = Duration::seconds(300);
  const Log log{command(5, "issued"), command(306, "expired")};

  EXPECT_THAT(broken_protocol(log, command_limit(scenario)), IsEmpty());
  EXPECT_THAT(broken_protocol(log), ElementsAre(HasSubstr("a command is settled too late")));
}

// Killed in the turn in which it issued it, and back after its limit: nobody else could settle it.
TEST(JournalLaws, WhileTheGroundStationIsDeadNoCommandGrowsOld) {
  const Record back = record_of(at(75), "ground", lines::Resumed{.from = 2});
  const Log settled_at_once{command(1, "issued"), fault(2, "kill", "ground"),
                            fault(70, "resume", "ground"), back, command(75, "expired")};
  const Log first_turn_tells_of_it_before{command(1, "issued"), fault(2, "kill", "ground"),
                                          command(75, "expired"), back};
  const Log settled_in_time{command(1, "issued"), fault(2, "kill", "ground"), back,
                            command(139, "expired")};
  EXPECT_THAT(broken_protocol(settled_at_once), IsEmpty());
  EXPECT_THAT(broken_protocol(first_turn_tells_of_it_before), IsEmpty());
  EXPECT_THAT(broken_protocol(settled_in_time), IsEmpty());
}

TEST(JournalLaws, ACommandGrowsOldWhileAnotherIsDeadAndOnceTheGroundStationIsBack) {
  const auto back = [](double seconds, const char* node) {
    return record_of(at(seconds), node, lines::Resumed{.from = 2});
  };
  const Log another{command(1, "issued"), fault(2, "kill", "marvin"), back(75, "marvin"),
                    command(76, "expired")};
  const Log long_back{command(1, "issued"), fault(2, "kill", "ground"), back(75, "ground"),
                      command(145, "expired")};
  const Log issued_since{fault(2, "kill", "ground"), back(75, "ground"), command(76, "issued"),
                         command(145, "expired")};
  for (const Log& late : {another, long_back, issued_since})
    EXPECT_THAT(broken_protocol(late), ElementsAre(HasSubstr("a command is settled too late")));
}

TEST(JournalLaws, ALineThatLacksSomethingIsTold) {
  const Log log{Record(at(1), "marvin", "task").with("uav", "marvin").with("state", "started"),
                Record(at(2), "marvin", "of-another-kind")};

  EXPECT_THAT(broken_protocol(log), ElementsAre(HasSubstr("a line lacks what")));
}

}  // namespace
}  // namespace skein::laws
