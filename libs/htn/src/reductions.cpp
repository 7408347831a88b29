// SPDX-License-Identifier: Apache-2.0
#include "reductions.hpp"

#include <algorithm>
#include <unordered_set>

#include "term_map.hpp"

namespace skein::htn {

void Reducer::reduce(const Method& method, Term task, const Tell& tell) {
  const Bindings::Mark mark = bindings_.mark();
  const Base base = bindings_.open(method.slots);
  if (bindings_.unify(store_.cdr(method.head), base, store_.cdr(task), 0)) {
    Answers answers;
    for (const Branch& branch : method.branches) {
      if (!prover_.solve(branch.precondition, base, false, answers)) break;
      if (tell) tell(method, branch, base, answers);
      if (answers.count() == 0) continue;
      add(branch, mark, base, answers);
      break;
    }
  }
  bindings_.undo(mark);
}

void Reducer::add(const Branch& branch, Bindings::Mark mark, Base base, const Answers& answers) {
  const std::size_t width = branch.leaves.size();
  const auto same = [this, width](std::size_t left, std::size_t right) {
    return std::equal(pool_.tasks.begin() + static_cast<std::ptrdiff_t>(left),
                      pool_.tasks.begin() + static_cast<std::ptrdiff_t>(left + width),
                      pool_.tasks.begin() + static_cast<std::ptrdiff_t>(right));
  };
  const auto hash = [this, width](std::size_t begin) {
    std::size_t mixed = 0;
    for (std::size_t at = begin; at < begin + width; ++at) {
      mixed = (mixed ^ pool_.tasks[at].bits()) * 0x9E3779B97F4A7C15ULL;
    }
    return mixed ^ (mixed >> 32U);
  };
  std::unordered_set<std::size_t, decltype(hash), decltype(same)> seen(
      answers.count() > 1 ? answers.count() * 2 : 1, hash, same);
  for (std::size_t row = 0; row < answers.count(); ++row) {
    const ReductionPool::Mark before = pool_.mark();
    const Bindings::Mark row_mark = bindings_.mark();
    answers.apply(row, bindings_);
    const bool made = add_row(branch, mark, base);
    bindings_.undo(row_mark);
    if (!made) return;
    if (answers.count() > 1 && !seen.insert(before.tasks).second) {
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
