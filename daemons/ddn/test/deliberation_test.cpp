// SPDX-License-Identifier: Apache-2.0
// Degree 4: missions, jobs, plans, and what becomes of them when the degree changes.
#include "testing/deliberating.hpp"

namespace skein::ddn {
namespace {

using testing::a_task;
using testing::Bench;
using testing::cancellation;
using testing::command;
using ::testing::Contains;
using testing::degree;
using testing::deliberating;
using ::testing::ElementsAre;
using testing::finish;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kGoal;
using testing::mission_to;
using ::testing::Not;
using testing::plan;
using ::testing::SizeIs;
using testing::start;
using testing::state_of_goal;
using testing::status;
using testing::take_off;
using testing::telemetry;
using testing::three_tasks;
using wire::TaskState;
using Words = std::vector<std::string>;

// ---- missions ----

TEST(Deliberation, AMissionIsAcceptedAndPlannedAsAJob) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});

  EXPECT_THAT(bench.from_ground(mission_to(1, 7)), ElementsAre("ground: reply 1 accepted"));

  EXPECT_EQ(bench.sent<wire::RequestReply>()->kind, wire::RequestKind::kMission);
  EXPECT_EQ(bench.sent<wire::RequestReply>()->id, 7U);
  EXPECT_THAT(bench.jobs(), SizeIs(1));
  EXPECT_EQ(state_of_goal(bench), "received");
}

TEST(Deliberation, AMissionThatMakesNoSenseIsRefusedWithAllReasons) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  wire::MissionRequest request = mission_to(1, 7, "flie", "P1");
  request.tasks.push_back(request.tasks[0]);
  request.tasks[1].id = 702;
  request.tasks[1].name = "fly";
  request.tasks[1].arguments[0].text = "P9";

  const Words words = bench.from_ground(request);

  ASSERT_THAT(words, SizeIs(1));
  EXPECT_THAT(words[0], HasSubstr("refused"));
  EXPECT_THAT(words[0], HasSubstr("flie"));
  EXPECT_THAT(words[0], HasSubstr("; "));
  EXPECT_THAT(words[0], HasSubstr("P9"));
  EXPECT_THAT(bench.jobs(), IsEmpty());
}

TEST(Deliberation, RubbishIsRefusedWithTheField) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  wire::MissionRequest request = mission_to(1, 7);
  request.tasks[0].arguments[0].name = "colour";

  EXPECT_THAT(bench.from_ground(request),
              ElementsAre("ground: reply 1 refused: tasks[0].arguments[0]: 'colour' is not a kind "
                          "of argument"));
}

TEST(Deliberation, AMissionIsTakenOnce) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));

  EXPECT_THAT(bench.from_ground(mission_to(1, 7)), ElementsAre("ground: reply 1 accepted"));
  EXPECT_THAT(bench.jobs(), IsEmpty());
}

TEST(Deliberation, MissionsAreTakenFromTheGroundOnly) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});

  EXPECT_THAT(bench.from_heliv(mission_to(1, 7)), IsEmpty());
  EXPECT_THAT(bench.from_heliv(wire::WorldChange{}), IsEmpty());
  EXPECT_THAT(bench.jobs(), IsEmpty());
}

class BelowDegree4 : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Deliberation, BelowDegree4, ::testing::Values(1, 2, 3));

TEST_P(BelowDegree4, MissionsAreRefused) {
  Bench bench(deliberating(GetParam()));
  bench.give(node::Started{1, true});

  EXPECT_THAT(bench.from_ground(mission_to(1, 7)),
              ElementsAre("ground: reply 1 refused: degree " + std::to_string(GetParam()) +
                          ": missions are planned at degree 4"));
}

TEST_P(BelowDegree4, WithoutAPlanningDomainTheyAreRefusedForWantOfIt) {
  Bench bench(Bench::at_degree(GetParam()));

  EXPECT_THAT(bench.from_ground(mission_to(1, 7)),
              ElementsAre(HasSubstr("refused: no planning domain")));
  EXPECT_THAT(bench.from_ground(cancellation(2)),
              ElementsAre(HasSubstr("refused: no planning domain")));
}

TEST_P(BelowDegree4, AMissionIsTakenOnceTheDegreeIs4) {
  Bench bench(deliberating(GetParam()));
  bench.give(node::Started{1, true});
  bench.from_ground(degree(1, 4));

  EXPECT_THAT(bench.from_ground(mission_to(2, 7)), ElementsAre("ground: reply 2 accepted"));
  EXPECT_THAT(bench.jobs(), SizeIs(1));
}

// ---- while a job runs ----

class WhileAJobRuns : public ::testing::Test {
 protected:
  WhileAJobRuns() {
    bench.give(node::Started{1, true});
    bench.from_ground(start(1, a_task(5, "takeshot")));
    bench.from_ground(mission_to(2, 7));
    job = bench.jobs().at(0).id;
    bench.set_time(5);
  }
  Bench bench{deliberating(4)};
  std::uint64_t job = 0;
};

TEST_F(WhileAJobRuns, AnAbortIsAnsweredAndDoneAtOnce) {
  EXPECT_THAT(bench.from_ground(command(3, executive::Abort{executive::TaskId(5)})),
              ElementsAre("ground: reply 3 accepted", "ground: 5 aborting", "sim: interrupt 5"));
}

TEST_F(WhileAJobRuns, AnotherMissionIsAnsweredAtOnceAndPlannedAfterIt) {
  EXPECT_THAT(bench.from_ground(mission_to(3, 8)), ElementsAre("ground: reply 3 accepted"));
  EXPECT_THAT(bench.jobs(), IsEmpty());

  finish(bench, job, three_tasks(100, kGoal));

  EXPECT_THAT(bench.jobs(), SizeIs(1));
}

TEST_F(WhileAJobRuns, TheDegreeChangesAtOnceAndTheResultComesToNothing) {
  const Words words = bench.from_ground(degree(3, 2));

  EXPECT_THAT(words, Contains("ground: reply 3 accepted"));
  EXPECT_THAT(words, Contains("ground: hand-over 2: 5 started"));
  EXPECT_THAT(finish(bench, job, three_tasks(100, kGoal)), IsEmpty());
  EXPECT_THAT(bench.records("planned"), IsEmpty());
}

TEST_F(WhileAJobRuns, ACommandThatComesAgainGetsTheSameAnswer) {
  EXPECT_THAT(bench.from_ground(mission_to(2, 7)), ElementsAre("ground: reply 2 accepted"));
}

TEST_F(WhileAJobRuns, AResultOfNobodysJobIsHarmless) {
  EXPECT_THAT(bench.give(node::JobDone{job + 50, std::any(three_tasks(100, kGoal))}), IsEmpty());
  EXPECT_THAT(bench.give(node::JobDone{job, std::any(std::string("rubbish"))}), IsEmpty());
}

// The work owns what it needs: it runs in any thread, and after the node is gone.
TEST(Deliberation, AJobGivesTheResultThatTheNodeTakes) {
  std::vector<node::StartJob> jobs;
  {
    Bench bench(deliberating(4));
    bench.give(node::Started{1, true});
    bench.from_ground(mission_to(1, 7));
    jobs = bench.jobs();
  }

  const std::any result = jobs.at(0).work({});

  EXPECT_NE(std::any_cast<supervisor::DeliberationResult>(&result), nullptr);
}

// ---- a plan ----

TEST(Deliberation, APlanIsToldAndBegun) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_sim(telemetry(false));
  bench.from_ground(mission_to(1, 7));

  const Words words = finish(bench, bench.jobs().at(0).id, three_tasks(100, kGoal));

  EXPECT_THAT(words, Contains("ground: mission 7 planned"));
  EXPECT_THAT(words, Contains("sim: dispatch 100 takeoff"));
  ASSERT_NE(bench.sent<wire::MissionPlan>(), nullptr);
  EXPECT_NE(bench.sent<wire::Decision>(), nullptr);
}

TEST(Deliberation, APlanIsLoggedWithItsTasks) {
  Bench bench(deliberating(4));
  plan(bench);

  ASSERT_FALSE(bench.records("plan").empty());
  EXPECT_EQ(bench.records("plan")[0].number("tasks"), 3);
  EXPECT_EQ(bench.records("plan")[0].number("goals"), 1);
  const std::vector<journal::Record> tasks = bench.records("planned");
  ASSERT_GE(tasks.size(), 3U);
  EXPECT_EQ(tasks[1].text("type"), "goto");
  EXPECT_EQ(tasks[1].number("goal"), kGoal);
  EXPECT_EQ(tasks[1].text("after"), "ended 100");
  EXPECT_EQ(tasks[1].text("methods"), "fly there");
  EXPECT_EQ(tasks[1].numbers("way"), (std::vector<double>{0, 0, 40, 100, 0, 40}));
  ASSERT_THAT(bench.records("answer"), SizeIs(1));
  EXPECT_TRUE(bench.records("answer")[0].truth("planned"));
  EXPECT_FALSE(bench.records("decision").empty());
}

TEST(Deliberation, ATaskIsLoggedAgainOnlyWhenSomethingOfItChanged) {
  Bench bench(deliberating(4));
  plan(bench);
  const auto without_revision = [](const journal::Record& line) {
    std::string text = journal::to_json(line);
    const std::size_t from = text.find("\"revision\"");
    return text.erase(from, text.find(',', from) - from);
  };

  std::vector<std::string> last(200);
  for (const journal::Record& line : bench.records("planned")) {
    std::string& before = last.at(static_cast<std::size_t>(line.number("task")));
    EXPECT_NE(without_revision(line), before);
    before = without_revision(line);
  }
}

TEST(Deliberation, AMissionWithoutAPlanIsAnsweredWithTheReasons) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));
  supervisor::InsertionOutcome none;
  none.reasons = {"no way to P1", "no energy"};

  EXPECT_THAT(finish(bench, bench.jobs().at(0).id, none),
              Contains("ground: mission 7 not planned"));

  EXPECT_EQ(bench.sent<wire::MissionOutcome>()->reasons, none.reasons);
  EXPECT_EQ(bench.records("answer")[0].text("why"), "no way to P1; no energy");
}

TEST(Deliberation, AGoalIsAchievedWhenItsTasksHaveEnded) {
  Bench bench(deliberating(4));
  plan(bench);
  take_off(bench);
  bench.from_sim(status(101, TaskState::kEnded));
  bench.from_sim(status(102, TaskState::kRunning));

  bench.from_sim(status(102, TaskState::kEnded));

  EXPECT_EQ(state_of_goal(bench), "achieved");
}

TEST(Deliberation, ABrokenDeviceIsKnownToTheSupervisor) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  wire::Telemetry broken = telemetry(false);
  broken.failed = {"camera"};
  bench.from_sim(broken);

  EXPECT_THAT(bench.from_ground(mission_to(1, 7, "look")),
              ElementsAre(HasSubstr("reply 1 refused")));
}

TEST(Deliberation, AJointTaskIsRefusedForWantOfInteractionModels) {
  Bench bench(deliberating(4));
  bench.give(node::Started{1, true});
  bench.from_ground(mission_to(1, 7));
  supervisor::InsertionOutcome outcome;
  outcome.plan = mission::ElementaryPlan{};
  outcome.plan->tasks = {testing::planned(100, "joint:lift", kGoal)};
  outcome.order = {{mission::GoalId(kGoal), "fly", {std::string("P1")}, {}}};
  outcome.schedule = supervisor::schedule(outcome.plan->tasks, {}, MissionTime());

  finish(bench, bench.jobs().at(0).id, outcome);

  ASSERT_FALSE(bench.records("task").empty());
  EXPECT_THAT(std::string(bench.records("task").back().text("reason")),
              HasSubstr("no interaction models"));
}

}  // namespace
}  // namespace skein::ddn
