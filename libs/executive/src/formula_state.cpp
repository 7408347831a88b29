// SPDX-License-Identifier: Apache-2.0
#include "formula_state.hpp"

#include <utility>

namespace skein::executive {

void FormulaState::assign(std::vector<CompiledLiteral> literals, std::uint32_t clauses) {
  ++version_;
  literals_ = std::move(literals);
  clauses_ = std::vector<ClauseCount>(clauses);
  unsatisfied_ = clauses;
  dead_ = 0;
  for (const CompiledLiteral& literal : literals_) ++clauses_[literal.clause].size;
  for (const ClauseCount& clause : clauses_) dead_ += clause.size == 0 ? 1 : 0;
  for (const CompiledLiteral& literal : literals_) count(literal, true);
}

void FormulaState::set(std::uint32_t index, Truth value) {
  CompiledLiteral& literal = literals_[index];
  if (literal.value == value) return;
  count(literal, false);
  literal.value = value;
  count(literal, true);
}

// Adds the literal's present value to the counters (`in`), or takes it out.
void FormulaState::count(const CompiledLiteral& literal, bool in) {
  ClauseCount& clause = clauses_[literal.clause];
  if (literal.value == Truth::kTrue) {
    if (clause.holding == (in ? 0U : 1U)) in ? --unsatisfied_ : ++unsatisfied_;
    in ? ++clause.holding : --clause.holding;
  } else if (literal.value == Truth::kNever) {
    if (clause.dead == (in ? clause.size - 1 : clause.size)) in ? ++dead_ : --dead_;
    in ? ++clause.dead : --clause.dead;
  }
}

}  // namespace skein::executive
