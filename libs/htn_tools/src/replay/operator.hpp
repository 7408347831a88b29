// SPDX-License-Identifier: Apache-2.0
// Application of operators to a state, and reasons why one does not apply.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replay/proof.hpp"
#include "skein/htn/number.hpp"

namespace skein::htn::replay {

/// One application of an operator, with its effects.
struct Application {
  Term action;  ///< with all that the precondition bound
  std::vector<Term> deletions;
  std::vector<Term> additions;
  Number cost;
  bool operator==(const Application&) const = default;
};

/// The distinct applications of `action` in the context's world, at most `limit`; the one found
/// first comes first. None: the precondition has no proof, or context.error.
std::vector<Application> applications(ProofContext& context, const OperatorClause& clause,
                                      Term action, std::size_t limit);

/// The first conjunct of the precondition that has no proof together with those before it.
std::string unmet_conjunct(ProofContext& context, const OperatorClause& clause, Term action);

/// Changes the world: deletions, additions, then the check of protections. Returns the reason if it
/// is not permitted; the world is then unchanged.
std::optional<std::string> apply(ProofContext& context, World& world,
                                 const Application& application);

/// The text of a goal with bound variables replaced; unbound ones keep their names.
std::string goal_text(const ProofContext& context, const Goal& goal, std::uint32_t base);

}  // namespace skein::htn::replay
