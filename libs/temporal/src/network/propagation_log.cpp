// SPDX-License-Identifier: Apache-2.0
// What is asked of a propagated network, and the undo log.
#include <utility>

#include "propagation.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

Propagation::Propagation(bool literal_upper_test) : literal_upper_test_(literal_upper_test) {
  add_node();
  for (const Bound bound : kBounds) at(0, bound).value = 0;
}

NodeIndex Propagation::add_node(bool imported) {
  const auto node = static_cast<NodeIndex>(arcs_.nodes());
  arcs_.add_node();
  imported_.push_back(imported);
  states_.resize(states_.size() + 2);
  if (imported) trails_.resize(states_.size());
  log({Write::kNodeAdded, Bound::kLower, false, node, 0, kNone, kNone});
  return node;
}

ArcId Propagation::add_arc(const Arc& arc) {
  const ArcId id = arcs_.add(arc.from, arc.to);
  pending_at_.resize(4 * arcs_.slots(), kNone);
  log({Write::kArcAdded, Bound::kLower, false, id, 0, kNone, kNone});
  for (const Constraint k : {2 * id, 2 * id + 1}) {
    arcs_.set_weight(k, k == 2 * id ? weight_of_min(arc.min) : weight_of_max(arc.max));
    for (const Bound bound : kBounds) queue_constraint(k, bound);
  }
  return id;
}

void Propagation::remove_arc(ArcId id) {
  log({Write::kArcRemoved, Bound::kLower, false, id, 0, arcs_.from(id), arcs_.to(id)});
  arcs_.remove(id);
}

std::vector<Propagation::BoundRef> Propagation::take_resets() { return std::exchange(resets_, {}); }

void Propagation::take_changes(std::vector<BoundChange>& changes) {
  changes.clear();
  for (const Changed& changed : changed_) {
    if (changed.state >= states_.size()) continue;
    states_[changed.state].changed = false;
    const Bound bound = (changed.state & 1) == 0 ? Bound::kLower : Bound::kUpper;
    const Ticks date = to_date(bound, states_[changed.state].value);
    if (date != to_date(bound, changed.old_value)) {
      changes.push_back({changed.state / 2, bound, date});
    }
  }
  changed_.clear();
}

void Propagation::shrink() {
  const auto fit = [](auto&... vectors) { (vectors.shrink_to_fit(), ...); };
  fit(states_, pending_at_, pending_, changed_, effects_);
  arcs_.shrink();
  queue_.shrink();
  deferred_.shrink();
}

void Propagation::mark() { marks_.push_back(log_.size()); }

void Propagation::drop_mark() {
  SKEIN_EXPECTS(!marks_.empty());
  marks_.pop_back();
  if (marks_.empty()) log_.clear();
}

void Propagation::undo_to_mark() {
  SKEIN_EXPECTS(!marks_.empty() && queue_.empty() && deferred_.empty());
  const std::size_t length = marks_.back();
  auto marks = std::exchange(marks_, {});  // nothing is logged meanwhile
  while (log_.size() > length) {
    const Undo last = log_.back();
    log_.pop_back();
    undo(last);
  }
  marks_ = std::move(marks);
}

void Propagation::undo(const Undo& undo) {
  switch (undo.write) {
    case Write::kState:
      return undo_state(undo);
    case Write::kStale:
      at(undo.id, undo.bound).stale = false;
      return;
    case Write::kWeight:
      arcs_.set_weight(undo.id, undo.value);
      return;
    case Write::kPendingAdded:
      return remove_pending(undo.id, undo.bound);
    case Write::kPendingRemoved:
      return add_pending(undo.id, undo.bound);
    case Write::kNodeAdded:
      arcs_.drop_node();
      imported_.pop_back();
      states_.resize(states_.size() - 2);
      return;
    case Write::kArcAdded:
      for (const Constraint k : {2 * undo.id, 2 * undo.id + 1}) arcs_.set_weight(k, kMinusInfinite);
      arcs_.remove(undo.id);
      return;
    case Write::kArcRemoved:
      arcs_.put_back(undo.id, undo.cause, undo.root);
      return;
  }
}

void Propagation::undo_state(const Undo& undo) {
  write_state(undo.id, undo.bound, undo.value, undo.cause, undo.root);
  at(undo.id, undo.bound).stale = undo.stale;
}

std::size_t Propagation::memory_bytes() const {
  const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  std::size_t trails = trails_.capacity() * sizeof(trails_[0]);
  for (const auto& trail : trails_) trails += bytes(trail);
  return sizeof(*this) + arcs_.memory_bytes() + imported_.capacity() / 8 + bytes(states_) +
         bytes(pending_at_) + bytes(pending_) + trails + queue_.memory_bytes() +
         deferred_.memory_bytes() + bytes(weakened_) + bytes(resets_) + bytes(changed_) +
         bytes(effects_) + bytes(log_);
}

}  // namespace skein::temporal
