// SPDX-License-Identifier: Apache-2.0
// Oracle: all plans of a small problem in the order the language defines, by plain recursion.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "skein/htn/definitions.hpp"
#include "skein/htn/functions.hpp"
#include "skein/htn/number.hpp"

namespace skein::htn::oracle {

struct OraclePlan {
  std::vector<std::string> steps;  ///< as text, "?" for variables that stay unbound
  std::vector<double> costs;
  double cost = 0;
  std::uint64_t depth = 0;           ///< decompositions and steps
  std::vector<std::string> choices;  ///< everything that was chosen on the way
};

struct OracleOutcome {
  std::vector<OraclePlan> plans;
  std::uint64_t expansions = 0;
  std::uint64_t inferences = 0;
  bool cut = false;  ///< the depth limit was met somewhere
  std::optional<std::string> error;
  bool out_of_budget = false;  ///< nothing can be said
};

struct OracleLimits {
  std::uint64_t depth = 40;
  std::uint64_t expansions = 3'000;
  std::uint64_t inferences = 200'000;
  bool first_only = false;
  bool equals_again = false;  ///< as SHOP3: of equal tasks on the agenda each is tried
};

OracleOutcome brute_force(const DomainDefinition& domain,
                          const std::vector<FunctionDefinition>& functions,
                          const ProblemDefinition& problem, TermStore& store,
                          const OracleLimits& limits);

}  // namespace skein::htn::oracle
