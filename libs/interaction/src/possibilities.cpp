// SPDX-License-Identifier: Apache-2.0
#include "possibilities.hpp"

#include <algorithm>

namespace skein::interaction {

Possibilities::Possibilities(const Automaton& automaton, std::optional<ComponelIndex> staying)
    : automaton_(automaton), reached_(automaton.size()), stays_(automaton.size(), false) {
  if (staying) note_staying(*staying);
  while (grow()) {
  }
}

const Formula& Possibilities::formula(Watch where) const {
  const Block& block = *automaton_[where.block].block();
  return where.side == Side::kPrecondition ? block.precondition : block.exit;
}

// A formula is looked at only while all blocks around its own are running, and its own is scheduled
// (preconditions, exits) or running (exits).
bool Possibilities::may_hold(const ComponelIs& is, bool negated, Watch where) const {
  if (automaton_.contains(is.componel, where.block)) {
    return (is.state == AskedState::kRunning) != negated;
  }
  if (is.componel == where.block) {
    if (where.side == Side::kPrecondition) return (is.state == AskedState::kScheduled) != negated;
    return negated || is.state == AskedState::kScheduled || is.state == AskedState::kRunning;
  }
  if (where.side == Side::kPrecondition && automaton_.contains(where.block, is.componel)) {
    return negated;  // no state before the block is activated
  }
  return negated || reaches(is.componel, is.state);
}

bool Possibilities::may_hold(const Literal& literal, Watch where) const {
  if (literal.modality == Modality::kOptional) return true;
  if (const auto* is = std::get_if<ComponelIs>(&literal.condition)) {
    return may_hold(*is, literal.negated, where);
  }
  const auto* time = std::get_if<TimeIs>(&literal.condition);
  if (time == nullptr) return true;
  const bool passed = time->passed != literal.negated;
  if (const auto* event = std::get_if<TimeIs::Event>(&time->since)) {
    return !passed || reaches(event->componel, event->state);
  }
  const bool at_start = std::holds_alternative<TimeIs::ModelStart>(time->since);
  return passed || !at_start || !time->named.empty() || time->after > Duration();
}

bool Possibilities::may_hold(Watch where) const {
  const Formula& all = formula(where);
  if (all.empty()) return where.side == Side::kPrecondition;
  return !contradicts_itself(all) && std::all_of(all.begin(), all.end(), [&](const Clause& clause) {
    return std::any_of(clause.begin(), clause.end(),
                       [&](const Literal& one) { return may_hold(one, where); });
  });
}

namespace {

bool exclude_each_other(AskedState a, AskedState b) {
  if (a == b) return false;
  const auto over = [](AskedState s) {
    return s == AskedState::kEnded || s == AskedState::kAborted;
  };
  if (a == AskedState::kOver) return !over(b);
  if (b == AskedState::kOver) return !over(a);
  return true;
}

// Both literals stand alone in their clauses.
bool exclude_each_other(const Literal& a, const Literal& b) {
  if (a.condition == b.condition) return a.negated != b.negated;
  if (a.negated || b.negated) return false;
  const auto* one = std::get_if<ComponelIs>(&a.condition);
  const auto* other = std::get_if<ComponelIs>(&b.condition);
  if (one != nullptr && other != nullptr) {
    return one->componel == other->componel && exclude_each_other(one->state, other->state);
  }
  const auto* early = std::get_if<TimeIs>(&a.condition);
  const auto* late = std::get_if<TimeIs>(&b.condition);
  if (early == nullptr || late == nullptr || early->since != late->since) return false;
  if (early->named != late->named || early->passed == late->passed) return false;
  if (early->passed) std::swap(early, late);
  return late->after >= early->after;  // passed, before another that has not
}

}  // namespace

bool Possibilities::contradicts_itself(const Formula& formula) const {
  std::vector<const Literal*> alone;
  for (const Clause& clause : formula) {
    if (clause.size() != 1 || clause[0].modality == Modality::kOptional) continue;
    for (const Literal* other : alone) {
      if (exclude_each_other(*other, clause[0])) return true;
    }
    alone.push_back(&clause[0]);
  }
  return false;
}

// What is inside a loop is left, too, where that begins anew.
void Possibilities::note_staying(ComponelIndex block) {
  std::vector<ComponelIndex> around{block};
  while (around.back() != 0) around.push_back(automaton_[around.back()].parent);
  for (auto one = around.rbegin(); one != around.rend(); ++one) {
    stays_[*one] = true;
    if (automaton_[*one].block()->type == BlockType::kLoop) break;
  }
}

bool Possibilities::reach(ComponelIndex componel, AskedState state) {
  const bool is_there = state == AskedState::kScheduled || state == AskedState::kRunning;
  if (stays_[componel] && !is_there) return false;
  bool& reached = reached_[componel][static_cast<std::size_t>(state)];
  if (reached) return false;
  reached = true;
  return true;
}

bool Possibilities::grow() {
  bool grown = reach(0, AskedState::kScheduled);
  for (ComponelIndex i = 0; i < automaton_.size(); ++i) {
    if (i > 0 && reaches(automaton_[i].parent, AskedState::kRunning)) {
      grown = reach(i, AskedState::kScheduled) || grown;
    }
    if (!reaches(i, AskedState::kScheduled)) continue;
    if (automaton_[i].block() != nullptr) {
      grown = grow_block(i) || grown;
      continue;
    }
    for (const AskedState state : {AskedState::kRunning, AskedState::kAborting,
                                   AskedState::kAborted, AskedState::kEnded, AskedState::kOver}) {
      grown = reach(i, state) || grown;
    }
  }
  return grown;
}

bool Possibilities::grow_block(ComponelIndex index) {
  bool grown = reach(index, AskedState::kAborted);  // at the latest with the model
  grown = reach(index, AskedState::kOver) || grown;
  if (!may_hold({index, Side::kPrecondition})) return grown;
  grown = reach(index, AskedState::kRunning) || grown;
  grown = reach(index, AskedState::kAborting) || grown;
  if (may_end(index)) grown = reach(index, AskedState::kEnded) || grown;
  return grown;
}

bool Possibilities::may_end(ComponelIndex plan) const {
  const Block& block = *automaton_[plan].block();
  if (block.type == BlockType::kLoop) return false;
  const auto ends_it = [&](ComponelIndex one) {
    const Block* inner = automaton_[one].block();
    return inner != nullptr && inner->end == EndMode::kImmediate &&
           reaches(one, AskedState::kEnded);
  };
  const auto may_be_over = [&](ComponelIndex one) {
    return automaton_[one].block() == nullptr || this->may_be_over(one);
  };
  return std::any_of(block.content.begin(), block.content.end(), ends_it) ||
         std::all_of(block.content.begin(), block.content.end(), may_be_over);
}

// While the block around it is not told to stop.
bool Possibilities::may_be_over(ComponelIndex index) const {
  const Block& block = *automaton_[index].block();
  const bool may_be_dropped = !block.precondition.empty();
  return reaches(index, AskedState::kEnded) || may_be_dropped || may_hold({index, Side::kExit});
}

}  // namespace skein::interaction
