// SPDX-License-Identifier: Apache-2.0
// Plan files as people and programs may write them: odd terms, and every way to be malformed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/htn_tools/given_plan.hpp"

namespace skein::htn {
namespace {

using testing::HasSubstr;

struct Read {
  TermStore store;
  Diagnostics errors;
  std::vector<GivenPlan> plans;

  explicit Read(const std::string& text) { plans = read_plans("plan", text, store, errors); }
  std::string step(std::size_t at) const { return store.to_text(plans.at(0).steps.at(at).action); }
  std::string error() const { return errors.empty() ? "" : to_text(errors.all().front()); }
};

std::string json_step(const std::string& arguments) {
  Read read(R"({"plans":[{"steps":[["!a",)" + arguments + R"(]]}]})");
  EXPECT_TRUE(read.errors.empty()) << arguments << '\n' << to_text(read.errors);
  return read.plans.empty() ? "no plan" : read.step(0);
}

// Terms in JSON

TEST(GivenPlanJson, TermsAreSymbolsNumbersTextsAndLists) {
  EXPECT_EQ(json_step(R"("Truck-1")"), "(!a truck-1)");
  EXPECT_EQ(json_step(R"("nil",null,[])"), "(!a nil nil nil)");
  EXPECT_EQ(json_step("true,false"), "(!a t nil)");
  EXPECT_EQ(json_step("-5,0.25"), "(!a -5 0.25)");
  EXPECT_EQ(json_step("1e10"), "(!a 1.0e10)");
  EXPECT_EQ(json_step(R"("2/4","-1/3","4/2")"), "(!a 1/2 -1/3 2)");
  EXPECT_EQ(json_step(R"([["x"],[]],["y"])"), "(!a ((x) nil) (y))");
}

TEST(GivenPlanJson, NumbersInStringsAreNumbers) {
  EXPECT_EQ(json_step(R"("5")"), "(!a 5)");
  EXPECT_EQ(json_step(R"("0.1")"), "(!a 0.1)");
  EXPECT_EQ(json_step(R"("1/0")"), "(!a 1/0)") << "no number, so a name";
}

TEST(GivenPlanJson, FloatsAreDoubleHoweverTheyAreWritten) {
  Read read(R"({"plans":[{"steps":[["!a",0.1,"0.1","0.1d0"]]}]})");

  Term rest = read.store.cdr(read.plans.at(0).steps.at(0).action);
  for (; rest.is(TermKind::kPair); rest = read.store.cdr(rest)) {
    EXPECT_EQ(read.store.value(read.store.car(rest)), real(0.1));
  }
}

TEST(GivenPlanJson, IntegersBeyondSixtyFourBitsDoNotWrapAround) {
  EXPECT_EQ(json_step("9223372036854775807"), "(!a 9223372036854775807)");
  EXPECT_EQ(json_step("-9223372036854775808"), "(!a -9223372036854775808)");
  EXPECT_EQ(json_step("9223372036854775808"), "(!a 9.223372036854776e18)");
  EXPECT_EQ(json_step("18446744073709551615"), "(!a 1.8446744073709552e19)");
}

TEST(GivenPlanJson, TextsKeepTheirQuotesInside) {
  EXPECT_EQ(json_step(R"("\"two words\"")"), R"((!a "two words"))");
  EXPECT_EQ(json_step(R"("\"\"")"), R"((!a ""))");
  EXPECT_EQ(json_step(R"("\"a\"b\"")"), R"((!a "a\"b"))");
  EXPECT_EQ(json_step(R"("\"Case\"")"), R"((!a "Case"))");
}

TEST(GivenPlanJson, ADotBeforeTheLastItemMakesADottedList) {
  EXPECT_EQ(json_step(R"(["x",".","y"])"), "(!a (x . y))");
  EXPECT_EQ(json_step(R"(["x","y",".",3])"), "(!a (x y . 3))");
  EXPECT_EQ(json_step(R"(["x",".",["y"]])"), "(!a (x y))");
  EXPECT_EQ(json_step(R"(["x",".",null])"), "(!a (x))");
  EXPECT_EQ(json_step(R"(["x","\".\"","y"])"), R"((!a (x "." y)))");
}

TEST(GivenPlanJson, VariablesOfOneStepAreToldApart) {
  Read read(R"({"plans":[{"steps":[["!a","?x","?y","?x"]]}]})");

  const TermStore& store = read.store;
  const Term first = store.cdr(read.plans.at(0).steps.at(0).action);
  const Term second = store.cdr(first);
  const Term third = store.cdr(second);
  EXPECT_EQ(store.car(first).kind(), TermKind::kLocal);
  EXPECT_EQ(store.car(first), store.car(third));
  EXPECT_NE(store.car(first), store.car(second));
}

// Objects

TEST(GivenPlanJson, CostsMayBeMissingShortOrNoNumbers) {
  Read read(R"({"plans":[{"steps":[["!a"],["!b"],["!c"]],"costs":[1,"x"]}]})");

  ASSERT_EQ(read.plans.at(0).steps.size(), 3U);
  EXPECT_EQ(read.plans[0].steps[0].cost, integer(1));
  EXPECT_FALSE(read.plans[0].steps[1].cost);
  EXPECT_FALSE(read.plans[0].steps[2].cost);
  EXPECT_FALSE(read.plans[0].cost);
}

TEST(GivenPlanJson, CostsMayBeRatios) {
  Read read(R"({"plans":[{"steps":[["!a"]],"costs":["1/3"],"cost":"1/3"}]})");

  EXPECT_EQ(read.plans.at(0).steps.at(0).cost, divide(integer(1), integer(3)).value());
  EXPECT_EQ(read.plans[0].cost, divide(integer(1), integer(3)).value());
}

TEST(GivenPlanJson, SaysWhetherInternalStepsWereLeftOut) {
  EXPECT_TRUE(Read(R"({"internal":false,"plans":[{"steps":[]}]})").plans.at(0).without_internal);
  EXPECT_TRUE(Read(R"({"plans":[{"internal":false,"steps":[]}]})").plans.at(0).without_internal);
  EXPECT_FALSE(Read(R"({"plans":[{"internal":true,"steps":[]}]})").plans.at(0).without_internal);
  EXPECT_FALSE(Read(R"({"plans":[{"steps":[]}]})").plans.at(0).without_internal);
}

TEST(GivenPlanJson, NodesHaveWhatTheirKindNeeds) {
  Read read(R"({"plans":[{"steps":[["!a"]],"tree":[{"kind":"unordered","children":[1,2]},)"
            R"({"kind":"task","task":["t",["x"]],"method":"Some-Way"},)"
            R"({"kind":"step","task":["!a"],"step":0}]}]})");

  const std::vector<GivenNode>& tree = read.plans.at(0).tree;
  ASSERT_EQ(tree.size(), 3U);
  EXPECT_EQ(tree[0].kind, TreeNodeKind::kUnordered);
  EXPECT_EQ(tree[0].children, (std::vector<TreeIndex>{1, 2}));
  EXPECT_EQ(tree[1].kind, TreeNodeKind::kTask);
  EXPECT_EQ(read.store.to_text(tree[1].task), "(t (x))");
  EXPECT_EQ(tree[1].method, "Some-Way");
  EXPECT_EQ(tree[1].step, kNoStep);
  EXPECT_TRUE(tree[1].children.empty());
  EXPECT_EQ(tree[2].step, 0U);
}

TEST(GivenPlanJson, IndicesThatAreNoneNameNothing) {
  Read read(R"({"plans":[{"steps":[["!a"]],"tree":[{"kind":"ordered","children":)"
            R"([-1,"x",1.5,99999999999]},{"kind":"step","task":["!a"],"step":-2}]}]})");

  ASSERT_TRUE(read.errors.empty()) << to_text(read.errors);
  const std::vector<GivenNode>& tree = read.plans.at(0).tree;
  EXPECT_EQ(tree[0].children, std::vector<TreeIndex>(4, kNoParent));
  EXPECT_EQ(tree[1].step, kNoStep);
}

// Malformed files

TEST(GivenPlanErrors, NameTheLineAndWhatWasExpected) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{", "plan:1: not a JSON object; expected one object a line"},
      {"\n{\"a\":1}", "plan:2: no plans; expected \"plans\": […]"},
      {"{\"plans\":{}}", "plan:1: no plans; expected \"plans\": […]"},
      {"{\"plans\":[]}\n[]", "plan:2: not a JSON object; expected one object a line"},
      {"{\"plans\":[{\"steps\":[[\"!a\"],\"!b\"]}]}",
       "plan:1: step 2 is no list; expected [\"!name\", argument…]"},
      {"{\"plans\":[{\"steps\":[[]]}]}",
       "plan:1: step 1 is no list; expected [\"!name\", argument…]"},
      {"{\"plans\":[{\"steps\":[[\"!a\",{}]]}]}",
       "plan:1: step 1 is no list; expected [\"!name\", argument…]"},
      {"{\"plans\":[{\"steps\":[],\"tree\":[{\"kind\":\"ordered\"},{}]}]}",
       "plan:1: tree node 1 is not understood; expected \"kind\": task, ordered, unordered or "
       "step"},
      {"{\"plans\":[{\"steps\":[],\"tree\":[{\"kind\":\"task\",\"task\":{}}]}]}",
       "plan:1: tree node 0 is not understood; expected \"kind\": task, ordered, unordered or "
       "step"},
      {"{\"plans\":[{\"steps\":[],\"tree\":[7]}]}",
       "plan:1: tree node 0 is not understood; expected \"kind\": task, ordered, unordered or "
       "step"},
      {"(!a)\n!b", "plan:2: not a step; expected (!name argument…) cost"},
      {"3 (!a)", "plan:1: not a step; expected (!name argument…) cost"},
      {"(!a) 1 2", "plan:1: not a step; expected (!name argument…) cost"},
      {"(!a)\n()", "plan:2: not a step; expected (!name argument…) cost"},
      {"(!a) \"text\"", "plan:1: not a step; expected (!name argument…) cost"}};

  for (const auto& [text, error] : cases) EXPECT_EQ(Read(text).error(), error) << text;
}

TEST(GivenPlanErrors, OfTheTextFormAreThoseOfTheReader) {
  EXPECT_THAT(Read("(!a (b)").error(), HasSubstr("plan:1:1:"));
  EXPECT_THAT(Read("(!a))").error(), HasSubstr("plan:1:5:"));
}

TEST(GivenPlanErrors, LeaveTheOtherPlansOfTheFile) {
  Read read(
      "{\"plans\":[{\"steps\":[[\"!a\"]]},{\"steps\":[5]},{\"steps\":[[\"!c\"]]}]}\n"
      "{oops\n"
      "{\"plans\":[{\"steps\":[[\"!d\"]]}]}\n");

  ASSERT_EQ(read.plans.size(), 3U);
  EXPECT_EQ(read.store.to_text(read.plans[1].steps.at(0).action), "(!c)");
  EXPECT_EQ(read.store.to_text(read.plans[2].steps.at(0).action), "(!d)");
  EXPECT_EQ(read.errors.size(), 2U);
}

TEST(GivenPlanErrors, EntriesOfOtherKindsAreLeftOut) {
  Read read(R"({"plans":[5,null,"x",[],{"steps":[["!a"]]}]})");

  ASSERT_EQ(read.plans.size(), 1U);
  EXPECT_EQ(read.step(0), "(!a)");
}

// Text form

TEST(GivenPlanText, MayBeEmptyOrCommentsOnly) {
  for (const char* text : {"", "  \n", "; nothing to do\n", "#| nothing |#"}) {
    Read read(text);
    EXPECT_TRUE(read.errors.empty()) << text;
    ASSERT_EQ(read.plans.size(), 1U) << text;
    EXPECT_TRUE(read.plans[0].steps.empty()) << text;
  }
}

TEST(GivenPlanText, StepsMayStandOnOneLineOrOverSeveral) {
  Read read("(!a) 1.5 (!b\n  c)\n2/3 (!c . d)");

  ASSERT_TRUE(read.errors.empty()) << to_text(read.errors);
  ASSERT_EQ(read.plans.at(0).steps.size(), 3U);
  EXPECT_EQ(read.plans[0].steps[0].line, 1);
  EXPECT_EQ(read.plans[0].steps[1].line, 1);
  EXPECT_EQ(read.plans[0].steps[1].cost, divide(integer(2), integer(3)).value());
  EXPECT_EQ(read.plans[0].steps[2].line, 3);
  EXPECT_EQ(read.step(2), "(!c . d)");
}

TEST(GivenPlanText, BytesThatAreNoTextAreAnErrorOrANameButNoCrash) {
  for (const char* text : {"(!a \xFF)", "{\"plans\":[{\"steps\":[[\"\xC3\"]]}]}", "\x01", "(\\"}) {
    const Read read(text);
    EXPECT_LE(read.plans.size(), 1U) << text;
    EXPECT_TRUE(!read.errors.empty() || !read.plans.empty()) << text;
  }
}

}  // namespace
}  // namespace skein::htn
