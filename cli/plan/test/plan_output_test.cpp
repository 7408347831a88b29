// SPDX-License-Identifier: Apache-2.0
// What `skein plan` shows of a plan, of a search, and of a failure.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing_command::Done;
using testing_command::File;
using testing_command::options_for;
using testing_command::plan;

std::vector<json> lines_of(const std::string& text) {
  std::vector<json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line));
  return lines;
}

// --- JSON ----------------------------------------------------------------------------------------

TEST(PlanJson, IsOneObjectALineForEachProblem) {
  PlanOptions options = options_for("uav.lisp");
  options.json = true;

  const std::vector<json> lines = lines_of(plan(options).out);

  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0]["problem"], "one-uav");
  EXPECT_EQ(lines[0]["domain"], "uav");
  EXPECT_EQ(lines[0]["result"], "plan");
  EXPECT_EQ(lines[0]["plans"][0]["cost"], 59);
  EXPECT_EQ(lines[0]["plans"][0]["steps"][1].dump(), R"(["!takeoff","karma"])");
  EXPECT_EQ(lines[0]["plans"][0]["costs"][1], 10);
  EXPECT_FALSE(lines[0]["plans"][0].contains("tree"));
  EXPECT_EQ(lines[2]["result"], "no-plan");
  EXPECT_TRUE(lines[2]["plans"].empty());
}

TEST(PlanJson, CountsTimeFromTheClockGiven) {
  PlanOptions options = options_for("counter.lisp", "ten");
  options.json = true;
  double now = 0;
  Surroundings surroundings;
  surroundings.cpu_seconds = [&now] { return now += 0.25; };
  surroundings.memory_mb = [] { return 12.5; };

  const json line = lines_of(plan(options, surroundings).out).at(0);

  EXPECT_EQ(line["reading_seconds"], 0.25);
  EXPECT_GE(line["seconds"], 0.25);
  EXPECT_EQ(line["memory_mb"], 12.5);
}

TEST(PlanJson, HasTheTreeWhenAskedFor) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.json = true;
  options.tree = true;

  const json tree = lines_of(plan(options).out).at(0)["plans"][0]["tree"];

  ASSERT_GT(tree.size(), 7U);
  const auto goes = std::find_if(tree.begin(), tree.end(), [](const json& node) {
    return node["kind"] == "step" && node["task"][0] == "!open-shutter";
  });
  ASSERT_NE(goes, tree.end());
  EXPECT_EQ((*goes)["step"], 3);
  EXPECT_EQ((*goes)["support"][0].dump(), R"({"fact":["at","karma","lake"],"step":2})");
}

// --- tree and graph ------------------------------------------------------------------------------

TEST(PlanTree, ShowsTasksBranchesStepsAndWhatTheyNeeded) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.tree = true;

  const Done done = plan(options);

  EXPECT_THAT(done.out, HasSubstr("(mission (lake))  tours\n"));
  EXPECT_THAT(done.out, HasSubstr("(shoot karma lake)  exposure\n"));
  EXPECT_THAT(done.out, HasSubstr("4 (!open-shutter karma lake)  cost 0\n"));
  EXPECT_THAT(done.out, HasSubstr("← (at karma lake) from 3 !goto\n"));
}

TEST(PlanTree, LeavesInternalStepsOutWhenTold) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.tree = true;
  options.no_internal = true;

  EXPECT_THAT(plan(options).out, Not(HasSubstr("cost 0\n├─")));
  EXPECT_THAT(plan(options).out, HasSubstr("1 (!takeoff karma)"));
}

TEST(PlanGraphs, GoToTheFileWithThePlanStillShown) {
  const File file("plan.dot", "");
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.dot = file.path();

  const Done done = plan(options);

  EXPECT_EQ(done.code, 0);
  EXPECT_THAT(file.content(), HasSubstr("digraph plan {"));
  EXPECT_THAT(file.content(), HasSubstr("label=\"one-uav, cost 59\""));
  EXPECT_THAT(done.out, HasSubstr("one-uav (uav): plan, 7 steps"));
}

TEST(PlanGraphs, GoAloneToStandardOutput) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.dot = "-";

  EXPECT_THAT(plan(options).out, testing::StartsWith("digraph plan {"));
}

TEST(PlanGraphs, ThatCannotBeWrittenAreAnErrorOfTheSystem) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.dot = "/no/such/folder/plan.dot";

  const Done done = plan(options);

  EXPECT_EQ(done.code, 3);
  EXPECT_EQ(done.err, "/no/such/folder/plan.dot: cannot be written\n");
}

// --- trace and failure ---------------------------------------------------------------------------

TEST(PlanTrace, TellsOfTheTasksNamed) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.trace = true;
  options.search.traced_tasks = {"fly"};

  const Done done = plan(options);

  EXPECT_THAT(done.out, HasSubstr("(fly karma)\n"));
  EXPECT_THAT(done.out, HasSubstr("✗ stay-home does not hold: needs (not (job ?u ?_p))\n"));
  EXPECT_THAT(done.out, HasSubstr("✓ tour holds, 1 reduction: ?u = karma"));
  EXPECT_THAT(done.out, HasSubstr("→ tour: (!takeoff karma) (visit karma) (come-back karma)\n"));
  EXPECT_THAT(done.out, Not(HasSubstr(" (visit karma)\n"))) << "not traced itself";
}

TEST(PlanTrace, KeepsOutOfTheJson) {
  PlanOptions options = options_for("counter.lisp", "ten");
  options.trace = true;
  options.json = true;

  const Done done = plan(options);

  EXPECT_EQ(lines_of(done.out).size(), 1U);
  EXPECT_THAT(done.err, HasSubstr("● (!tick 9)"));
}

TEST(PlanWhyNot, TellsTheDeepestPointAndWhatWasMissing) {
  PlanOptions options = options_for("uav.lisp", "too-far");
  options.why_not = true;

  const Done done = plan(options);

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("The search came furthest after "));
  EXPECT_THAT(done.out, HasSubstr("(go karma village)\n"));
  EXPECT_THAT(done.out, HasSubstr("✗ (go karma village), by-a-station: needs (station "));
}

TEST(PlanWhyNot, IsInTheJsonToo) {
  PlanOptions options = options_for("uav.lisp", "too-far");
  options.why_not = true;
  options.json = true;

  const json line = lines_of(plan(options).out).at(0);

  EXPECT_EQ(line["failure"]["open_tasks"].back().dump(), R"(["go","karma","village"])");
}

TEST(PlanText, IsColouredOnATerminalOnly) {
  Surroundings terminal;
  terminal.colour_out = true;

  EXPECT_THAT(plan(options_for("uav.lisp"), terminal).out, HasSubstr("\033[1mone-uav\033[0m"));
  EXPECT_THAT(plan(options_for("uav.lisp")).out, Not(HasSubstr("\033")));
}

TEST(PlanTrace, NamesTasksThatThereAreNot) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.trace = true;
  options.search.traced_tasks = {"fly", "vist"};

  const Done done = plan(options);

  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.err, "--trace: warning: no task is called 'vist'; did you mean 'visit'?\n");
}

TEST(PlanWhyNot, TellsWhereALimitCutASearchWithoutEnd) {
  PlanOptions options;
  options.files = {"-"};
  options.why_not = true;
  options.search.limits.expansions = 500;
  const std::string endless =
      "(defdomain d ((:method (go) () ((turn))) (:method (turn) () ((turn)))))"
      "(defproblem p d () ((go)))";

  const Done done = plan(options, {}, endless);
  options.json = true;
  const Done told = plan(options, {}, endless);

  EXPECT_EQ(done.code, 4);
  EXPECT_THAT(done.out, HasSubstr("p (d): cut: expansions of 500; so far: no plan\n"));
  EXPECT_THAT(done.out, HasSubstr("(turn …) is open 500 times inside itself"));
  EXPECT_EQ(nlohmann::json::parse(told.out)["standing"]["open_tasks"][0],
            nlohmann::json::array({"go"}));
}

TEST(PlanStates, ShowWhatEachStepChanges) {
  PlanOptions options;
  options.files = {"-"};
  options.states = true;
  const std::string text =
      "(defdomain d ((:operator (!go ?a ?b) ((at ?a)) ((at ?a)) ((at ?b)) 1)))"
      "(defproblem p d ((at a)) ((!go a b)))";

  const Done done = plan(options, {}, text);
  options.json = true;
  const Done told = plan(options, {}, text);

  EXPECT_THAT(done.out, HasSubstr("  1  (!go a b)  1\n     - (at a)\n     + (at b)\n"));
  EXPECT_EQ(nlohmann::json::parse(told.out)["plans"][0]["changes"],
            nlohmann::json::parse(R"([{"deleted":[["at","a"]],"added":[["at","b"]]}])"));
}

TEST(PlanBound, IsNamedWhereItLeftNoPlan) {
  PlanOptions options = options_for("counter.lisp", "ten");
  options.search.cost_limit = 3;

  EXPECT_THAT(plan(options).out,
              HasSubstr("ten (counter): there is no plan: none costs 3.0 or less"));
}

TEST(PlanAll, SaysThatRepeatsAreLeftOut) {
  PlanOptions options;
  options.files = {"-"};
  options.search.which = htn::Which::kAll;

  const Done done = plan(options, {},
                         "(defdomain d ((:operator (!a) () () ()) (:operator (!b) () () ())))"
                         "(defproblem p d () ((:unordered (!a) (!a) (!b))))");

  EXPECT_THAT(done.out, HasSubstr("p (d): 3 plans\n"));
  EXPECT_THAT(done.out, HasSubstr("plans that only repeat these by other choices are left out"));
}

}  // namespace
}  // namespace skein::plan_tool
