// SPDX-License-Identifier: Apache-2.0
#include "replay/world.hpp"

#include <algorithm>
#include <iterator>

#include "replay/bindings.hpp"

namespace skein::htn::replay {

const std::vector<Term>& World::facts(Term predicate) const {
  static const std::vector<Term> none;
  const auto found = facts_.find(predicate.bits());
  return found == facts_.end() ? none : found->second;
}

std::size_t World::find(const std::vector<Term>& facts, Term fact) const {
  const auto exact = std::find(facts.rbegin(), facts.rend(), fact);
  if (exact != facts.rend()) return static_cast<std::size_t>(facts.rend() - exact - 1);
  if ((store_.content(fact) & kHasLooseEqual) == 0) return facts.size();
  const auto near =
      std::find_if(facts.begin(), facts.end(), [&](Term one) { return alike(store_, one, fact); });
  return static_cast<std::size_t>(near - facts.begin());
}

bool World::holds(Term fact) const {
  const std::vector<Term>& of_predicate = facts(predicate_of(store_, fact));
  return find(of_predicate, fact) != of_predicate.size();
}

void World::add(Term fact) {
  std::vector<Term>& of_predicate = facts_[predicate_of(store_, fact).bits()];
  if (find(of_predicate, fact) != of_predicate.size()) return;
  of_predicate.push_back(fact);
  changes_.push_back({Kind::kAdded, fact, 0});
}

void World::remove(Term fact) {
  std::vector<Term>& of_predicate = facts_[predicate_of(store_, fact).bits()];
  const std::size_t place = find(of_predicate, fact);
  if (place == of_predicate.size()) return;
  changes_.push_back({Kind::kRemoved, of_predicate[place], place});
  of_predicate.erase(std::next(of_predicate.begin(), static_cast<std::ptrdiff_t>(place)));
}

void World::change_count(Term goal, int by) {
  Protection& protection = protections_[goal.bits()];
  protection.goal = goal;
  protection.count += by;
  if (protection.count == 0) protections_.erase(goal.bits());
}

std::vector<Term> World::protections() const {
  std::vector<Term> out;
  for (const auto& [bits, protection] : protections_) out.push_back(protection.goal);
  return out;
}

void World::protect(Term goal) {
  change_count(goal, 1);
  changes_.push_back({Kind::kProtected, goal, 0});
}

void World::release(Term goal) {
  if (!protections_.contains(goal.bits())) return;
  change_count(goal, -1);
  changes_.push_back({Kind::kReleased, goal, 0});
}

void World::undo(std::size_t mark) {
  while (changes_.size() > mark) {
    const Change change = changes_.back();
    changes_.pop_back();
    std::vector<Term>& facts = facts_[predicate_of(store_, change.term).bits()];
    switch (change.kind) {
      case Kind::kAdded:
        facts.pop_back();
        break;
      case Kind::kRemoved:
        facts.insert(std::next(facts.begin(), static_cast<std::ptrdiff_t>(change.place)),
                     change.term);
        break;
      case Kind::kProtected:
        change_count(change.term, -1);
        break;
      case Kind::kReleased:
        change_count(change.term, 1);
        break;
    }
  }
}

}  // namespace skein::htn::replay
