// SPDX-License-Identifier: Apache-2.0
#include "skein/htn_tools/plan_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "skein/htn_tools/given_plan.hpp"
#include "testing/sample_plan.hpp"

namespace skein::htn {
namespace {

using nlohmann::json;
using testing_plans::swap_plan;
using testing_plans::term;

std::string json_of(const std::string& text) {
  TermStore store;
  std::string out;
  append_json(term(text, store), store, out);
  return out;
}

TEST(TermJson, WritesEachKindOfTerm) {
  EXPECT_EQ(json_of("karma"), "\"karma\"");
  EXPECT_EQ(json_of("(!goto karma (p 1 -2))"), R"(["!goto","karma",["p",1,-2]])");
  EXPECT_EQ(json_of("()"), "\"nil\"");
  EXPECT_EQ(json_of("(a () (b))"), R"(["a","nil",["b"]])");
  EXPECT_EQ(json_of("(0.5 4.0 1/3)"), R"([0.5,4.0,"1/3"])");
  EXPECT_EQ(json_of("(\"a b\" \"\")"), R"(["\"a b\"","\"\""])");
  EXPECT_EQ(json_of("(a . b)"), R"(["a",".","b"])");
  EXPECT_EQ(json_of("((a b . 3) c)"), R"([["a","b",".",3],"c"])");
}

TEST(TermJson, GivesFloatsTheFewestDigitsOfTheirPrecision) {
  EXPECT_EQ(json_of("(0.1 0.1d0 0.30000000000000004d0)"), "[0.1,0.1,0.30000000000000004]");
}

TEST(TermJson, EscapesWhatJsonCannotHold) {
  TermStore store;
  std::string out;

  append_json(store.string("a\"b\\c\n\t\x01 é"), store, out);

  EXPECT_EQ(out, "\"\\\"a\\\"b\\\\c\\n\\u0009\\u0001 é\\\"\"");
  EXPECT_EQ(json::parse(out).get<std::string>(), "\"a\"b\\c\n\t\x01 é\"");
}

TEST(TermJson, ReplacesBytesThatAreNoText) {
  TermStore store;
  std::string out;

  append_json(store.string("a\xFF"), store, out);

  EXPECT_EQ(json::parse(out).get<std::string>(), "\"a\xEF\xBF\xBD\"");
}

TEST(TermJson, NeedsNoRecursionForDeepTerms) {
  TermStore store;
  Term deep = kNil;
  constexpr std::size_t kDepth = 100'000;
  for (std::size_t level = 0; level < kDepth; ++level) deep = store.pair(deep, kNil);
  std::string out;

  append_json(deep, store, out);

  EXPECT_EQ(out.size(), 2 * kDepth + 5);
}

TEST(PlanJson, HasStepsCostsAndTotal) {
  TermStore store;
  std::string out;

  append_json(swap_plan(store), store, {}, out);

  EXPECT_EQ(out, R"({"cost":3.5,"steps":[["!drop","banjo"],["!!note","banjo"],["!pickup","kiwi"]],)"
                 R"("costs":[1,0,2.5]})");
}

TEST(PlanJson, SaysWhenInternalStepsAreLeftOut) {
  TermStore store;
  std::string out;

  append_json(swap_plan(store), store, {.internal = false}, out);

  EXPECT_EQ(out, R"({"cost":3.5,"internal":false,"steps":[["!drop","banjo"],["!pickup","kiwi"]],)"
                 R"("costs":[1,2.5]})");
}

TEST(PlanJson, WritesTheTreeAsNodesWithPositions) {
  TermStore store;
  std::string out;

  append_json(swap_plan(store), store, {.internal = true, .tree = true}, out);

  const json tree = json::parse(out)["tree"];
  ASSERT_EQ(tree.size(), 6U);
  EXPECT_EQ(tree[0].dump(), R"({"children":[1],"kind":"ordered"})");
  EXPECT_EQ(tree[1]["method"], "has-first");
  EXPECT_EQ(tree[1]["support"].dump(), R"([{"fact":["have","banjo"],"step":"initial"}])");
  EXPECT_EQ(tree[5]["step"], 2);
  EXPECT_EQ(tree[5]["support"][0].dump(), R"({"fact":["free","hand"],"step":0})");
}

TEST(PlanJson, NumbersTheStepsOfTheTreeAsThoseItShows) {
  TermStore store;
  std::string out;

  append_json(swap_plan(store), store, {.internal = false, .tree = true}, out);

  const json tree = json::parse(out)["tree"];
  EXPECT_FALSE(tree[4].contains("step"));
  EXPECT_EQ(tree[5]["step"], 1);
  EXPECT_EQ(tree[5]["support"][1]["step"], "internal");
}

TEST(PlanningReport, IsOneLineOfTheSpecsForm) {
  TermStore store;
  Outcome outcome;
  outcome.verdict = Verdict::kPlan;
  outcome.plans.push_back(swap_plan(store));
  outcome.statistics = {4, 2, 3, 0};
  const PlanningReport report{"problem1", "basic", 0.0000125, 0.25, 3.5};

  const std::string line = to_json(report, outcome, store, {});

  EXPECT_EQ(line.find('\n'), std::string::npos);
  const json object = json::parse(line);
  EXPECT_EQ(object["problem"], "problem1");
  EXPECT_EQ(object["domain"], "basic");
  EXPECT_EQ(object["result"], "plan");
  EXPECT_EQ(object["plans"].size(), 1U);
  EXPECT_EQ(object["expansions"], 4);
  EXPECT_EQ(object["inferences"], 2);
  EXPECT_NEAR(object["seconds"].get<double>(), 0.0000125, 1e-6);
  EXPECT_EQ(object["reading_seconds"], 0.25);
  EXPECT_EQ(object["memory_mb"], 3.5);
  EXPECT_FALSE(object.contains("why"));
  EXPECT_FALSE(object.contains("failure"));
}

TEST(PlanningReport, NamesEveryVerdict) {
  TermStore store;
  const auto result = [&](Verdict verdict) {
    Outcome outcome;
    outcome.verdict = verdict;
    outcome.why = "because";
    const json object = json::parse(to_json({}, outcome, store, {}));
    EXPECT_EQ(object["why"], "because");
    return object["result"].get<std::string>();
  };

  EXPECT_EQ(result(Verdict::kPlan), "plan");
  EXPECT_EQ(result(Verdict::kNoPlan), "no-plan");
  EXPECT_EQ(result(Verdict::kLimit), "limit");
  EXPECT_EQ(result(Verdict::kError), "error");
}

TEST(PlanningReport, TellsTheDeepestPointOfAFailure) {
  TermStore store;
  Outcome outcome;
  FailurePoint failure;
  failure.steps = swap_plan(store).steps;
  failure.open_tasks = {term("(mission)", store), term("(goto b)", store)};
  failure.attempts.push_back(
      {term("(goto b)", store), "direct", "(road a b)", {term("(road a c)", store)}});
  outcome.failure = failure;

  const json told = json::parse(to_json({}, outcome, store, {}))["failure"];

  EXPECT_EQ(told["steps"].size(), 3U);
  EXPECT_EQ(told["open_tasks"].dump(), R"([["mission"],["goto","b"]])");
  EXPECT_EQ(told["attempts"][0]["label"], "direct");
  EXPECT_EQ(told["attempts"][0]["condition"], "(road a b)");
  EXPECT_EQ(told["attempts"][0]["nearest"].dump(), R"([["road","a","c"]])");
}

// --- laws ----------------------------------------------------------------------------------------

rc::Gen<Term> any_term(TermStore& store, int depth) {
  const auto symbol = rc::gen::map(rc::gen::inRange(0, 9), [&store](int index) {
    return store.symbol("s" + std::to_string(index));
  });
  const auto number = rc::gen::map(rc::gen::arbitrary<std::int64_t>(),
                                   [&store](std::int64_t value) { return store.integer(value); });
  const auto real_number = rc::gen::map(rc::gen::arbitrary<double>(), [&store](double value) {
    return store.number(real(std::abs(value) < 1e15 ? value : 0.5));
  });
  const auto text =
      rc::gen::map(rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~')),
                   [&store](const std::string& value) { return store.string(value); });
  if (depth == 0) return rc::gen::oneOf(symbol, number, real_number, text);
  const auto list =
      rc::gen::map(rc::gen::container<std::vector<Term>>(any_term(store, depth - 1)),
                   [&store](const std::vector<Term>& items) { return store.list(items); });
  return rc::gen::oneOf(symbol, number, real_number, text, list);
}

RC_GTEST_PROP(PlanJsonLaws, APlanReadBackHasTheSameStepsAndCosts, ()) {
  TermStore store;
  const auto actions =
      *rc::gen::resize(8, rc::gen::container<std::vector<std::vector<Term>>>(
                              rc::gen::container<std::vector<Term>>(any_term(store, 2))));
  Outcome outcome;
  outcome.plans.emplace_back();
  outcome.plans[0].cost = integer(7);
  for (std::vector<Term> items : actions) {
    items.insert(items.begin(), store.symbol("!do"));
    const auto cost = *rc::gen::inRange(-5, 50);
    outcome.plans[0].steps.push_back({store.list(items), integer(cost), false});
  }

  Diagnostics errors;
  const std::string line = to_json({"p", "d", 0, 0, 0}, outcome, store, {});
  const std::vector<GivenPlan> read = read_plans("plan", line, store, errors);

  RC_ASSERT(errors.empty());
  RC_ASSERT(read.size() == 1U);
  RC_ASSERT(read[0].problem == "p");
  RC_ASSERT(read[0].cost == integer(7));
  RC_ASSERT(read[0].steps.size() == outcome.plans[0].steps.size());
  for (std::size_t at = 0; at < read[0].steps.size(); ++at) {
    RC_ASSERT(read[0].steps[at].action == outcome.plans[0].steps[at].action);
    RC_ASSERT(read[0].steps[at].cost == outcome.plans[0].steps[at].cost);
  }
}

}  // namespace
}  // namespace skein::htn
