// SPDX-License-Identifier: Apache-2.0
// `skein plan --validate`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testing/command.hpp"

namespace skein::plan_tool {
namespace {

using testing::HasSubstr;
using testing_command::Done;
using testing_command::File;
using testing_command::options_for;
using testing_command::plan;

Done validate(PlanOptions options, const std::string& plans) {
  const File file("plans", plans);
  options.validate = file.path();
  return plan(options);
}

TEST(Validate, AcceptsWhatThePlannerWroteWithTrees) {
  PlanOptions options = options_for("uav.lisp");
  options.json = true;
  options.tree = true;
  const std::string plans = plan(options).out;
  options.json = false;

  const Done done = validate(options, plans);

  EXPECT_EQ(done.code, 0) << done.out << done.err;
  EXPECT_THAT(done.out, HasSubstr("one-uav: valid: 7 steps, cost 59"));
  EXPECT_THAT(done.out, HasSubstr("two-uavs: valid: "));
}

TEST(Validate, AcceptsEveryPlanOfASearchForAll) {
  PlanOptions options = options_for("relief.lisp", "two-crates");
  options.json = true;
  options.tree = true;
  options.search.which = htn::Which::kAll;
  const std::string plans = plan(options).out;
  options.json = false;

  const Done done = validate(options, plans);

  EXPECT_EQ(done.code, 0) << done.out << done.err;
}

TEST(Validate, SaysWhichStepDoesNotApply) {
  const Done done = validate(options_for("counter.lisp", "ten"), "(!tick 0) 1\n(!tick 2) 1\n");

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("ten: step 2 (line 2): "));
}

TEST(Validate, SaysItInJsonToo) {
  PlanOptions options = options_for("counter.lisp", "ten");
  options.json = true;

  const Done done = validate(options, "(!tick 0)\n(!tick 2)\n");

  const auto line = nlohmann::json::parse(done.out);
  EXPECT_EQ(line["problem"], "ten");
  EXPECT_EQ(line["result"], "invalid");
  EXPECT_EQ(line["step"], 1);
  EXPECT_EQ(line["line"], 2);
}

TEST(Validate, AsksForOneProblemWhereThePlanNamesNone) {
  const Done done = validate(options_for("counter.lisp"), "(!tick 0)\n");

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("does not say of which problem it is"));
}

TEST(Validate, RefusesPlansOfProblemsThatWereNotRead) {
  const Done done =
      validate(options_for("counter.lisp"), R"({"problem":"million","plans":[{"steps":[]}]})");

  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, HasSubstr("the plan is of problem 'million'"));
}

TEST(Validate, RefusesFilesWithoutAPlan) {
  const Done none = validate(options_for("counter.lisp"), R"({"problem":"ten","plans":[]})");
  PlanOptions absent = options_for("counter.lisp");
  absent.validate = "/no/such/plan";

  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("there is no plan in it"));
  EXPECT_EQ(plan(absent).code, 2);
  EXPECT_THAT(plan(absent).err, HasSubstr("/no/such/plan: error: there is no such file"));
}

TEST(Validate, CannotSayMuchWithoutInternalSteps) {
  PlanOptions options = options_for("uav.lisp", "one-uav");
  options.json = true;
  options.no_internal = true;
  const std::string plans = plan(options).out;
  options.json = false;

  const Done done = validate(options, plans);

  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("internal"));
}

}  // namespace
}  // namespace skein::plan_tool
