// SPDX-License-Identifier: Apache-2.0
// Which facts a domain and a problem of it know of.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "skein/htn/definitions.hpp"
#include "skein/htn/term_store.hpp"

namespace skein::htn {

/// The predicates that conditions, effects, axioms and facts name, each with the numbers of
/// arguments it has there.
struct Predicates {
  std::map<std::string, std::set<std::size_t>> arities;
  bool any = false;  ///< an operator may add or delete what a variable holds: there may be others
};
/// `definitions` is where domain and problem come from. Cost: linear in their text.
Predicates predicates_of(Definitions& definitions, const DomainDefinition& domain,
                         const ProblemDefinition& problem, TermStore& store);

}  // namespace skein::htn
