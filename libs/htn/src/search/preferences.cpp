// SPDX-License-Identifier: Apache-2.0
#include "search/preferences.hpp"

#include <algorithm>

namespace skein::htn {

namespace {

Term name_of(const TermStore& store, Term task) {
  return task.is(TermKind::kPair) ? store.car(task) : task;
}

}  // namespace

Preferences::Preferences(const std::vector<Preference>& preferences, const TermStore& store)
    : store_(store) {
  for (const Preference& preference : preferences) {
    const auto next = static_cast<std::uint32_t>(groups_.size());
    const auto [at, fresh] = group_of_task_.try_emplace(preference.task, next);
    if (fresh) {
      groups_.push_back({preference.task, {}, 0});
      groups_of_name_[name_of(store, preference.task)].push_back(next);
    }
    groups_[at->second].all.push_back(&preference);
  }
}

std::uint32_t Preferences::group_of(Term task) const {
  if (store_.ground(task)) {
    const auto known = group_of_task_.find(task);
    return known == group_of_task_.end() ? kNone : known->second;
  }
  const auto named = groups_of_name_.find(name_of(store_, task));
  if (named == groups_of_name_.end()) return kNone;
  for (const std::uint32_t group : named->second) {
    const Group& here = groups_[group];
    if (here.used < here.all.size() && agree(task, here.task)) return group;
  }
  return kNone;
}

const Preference* Preferences::find(Term task) const {
  const std::uint32_t group = group_of(task);
  if (group == kNone || groups_[group].used >= groups_[group].all.size()) return nullptr;
  return groups_[group].all[groups_[group].used];
}

void Preferences::use(Term task) {
  const std::uint32_t group = group_of(task);
  if (group == kNone) return;
  ++groups_[group].used;
  trail_.push_back(group);
}

void Preferences::undo(Mark mark) {
  for (; trail_.size() > mark; trail_.pop_back()) --groups_[trail_.back()].used;
}

bool Preferences::agrees(const Preference& preference, std::span<const Term> leaves) const {
  const auto nothing = [this](Term task) {
    return task.is(TermKind::kPair) && store_.car(task).is(TermKind::kSymbol) &&
           store_.name(store_.car(task)) == "!!inop";
  };
  auto wanted = preference.subtasks.begin();
  for (const Term leaf : leaves) {
    if (nothing(leaf)) continue;
    if (wanted == preference.subtasks.end() || !agree(leaf, *wanted)) return false;
    ++wanted;
  }
  return wanted == preference.subtasks.end();
}

bool Preferences::agree(Term left, Term right) const {
  const auto variable = [](Term term) {
    return term.is(TermKind::kVariable) || term.is(TermKind::kLocal);
  };
  std::vector<std::pair<Term, Term>> open{{left, right}};
  while (!open.empty()) {
    const auto [one, other] = open.back();
    open.pop_back();
    if (one == other || variable(one) || variable(other)) continue;
    if (!one.is(TermKind::kPair) || !other.is(TermKind::kPair)) return false;
    if (store_.ground(one) && store_.ground(other)) return false;
    open.emplace_back(store_.cdr(one), store_.cdr(other));
    open.emplace_back(store_.car(one), store_.car(other));
  }
  return true;
}

}  // namespace skein::htn
