// SPDX-License-Identifier: Apache-2.0
// The structure of a propagated network, what is asked of it, and the undo log.
#include <utility>

#include "propagation.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::temporal {

Propagation::Propagation(bool literal_upper_test) : literal_upper_test_(literal_upper_test) {
  add_node();
  for (const Bound bound : kBounds) at(0, bound).value = 0;
}

NodeIndex Propagation::add_node(bool imported) {
  const auto node = static_cast<NodeIndex>(node_count());
  first_.push_back(kNone);
  imported_.push_back(imported);
  states_.resize(states_.size() + 2);
  if (imported) trails_.resize(states_.size());
  log({Write::kNodeAdded, Bound::kLower, false, node, 0, kNone, kNone});
  return node;
}

ArcId Propagation::add_arc(const Arc& arc) {
  auto id = static_cast<ArcId>(arc_slots());
  if (free_arcs_.empty()) {
    ends_.resize(ends_.size() + 2);
    weights_.resize(weights_.size() + 2, kMinusInfinite);
    pending_at_.resize(pending_at_.size() + 4, kNone);
  } else {
    id = free_arcs_.back();
    free_arcs_.pop_back();
  }
  link_arc(id, arc.from, arc.to);
  log({Write::kArcAdded, Bound::kLower, false, id, 0, kNone, kNone});
  for (const Constraint k : {2 * id, 2 * id + 1}) {
    weights_[k] = k == 2 * id ? weight_of_min(arc.min) : weight_of_max(arc.max);
    for (const Bound bound : kBounds) queue_constraint(k, bound);
  }
  return id;
}

void Propagation::remove_arc(ArcId id) {
  log({Write::kArcRemoved, Bound::kLower, false, id, 0, ends_[2 * id].node,
       ends_[2 * id + 1].node});
  unlink_arc(id);
  free_arcs_.push_back(id);
}

void Propagation::link_arc(ArcId id, NodeIndex from, NodeIndex to) {
  link_end(2 * id, from);
  link_end(2 * id + 1, to);
}

void Propagation::unlink_arc(ArcId id) {
  unlink_end(2 * id);
  unlink_end(2 * id + 1);
}

void Propagation::link_end(std::uint32_t end, NodeIndex node) {
  ends_[end] = {node, first_[node], kNone};
  if (first_[node] != kNone) ends_[first_[node]].previous = end;
  first_[node] = end;
}

void Propagation::unlink_end(std::uint32_t end) {
  const End old = ends_[end];
  (old.previous != kNone ? ends_[old.previous].next : first_[old.node]) = old.next;
  if (old.next != kNone) ends_[old.next].previous = old.previous;
  ends_[end] = {};
}

Arc Propagation::arc(ArcId id) const {
  const Ticks minus_max = weights_[2 * id + 1];
  return {ends_[2 * id].node, ends_[2 * id + 1].node, weights_[2 * id],
          minus_max == kMinusInfinite ? kInfinite : -minus_max};
}

std::optional<ArcId> Propagation::find_arc(NodeIndex from, NodeIndex to) const {
  std::uint32_t out = first_[from];
  std::uint32_t in = first_[to];
  for (; out != kNone && in != kNone; out = ends_[out].next, in = ends_[in].next) {
    if ((out & 1) == 0 && ends_[out ^ 1].node == to) return out / 2;
    if ((in & 1) == 1 && ends_[in ^ 1].node == from) return in / 2;
  }
  return std::nullopt;
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
  fit(first_, states_, ends_, weights_, pending_at_, pending_, changed_, effects_);
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
      weights_[undo.id] = undo.value;
      return;
    case Write::kPendingAdded:
      return remove_pending(undo.id, undo.bound);
    case Write::kPendingRemoved:
      return add_pending(undo.id, undo.bound);
    case Write::kNodeAdded:
      first_.pop_back();
      imported_.pop_back();
      states_.resize(states_.size() - 2);
      return;
    case Write::kArcAdded:
      unlink_arc(undo.id);
      weights_[2 * undo.id] = weights_[2 * undo.id + 1] = kMinusInfinite;
      free_arcs_.push_back(undo.id);
      return;
    case Write::kArcRemoved:
      SKEIN_ENSURES(free_arcs_.back() == undo.id);
      free_arcs_.pop_back();
      link_arc(undo.id, undo.cause, undo.root);
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
  return sizeof(*this) + bytes(first_) + imported_.capacity() / 8 + bytes(states_) + bytes(ends_) +
         bytes(weights_) + bytes(pending_at_) + bytes(free_arcs_) + bytes(pending_) + trails +
         queue_.memory_bytes() + deferred_.memory_bytes() + bytes(weakened_) + bytes(resets_) +
         bytes(changed_) + bytes(effects_) + bytes(log_);
}

}  // namespace skein::temporal
