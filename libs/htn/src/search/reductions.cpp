// SPDX-License-Identifier: Apache-2.0
#include "search/reductions.hpp"

#include <algorithm>
#include <span>

#include "skein/htn/term_map.hpp"

namespace skein::htn {

void Reducer::reduce(const Method& method, Term task, const Tell& tell) {
  const Bindings::Mark mark = bindings_.mark();
  Base base = 0;
  if (bindings_.enter(method.slots, store_.cdr(method.head), method.items, store_.cdr(task), 0,
                      base)) {
    for (const Branch& branch : method.branches) {
      if (!prover_.solve(branch.precondition, base, false, answers_)) break;
      if (tell) tell(method, branch, base, answers_);
      if (answers_.count() == 0) continue;
      add(branch, mark, base, answers_);
      break;
    }
  }
  bindings_.undo(mark);
}

void Reducer::add(const Branch& branch, Bindings::Mark mark, Base base, const Answers& answers) {
  const std::size_t width = branch.leaves.size();
  const auto tasks_at = [this, width](std::size_t begin) {
    return std::span<const Term>(pool_.tasks).subspan(begin, width);
  };
  made_.begin(answers.count());
  for (std::size_t row = 0; row < answers.count(); ++row) {
    const ReductionPool::Mark before = pool_.mark();
    const Bindings::Mark row_mark = bindings_.mark();
    answers.apply(row, bindings_);
    const bool made = add_row(branch, mark, base);
    bindings_.undo(row_mark);
    if (!made) return;
    if (answers.count() > 1 && !made_.add(before.tasks, tasks_at)) {
      pool_.cut(before);
      continue;
    }
    Reduction reduction{&branch,
                        0,
                        before.tasks,
                        before.bindings,
                        static_cast<std::uint32_t>(pool_.bindings.size()),
                        static_cast<std::uint32_t>(renamed_.size())};
    if (!answers.support.empty()) {
      reduction.support = before.support;
      pool_.support.push_back(answers.support[row]);
    }
    for (; reduction.forcing < branch.forcings.size(); ++reduction.forcing) {
      pool_.reductions.push_back(reduction);
    }
  }
}

// The tasks under the present bindings, and the values given to variables older than the method.
bool Reducer::add_row(const Branch& branch, Bindings::Mark mark, Base base) {
  renamed_.clear();
  const auto rename = [this, mark](Term variable) {
    if (variable.index() < mark.cells) return variable;
    const auto known = std::find(renamed_.begin(), renamed_.end(), variable);
    const auto index = static_cast<std::uint32_t>(known - renamed_.begin());
    if (known == renamed_.end()) renamed_.push_back(variable);
    return Term(TermKind::kLocal, index);
  };
  for (const std::uint32_t node : branch.leaves) {
    const std::optional<Term> task = leaf(branch.body[node], base);
    if (!task) return false;
    if (!task->is(TermKind::kPair)) {
      budget_.fail(place_text(branch.where) + ": a computed task is " + store_.to_text(*task));
      return false;
    }
    pool_.tasks.push_back(map_leaves(store_, *task, kHasVariable, rename));
  }
  bindings_.for_each_bound_since(mark, [&](Term variable) {
    const Term value = bindings_.instance(variable, 0);
    pool_.bindings.emplace_back(variable, map_leaves(store_, value, kHasVariable, rename));
  });
  return true;
}

std::optional<Term> Reducer::leaf(const BodyNode& node, Base base) {
  if (node.code == kNoCode) return bindings_.instance(node.task, base);
  const auto value = domain_.lisp.evaluate(node.code, [this, base](std::uint32_t slot) {
    return bindings_.instance(Term(TermKind::kSlot, slot), base);
  });
  if (!value) {
    budget_.fail(place_text(value.error().where) + ": " + value.error().why);
    return std::nullopt;
  }
  Term task = *value;
  for (std::uint8_t word = 0; word < node.skipped; ++word) task = store_.cdr(task);
  return task;
}

const Term* Reducer::install(const Reduction& reduction) {
  const Base base = reduction.locals == 0 ? 0 : bindings_.open(reduction.locals);
  const auto fresh = [base](Term local) { return Term(TermKind::kVariable, base + local.index()); };
  const auto revive = [&](Term term) { return map_leaves(store_, term, kHasLocal, fresh); };
  for (std::uint32_t at = reduction.bindings; at < reduction.bindings_end; ++at) {
    bindings_.bind(pool_.bindings[at].first, revive(pool_.bindings[at].second));
  }
  ready_.clear();
  for (std::size_t leaf = 0; leaf < reduction.branch->leaves.size(); ++leaf) {
    ready_.push_back(revive(pool_.tasks[reduction.tasks + leaf]));
  }
  return ready_.data();
}

}  // namespace skein::htn
