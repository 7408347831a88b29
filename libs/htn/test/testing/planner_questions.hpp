// SPDX-License-Identifier: Apache-2.0
// Conditions asked in a state, with their answers as text.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "proof/prover.hpp"
#include "testing/planner_case.hpp"

namespace skein::htn::test {

/// Every question is the precondition of a method of its own.
class Questions {
 public:
  explicit Questions(std::string facts, std::string axioms = "")
      : facts_(std::move(facts)), axioms_(std::move(axioms)) {}

  Limits limits;
  Host host;
  Functions functions;
  std::uint64_t inferences = 0;  ///< of the last question

  /// The values of the variables under each satisfier, in order: "(a 1) (b 2)". "none";
  /// "error: …"; "stopped: …"; "bad: …" when the domain has errors.
  std::string ask(const std::string& condition, const std::string& variables = "") {
    return answers(condition, variables, false);
  }
  /// The satisfier an operator would take.
  std::string one(const std::string& condition, const std::string& variables = "") {
    return answers(condition, variables, true);
  }
  bool holds(const std::string& condition) {
    const std::string found = ask(condition);
    EXPECT_TRUE(found == "nil" || found == "none") << found;
    return found == "nil";
  }

 private:
  std::string answers(const std::string& condition, const std::string& variables, bool just_one) {
    Case made(axioms_ + "\n(:method (ask " + variables + ") " + condition + " ())", facts_);
    made.functions = functions;
    if (!made.errors().empty()) return "bad: " + made.errors();
    CompiledDomain& domain = made.domain().compiled();
    const Method& method = domain.methods.at(made.store.symbol("ask")).front();
    Bindings bindings(made.store);
    FactBase facts(made.store);
    for (const Term fact : made.problem().facts) facts.add(fact, kInitialState);
    Budget budget(limits, host, [&] { return bindings.memory_bytes(); });
    Prover prover(domain, bindings, facts, budget);
    const Base base = bindings.open(method.slots);
    Answers found;
    const bool done = prover.solve(method.branches.front().precondition, base, just_one, found);
    inferences = budget.inferences();
    if (!done) return (budget.error() ? "error: " : "stopped: ") + budget.why();
    std::string out;
    for (std::size_t row = 0; row < found.count(); ++row) {
      const Bindings::Mark mark = bindings.mark();
      found.apply(row, bindings);
      const Term values = bindings.instance(made.store.cdr(method.head), base);
      out += (out.empty() ? "" : " ") + made.store.to_text(values);
      bindings.undo(mark);
    }
    return out.empty() ? "none" : out;
  }

  std::string facts_;
  std::string axioms_;
};

}  // namespace skein::htn::test
