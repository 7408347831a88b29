// SPDX-License-Identifier: Apache-2.0
#include "testing/planner_case.hpp"

#include <gtest/gtest.h>

#include "compile/expression_term.hpp"

namespace skein::htn::test {

Case::Case(const std::string& items, const std::string& facts, const std::string& tasks)
    : text_("(defdomain d (\n" + items + "\n))\n(defproblem p d (" + facts + ")\n" + tasks + ")") {}

void Case::compile() {
  if (compiled_) return;
  compiled_ = true;
  Diagnostics warnings;
  read_definitions({"case.lisp", text_}, store, {}, definitions_, errors_, warnings);
  if (!errors_.empty() || definitions_.domains.empty() || definitions_.problems.empty()) return;
  domain_ = Domain::compile(definitions_.domains.front(), definitions_.functions, functions, store,
                            errors_);
  problem_ = make_problem(definitions_.problems.front(), store);
}

Domain& Case::domain() {
  compile();
  if (!domain_) throw std::runtime_error(to_text(errors_) + text_);
  return *domain_;
}

const Problem& Case::problem() {
  compile();
  return problem_;
}

std::string Case::errors() {
  compile();
  return to_text(errors_);
}

Outcome Case::run() { return plan(domain(), problem(), options, host); }

std::string Case::shown(const Outcome& outcome) const {
  switch (outcome.verdict) {
    case Verdict::kPlan:
      return steps(outcome.plans.front());
    case Verdict::kNoPlan:
      return "no plan";
    case Verdict::kLimit:
      return "limit: " + outcome.why;
    case Verdict::kError:
      break;
  }
  return "error: " + outcome.why;
}

std::string Case::first() { return shown(run()); }

std::vector<std::string> Case::all() {
  options.which = Which::kAll;
  const Outcome outcome = run();
  if (outcome.verdict != Verdict::kPlan) return {shown(outcome)};
  std::vector<std::string> out;
  for (const Plan& plan : outcome.plans) out.push_back(steps(plan));
  return out;
}

std::string Case::steps(const Plan& plan) const {
  std::string out;
  for (const Step& step : plan.steps) {
    if (!out.empty()) out += ' ';
    out += store.to_text(step.action);
  }
  return out;
}

Term Case::term(const std::string& text) {
  Diagnostics errors;
  const Document document = read_document("term", text, store, errors);
  EXPECT_TRUE(errors.empty()) << text;
  TermScratch scratch;
  const auto same = [](Term atom) { return atom; };
  return term_of(Expression{&document, document.top.front()}, store, same, scratch);
}

std::string does(const std::string& head, const std::string& tasks) {
  return "(:method " + head + " () " + tasks + ")\n";
}

std::string adds(const std::string& head, const std::string& added, const std::string& cost) {
  return "(:operator " + head + " () () (" + added + ") " + cost + ")\n";
}

}  // namespace skein::htn::test
