// SPDX-License-Identifier: Apache-2.0
// Which variables a condition gives values to.
#include <algorithm>

#include "compile/condition_compiler.hpp"

namespace skein::htn {

namespace {

void add_slot(std::uint32_t slot, std::vector<std::uint32_t>& out) {
  if (std::find(out.begin(), out.end(), slot) == out.end()) out.push_back(slot);
}

void add_slots(const TermStore& store, Term pattern, std::vector<std::uint32_t>& out) {
  if (pattern.is(TermKind::kSlot)) return add_slot(pattern.index(), out);
  if ((store.content(pattern) & kHasSlot) == 0) return;
  std::vector<Term> open;
  Term rest = pattern;
  while (true) {
    for (; rest.is(TermKind::kPair); rest = store.cdr(rest)) {
      const Term item = store.car(rest);
      if (item.is(TermKind::kSlot)) {
        add_slot(item.index(), out);
      } else if ((store.content(item) & kHasSlot) != 0) {
        open.push_back(item);
      }
    }
    if (rest.is(TermKind::kSlot)) add_slot(rest.index(), out);
    if (open.empty()) return;
    rest = open.back();
    open.pop_back();
  }
}

}  // namespace

void set_slots(const CompiledDomain& domain, Condition& condition) {
  std::vector<GoalIndex> open(condition.goals.rbegin(), condition.goals.rend());
  while (!open.empty()) {
    const Goal& goal = domain.goals[open.back()];
    open.pop_back();
    add_slots(domain.store, goal.pattern, condition.slots);
    add_slots(domain.store, goal.term, condition.slots);
    if (goal.kind == GoalKind::kForall) continue;
    for (const ConditionIndex inner : goal.conditions) {
      const std::vector<GoalIndex>& goals = domain.conditions[inner].goals;
      open.insert(open.end(), goals.rbegin(), goals.rend());
    }
  }
}

}  // namespace skein::htn
