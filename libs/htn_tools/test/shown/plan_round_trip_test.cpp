// SPDX-License-Identifier: Apache-2.0
// What the writers of plans give, read back; and texts and graphs of plans with odd names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "skein/htn_tools/given_plan.hpp"
#include "skein/htn_tools/plan_graph.hpp"
#include "skein/htn_tools/plan_json.hpp"
#include "skein/htn_tools/plan_text.hpp"
#include "testing/sample_plan.hpp"

namespace skein::htn {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing_plans::PlanBuilder;
using testing_plans::swap_plan;
using testing_plans::term;

class RoundTrip : public ::testing::Test {
 protected:
  TermStore store;

  /// The only step of what is read back.
  Term back(Term argument) {
    Plan plan;
    plan.cost = integer(1);
    const std::vector<Term> action{store.symbol("!do"), argument};
    plan.steps.push_back({store.list(action), integer(1), false});
    const std::vector<GivenPlan> plans = read(plan);
    if (plans.size() != 1 || plans[0].steps.size() != 1) return store.symbol("lost");
    return store.car(store.cdr(plans[0].steps[0].action));
  }
  std::vector<GivenPlan> read(const Plan& plan, const PlanJsonOptions& options = {}) {
    Outcome outcome;
    outcome.verdict = Verdict::kPlan;
    outcome.plans.push_back(plan);
    Diagnostics errors;
    auto plans =
        read_plans("plan", to_json({"p", "d", 0, 0, 0}, outcome, store, options), store, errors);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
    return plans;
  }
};

// Terms

TEST_F(RoundTrip, KeepsListsWhateverTheirShape) {
  for (const char* text :
       {"a", "(a)", "()", "(())", "((a) () (b (c)))", "(a . b)", "((a . b) . c)", "(a b . 5)",
        "((a . 1/2) (b . \"x\"))", "(a . \"b\")", "(((((deep)))))", "(nil t)", "(a (b . nil))"}) {
    const Term given = term(text, store);
    EXPECT_EQ(back(given), given) << text << " became " << store.to_text(back(given));
  }
}

TEST_F(RoundTrip, KeepsTextsWhateverTheyHold) {
  for (const char* text : {"", "a", "Two Words", "\"", "\"quoted\"", "\\", "a\\\"b", "\n\t", "1/2",
                           "5", "nil", ".", "é ✓", "[]", "?x", "'"}) {
    const Term given = store.string(text);
    EXPECT_EQ(back(given), given) << text << " became " << store.to_text(back(given));
  }
}

TEST_F(RoundTrip, KeepsExactNumbers) {
  for (const Number& number :
       {integer(0), integer(-1), integer(std::numeric_limits<std::int64_t>::max()),
        integer(std::numeric_limits<std::int64_t>::min()), *divide(integer(1), integer(3)),
        *divide(integer(-22), integer(7))}) {
    const Term given = store.number(number);
    EXPECT_EQ(back(given), given) << to_text(number);
  }
}

TEST_F(RoundTrip, KeepsDoublesToTheLastBit) {
  for (const double value : {0.1, -0.0, 1.0, 1e-300, 1.7976931348623157e308, 1e15, 1e21,
                             123456789.125, 1.0 / 3.0, std::numeric_limits<double>::denorm_min()}) {
    const Term given = store.number(real(value));
    EXPECT_EQ(back(given), given) << to_text(real(value));
  }
}

TEST_F(RoundTrip, MakesSinglesTheDoublesOfTheirText) {
  EXPECT_EQ(back(store.number(single(0.1F))), store.number(real(0.1)));
  EXPECT_EQ(back(store.number(single(2.0F))), store.number(real(2.0)));
  EXPECT_EQ(back(store.number(single(1e10F))), store.number(real(1e10)));
}

TEST_F(RoundTrip, KeepsSymbolsWithOddLetters) {
  for (const char* name :
       {"a-b", "!x", ":key", "loc_1", "é", "a.b", "+", "-", "1+", "<=>", "a|b"}) {
    const Term given = store.symbol(name);
    EXPECT_EQ(back(given), given) << name;
  }
}

TEST_F(RoundTrip, KeepsTheDotOfAListApartFromATextThatIsADot) {
  const std::vector<Term> items{store.symbol("a"), store.string("."), store.symbol("b")};
  const Term given = store.list(items);

  EXPECT_EQ(back(given), given);
  EXPECT_NE(back(given), term("(a . b)", store));
}

// Plans

TEST_F(RoundTrip, KeepsStepsCostsAndTree) {
  const Plan plan = swap_plan(store);

  const std::vector<GivenPlan> plans = read(plan, {.internal = true, .tree = true});

  ASSERT_EQ(plans.size(), 1U);
  const GivenPlan& given = plans[0];
  EXPECT_EQ(given.problem, "p");
  EXPECT_FALSE(given.without_internal);
  EXPECT_EQ(to_text(given.cost.value()), to_text(plan.cost));
  ASSERT_EQ(given.steps.size(), plan.steps.size());
  for (std::size_t at = 0; at < plan.steps.size(); ++at) {
    EXPECT_EQ(given.steps[at].action, plan.steps[at].action);
    EXPECT_EQ(to_text(given.steps[at].cost.value()), to_text(plan.steps[at].cost));
  }
  ASSERT_EQ(given.tree.size(), plan.tree.size());
  for (std::size_t at = 0; at < plan.tree.size(); ++at) {
    EXPECT_EQ(given.tree[at].kind, plan.tree[at].kind) << at;
    EXPECT_EQ(given.tree[at].children, plan.tree[at].children) << at;
    EXPECT_EQ(given.tree[at].method, plan.tree[at].method) << at;
    EXPECT_EQ(given.tree[at].step, plan.tree[at].step) << at;
    if (plan.tree[at].kind != TreeNodeKind::kTask) continue;
    EXPECT_EQ(given.tree[at].task, plan.tree[at].task) << at;
  }
}

TEST_F(RoundTrip, SaysThatInternalStepsAreMissing) {
  const std::vector<GivenPlan> plans = read(swap_plan(store), {.internal = false, .tree = false});

  ASSERT_EQ(plans.size(), 1U);
  EXPECT_TRUE(plans[0].without_internal);
  EXPECT_EQ(plans[0].steps.size(), 2U);
  EXPECT_TRUE(plans[0].tree.empty());
}

TEST_F(RoundTrip, KeepsRatiosAsCosts) {
  PlanBuilder builder(store);
  builder.step("(!a)", *divide(integer(1), integer(3)))
      .step("(!b)", *divide(integer(1), integer(3)));

  const std::vector<GivenPlan> plans = read(builder.plan());

  ASSERT_EQ(plans.size(), 1U);
  EXPECT_EQ(plans[0].cost, *divide(integer(2), integer(3)));
  EXPECT_EQ(plans[0].steps.at(1).cost, *divide(integer(1), integer(3)));
}

TEST_F(RoundTrip, OfNoPlanIsNone) {
  Outcome outcome;
  outcome.verdict = Verdict::kNoPlan;
  Diagnostics errors;

  const auto plans = read_plans("plan", to_json({}, outcome, store, {}), store, errors);

  EXPECT_TRUE(plans.empty());
  EXPECT_TRUE(errors.empty());
}

TEST_F(RoundTrip, EscapesTheNamesOfProblemDomainAndMethods) {
  PlanBuilder builder(store);
  const TreeIndex root = builder.network(TreeNodeKind::kOrdered);
  builder.task("(t)", "a \"b\" \\ c", root);
  Outcome outcome;
  outcome.plans.push_back(builder.plan());
  outcome.why = "line\nbreak";

  const json object = json::parse(
      to_json({"p \"1\"", "d\\e", 0, 0, 0}, outcome, store, {.internal = true, .tree = true}));

  EXPECT_EQ(object["problem"], "p \"1\"");
  EXPECT_EQ(object["domain"], "d\\e");
  EXPECT_EQ(object["why"], "line\nbreak");
  EXPECT_EQ(object["plans"][0]["tree"][1]["method"], "a \"b\" \\ c");
}

TEST_F(RoundTrip, MarksFactsThatCameFromOutside) {
  Plan plan = swap_plan(store);
  plan.tree[5].support.push_back({term("(not (wind))", store), kOutside});
  std::string out;

  append_json(plan, store, {.internal = true, .tree = true}, out);

  EXPECT_EQ(json::parse(out)["tree"][5]["support"].back().dump(),
            R"({"fact":["not",["wind"]],"step":"outside"})");
  EXPECT_THAT(tree_text(plan, store, {}), HasSubstr("← (not (wind)) from outside\n"));
  EXPECT_THAT(to_dot(plan, store, {}), Not(HasSubstr("wind")));
}

// Text

TEST_F(RoundTrip, OfTheTextFormKeepsStepsWithTheirCosts) {
  PlanBuilder builder(store);
  builder.step("(!say \"a \\\"b\\\"\" (x . y) 1/3)", integer(2)).step("(!go (p 1 -2))", integer(0));
  const Plan plan = builder.plan();
  std::string text;
  for (const Step& step : plan.steps) {
    text += store.to_text(step.action) + ' ' + to_text(step.cost) + '\n';
  }
  Diagnostics errors;

  const std::vector<GivenPlan> plans = read_plans("plan", text, store, errors);

  ASSERT_TRUE(errors.empty()) << to_text(errors);
  ASSERT_EQ(plans.at(0).steps.size(), 2U);
  for (std::size_t at = 0; at < 2; ++at) {
    EXPECT_EQ(plans[0].steps[at].action, plan.steps[at].action);
    EXPECT_EQ(plans[0].steps[at].cost, plan.steps[at].cost);
  }
}

TEST_F(RoundTrip, StepNumbersInTextsAlign) {
  PlanBuilder builder(store);
  for (int at = 0; at < 10; ++at) builder.step("(!a)", integer(at == 9 ? 100 : 1));

  const std::string text = steps_text(builder.plan(), store, {});

  EXPECT_THAT(text, HasSubstr("   1  (!a)    1\n"));
  EXPECT_THAT(text, HasSubstr("  10  (!a)  100\n"));
}

// Graph

TEST_F(RoundTrip, GraphsEscapeTitlesTextsAndMethods) {
  PlanBuilder builder(store);
  builder.step("(!say \"back\\\\slash\")", integer(1));
  const TreeIndex root = builder.network(TreeNodeKind::kOrdered);
  const TreeIndex task = builder.task("(tell \"x\")", "way \"1\"", root);
  builder.leaf(0, task);

  const std::string dot = to_dot(builder.plan(), store, {true, "plan \"A\"\nof two\\lines"});

  EXPECT_THAT(dot, HasSubstr(R"(label="plan \"A\"\nof two\\lines";)"));
  EXPECT_THAT(dot, HasSubstr(R"(label="(tell \"x\")\nway \"1\"")"));
  // The backslash of the text is written \\ by Lisp, and each of both escaped for the graph.
  EXPECT_THAT(dot, HasSubstr(R"((!say \"back\\\\slash\"))"));
}

TEST_F(RoundTrip, GraphsHaveNoLineThatATextBreaks) {
  Plan plan;
  const std::vector<Term> action{store.symbol("!say"), store.string("one\ntwo")};
  plan.steps.push_back({store.list(action), integer(1), false});

  const std::string dot = to_dot(plan, store, {});

  EXPECT_THAT(dot, HasSubstr(R"(one\ntwo)"));
  EXPECT_THAT(dot, Not(HasSubstr("one\ntwo")));
}

TEST_F(RoundTrip, GraphsShortenByCharactersAndNotInTheMiddleOfOne) {
  std::string name;
  for (int at = 0; at < 60; ++at) name += "é";
  Plan plan;
  const std::vector<Term> action{store.symbol("!" + name)};
  plan.steps.push_back({store.list(action), integer(1), false});

  const std::string dot = to_dot(plan, store, {});

  // 48 characters: the parenthesis, the mark, 45 letters and the ellipsis.
  std::string letters;
  for (int at = 0; at < 45; ++at) letters += "é";
  EXPECT_THAT(dot, HasSubstr("label=\"1  (!" + letters + "…\""));
}

TEST_F(RoundTrip, GraphsOfUnorderedNetworksNameThem) {
  PlanBuilder builder(store);
  builder.step("(!a)", integer(1)).step("(!b)", integer(1));
  const TreeIndex root = builder.network(TreeNodeKind::kUnordered);
  builder.leaf(0, root);
  builder.leaf(1, root);

  const std::string dot = to_dot(builder.plan(), store, {});

  EXPECT_THAT(dot, HasSubstr("n0 [label=\"unordered\""));
  EXPECT_THAT(dot, HasSubstr("n0 -> s0;"));
  EXPECT_THAT(dot, HasSubstr("n0 -> s1;"));
}

TEST_F(RoundTrip, GraphsOfEmptyPlansAreGraphs) {
  const std::string dot = to_dot(Plan{}, store, {});

  EXPECT_THAT(dot, testing::StartsWith("digraph plan {"));
  EXPECT_THAT(dot, testing::EndsWith("}\n"));
  EXPECT_THAT(dot, Not(HasSubstr("->")));
}

}  // namespace
}  // namespace skein::htn
