// SPDX-License-Identifier: Apache-2.0
// A domain and a problem as text, and plans as text that are validated against them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "skein/htn_tools/validator.hpp"

namespace skein::htn::testing_validator {

class ValidatorFixture {
 public:
  /// Definitions of one domain and one problem.
  explicit ValidatorFixture(const std::string& text) {
    Diagnostics errors;
    Diagnostics warnings;
    read_definitions(
        {"test.lisp", text}, store, [](const auto&, const auto&) { return failure("none"); },
        definitions, errors, warnings);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
  }
  /// A domain of these items, a problem of these facts and tasks.
  ValidatorFixture(const std::string& items, const std::string& facts,
                   const std::string& tasks = "()")
      : ValidatorFixture("(defdomain d (" + items + ")) (defproblem p d (" + facts + ") " + tasks +
                         ")") {}

  Validation validate(const std::string& plan, const Validator::Limits& limits = {}) {
    Diagnostics errors;
    const std::vector<GivenPlan> plans = read_plans("plan", plan, store, errors);
    EXPECT_TRUE(errors.empty()) << plan << '\n' << to_text(errors);
    EXPECT_EQ(plans.size(), 1U) << plan;
    const Validator validator(definitions.domains.at(0), definitions.functions, Functions{}, store,
                              errors);
    EXPECT_TRUE(errors.empty()) << to_text(errors);
    if (plans.size() != 1) return {};
    return validator.validate(definitions.problems.at(0), plans[0], limits);
  }
  bool valid(const std::string& plan) { return !validate(plan).fault; }
  std::string text(const std::string& plan) { return to_text(validate(plan)); }

  TermStore store;
  Definitions definitions;
};

}  // namespace skein::htn::testing_validator
