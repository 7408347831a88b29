// SPDX-License-Identifier: Apache-2.0
#include "search/step_maker.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <unordered_set>

namespace skein::htn {

namespace {

// The order in which SHOP3 carries out a list of changes: the last of the text first, of equal ones
// the last.
void last_first(std::vector<Term>& atoms) {
  if (atoms.size() < 2) return;
  std::reverse(atoms.begin(), atoms.end());
  std::size_t kept = 0;
  constexpr std::size_t kFew = 16;
  if (atoms.size() <= kFew) {
    for (const Term atom : atoms) {
      const auto end = atoms.begin() + static_cast<std::ptrdiff_t>(kept);
      if (std::find(atoms.begin(), end, atom) == end) atoms[kept++] = atom;
    }
  } else {
    std::unordered_set<Term> seen;
    for (const Term atom : atoms) {
      if (seen.insert(atom).second) atoms[kept++] = atom;
    }
  }
  atoms.resize(kept);
}

}  // namespace

bool StepMaker::refuse(const char* why) {
  why_ = why;
  return false;
}

bool StepMaker::fail(const std::string& why) {
  budget_.fail(place_text(where_) + ": " + why);
  return refuse("");
}

bool StepMaker::apply(const Operator& operation, Term task, StepIndex step, MadeStep& made) {
  const Bindings::Mark bindings = bindings_.mark();
  const FactBase::Mark facts = facts_.mark();
  const Protections::Mark protections = protections_.mark();
  precondition_failed_ = false;
  where_ = operation.where;
  Base base = 0;
  const bool worked_out = prepare(operation, task, base, made) && work_out(operation, base);
  if (worked_out && recording_) note_change(made.change);
  if (worked_out && change_state(step)) {
    made.action = bindings_.instance(operation.head, base);
    bindings_.close(bindings);
    return true;
  }
  facts_.undo(facts);
  protections_.undo(protections);
  bindings_.undo(bindings);
  return false;
}

// Binds the head and the first satisfier of the precondition; works out the cost.
bool StepMaker::prepare(const Operator& operation, Term task, Base& base, MadeStep& made) {
  if (!bindings_.enter(operation.slots, store_.cdr(operation.head), operation.items,
                       store_.cdr(task), 0, base)) {
    return refuse("the task does not match its head");
  }
  // Of an action SHOP3 takes the first object of the text that does, of an operator the last.
  if (!prover_.solve(operation.precondition, base, !operation.action, answers_)) return refuse("");
  if (answers_.count() == 0) {
    precondition_failed_ = true;
    return refuse("its precondition does not hold");
  }
  answers_.apply(0, bindings_);
  made.support = answers_.support.empty() ? std::vector<CausalLink>{} : answers_.support.front();
  made.cost = operation.fixed_cost;
  if (operation.cost == kNoCode) return true;
  const auto value = domain_.lisp.evaluate(operation.cost, [this, base](std::uint32_t slot) {
    return bindings_.instance(Term(TermKind::kSlot, slot), base);
  });
  if (!value) {
    budget_.fail(place_text(value.error().where) + ": " + value.error().why);
    return refuse("");
  }
  made.cost = value->is(TermKind::kNumber) ? store_.value(*value) : integer(1);
  return true;
}

// What to add, delete, protect and release, in the state as it still is.
bool StepMaker::work_out(const Operator& operation, Base base) {
  deleted_.clear();
  added_.clear();
  released_.clear();
  protected_.clear();
  if (operation.action) return collect(operation.effect, base, false);
  if (!collect(operation.deletions, base, true) || !collect(operation.additions, base, false)) {
    return false;
  }
  last_first(deleted_);
  last_first(added_);
  last_first(released_);
  last_first(protected_);
  return true;
}

bool StepMaker::collect(const std::vector<Effect>& effects, Base base, bool negated) {
  return std::all_of(effects.begin(), effects.end(),
                     [&](const Effect& effect) { return collect(effect, base, negated); });
}

bool StepMaker::collect(const Effect& effect, Base base, bool negated) {
  switch (effect.kind) {
    case EffectKind::kAtom:
      collect_atom(atom_of(effect, base), negated);
      return true;
    case EffectKind::kProtection:
      (negated ? released_ : protected_).push_back(atom_of(effect, base));
      return true;
    case EffectKind::kList:
      return collect_list(bindings_.instance(effect.pattern, base), negated);
    case EffectKind::kGroup:
      return collect(effect.parts, base, negated);
    case EffectKind::kNegated:
      return collect(effect.parts, base, !negated);
    case EffectKind::kForall:
      return collect_under(effect, base, negated, false);
    case EffectKind::kWhen:
      return collect_under(effect, base, negated, true);
  }
  return false;
}

// The instance of an effect. One that was a fact before is known by its arguments, without making
// it anew.
Term StepMaker::atom_of(const Effect& effect, Base base) {
  if (!effect.flat) return bindings_.instance(effect.pattern, base);
  std::array<Term, kMostFlatArguments> values;
  for (std::size_t at = 0; at < effect.arguments.size(); ++at) {
    values[at] = bindings_.instance(effect.arguments[at], base);
  }
  const std::span<const Term> arguments = std::span(values).first(effect.arguments.size());
  const Term predicate = store_.car(effect.pattern);
  const FactIndex known = facts_.record_of(predicate, arguments);
  return known != kNoFact ? facts_.atom(known) : store_.pair(predicate, store_.list(arguments));
}

bool StepMaker::is_atom(Term term) const {
  return term.is(TermKind::kPair) && store_.car(term).is(TermKind::kSymbol) && store_.is_list(term);
}

void StepMaker::collect_atom(Term atom, bool negated) {
  (negated ? deleted_ : added_).push_back(atom);
}

// A list of atoms that came as a value; (:protection atom) may be among them.
bool StepMaker::collect_list(Term list, bool negated) {
  for (const Term item : store_.items(list)) {
    if (!item.is(TermKind::kPair)) {
      return fail("a list of atoms to add or delete holds " + store_.to_text(item));
    }
    if (store_.car(item) == protection_ && store_.cdr(item).is(TermKind::kPair)) {
      (negated ? released_ : protected_).push_back(store_.car(store_.cdr(item)));
    } else {
      collect_atom(item, negated);
    }
  }
  return true;
}

// The parts of an effect under every satisfier of its condition, or under the first.
bool StepMaker::collect_under(const Effect& effect, Base base, bool negated, bool first) {
  Answers answers;
  if (!prover_.solve(effect.condition, base, first, answers)) return refuse("");
  const std::size_t rows = first ? std::min<std::size_t>(answers.count(), 1) : answers.count();
  for (std::size_t row = 0; row < rows; ++row) {
    const Bindings::Mark mark = bindings_.mark();
    answers.apply(row, bindings_);
    const bool done = collect(effect.parts, base, negated);
    bindings_.undo(mark);
    if (!done) return false;
  }
  return true;
}

// What will not be as it was: deletions come first, and what is added again stays.
void StepMaker::note_change(StateChange& change) const {
  const auto among = [](const std::vector<Term>& atoms, Term atom) {
    return std::find(atoms.begin(), atoms.end(), atom) != atoms.end();
  };
  for (const Term atom : deleted_) {
    const bool lost = is_atom(atom) && facts_.holds(atom) && !among(added_, atom);
    if (lost && !among(change.deleted, atom)) change.deleted.push_back(atom);
  }
  for (const Term atom : added_) {
    const bool won = is_atom(atom) && !facts_.holds(atom);
    if (won && !among(change.added, atom)) change.added.push_back(atom);
  }
}

bool StepMaker::change_state(StepIndex step) {
  for (const Term atom : released_) protections_.release(atom);
  for (const Term atom : deleted_) {
    if (is_atom(atom)) facts_.remove(atom, step);
  }
  for (const Term atom : added_) {
    if (!is_atom(atom) || !store_.ground(atom)) {
      return fail("a step would add " + store_.to_text(atom) + ", which is no ground atom");
    }
    facts_.add(atom, step);
  }
  if (!protections_.empty() && !protections_hold()) return refuse("it would violate a protection");
  for (const Term atom : protected_) {
    if (!is_atom(atom))
      return fail("a step would protect " + store_.to_text(atom) + ", which is no atom");
    if (!prover_.holds(atom)) return refuse("it would protect what does not hold");
    protections_.add(atom);
  }
  return true;
}

// Protected facts can only have been lost by this step; what follows by axioms is asked again.
bool StepMaker::protections_hold() const {
  for (const Term atom : deleted_) {
    if (protections_.count(atom) > 0 && !prover_.holds(atom)) return false;
  }
  if (domain_.axioms.empty()) return true;
  bool hold = true;
  protections_.for_each([&](Term atom) {
    const bool derived = domain_.axioms.contains(store_.car(atom));
    if (hold && derived) hold = prover_.holds(atom);
  });
  return hold;
}

}  // namespace skein::htn
