// SPDX-License-Identifier: Apache-2.0
// Revision and relaxation. The structure of the network and the undo log are in
// propagation_log.cpp.
#include "propagation.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

std::optional<StnError> check_interval(Ticks min, Ticks max) {
  if (min > max || min == kInfinite || max == kMinusInfinite) return StnError::kEmptyInterval;
  if (min != kMinusInfinite && (min < -kLargest || min > kLargest)) return StnError::kOverflow;
  if (max != kInfinite && (max < -kLargest || max > kLargest)) return StnError::kOverflow;
  return std::nullopt;
}

void Propagation::set_bounds(const ArcBounds& bounds) {
  set_weight(2 * bounds.arc, weight_of_min(bounds.min));
  set_weight(2 * bounds.arc + 1, weight_of_max(bounds.max));
}

void Propagation::set_weight(Constraint k, Ticks weight) {
  const Ticks old = arcs_.weight(k);
  if (weight == old) return;
  log({Write::kWeight, Bound::kLower, false, k, old, kNone, kNone});
  arcs_.set_weight(k, weight);
  const bool reversed = literal_upper_test_ && (k & 1) != 0;
  if ((weight < old) != reversed) {
    weakened_.push_back(k);
  } else {
    for (const Bound bound : kBounds) queue_constraint(k, bound);
  }
}

void Propagation::set_import(NodeIndex node, Bound bound, Ticks value,
                             std::vector<NodeIndex> trail) {
  SKEIN_EXPECTS(imported_[node]);
  effects_.clear();
  append_effects(node, bound, true);
  for (std::size_t i = 0; i < effects_.size(); ++i) append_effects(effects_[i], bound, true);
  mark_effects_stale(bound);
  write_state(node, bound, value, kNone, node);
  trails_[2 * node + side(bound)] = std::move(trail);
  queue_node(node, bound);
}

void Propagation::drop_import(NodeIndex node, Bound bound) {
  SKEIN_EXPECTS(imported_[node]);
  reset_tree(node, bound);
  trails_[2 * node + side(bound)].clear();
}

void Propagation::relax() {
  if (weakened_.empty() && resets_.empty()) return;
  for (const Constraint k : weakened_) {
    for (const Bound bound : kBounds) {
      const NodeIndex node = arcs_.target(k, bound);
      if (at(node, bound).cause == k) reset_tree(node, bound);
    }
  }
  weakened_.clear();
  for (const Pending& p : pending_) queue_constraint(p.constraint, p.bound);
}

void Propagation::reset_tree(NodeIndex root, Bound bound) {
  effects_.assign(1, root);
  for (std::size_t i = 0; i < effects_.size(); ++i) append_effects(effects_[i], bound, false);
  for (const NodeIndex node : effects_) {
    write_state(node, bound, kFloating, kNone, kNone);
    resets_.push_back({node, bound});
  }
  for (const NodeIndex node : effects_) revise_again(node, bound);
}

/// What holds of a node that was reset is to be found again from all its neighbours; what it says
/// to them matters only if it stays without a tie to the origin.
void Propagation::revise_again(NodeIndex node, Bound bound) {
  if (!imported_[node]) {
    arcs_.each_end(node,
                   [&](std::uint32_t end) { queue_constraint(end ^ side(bound) ^ 1, bound); });
  }
  queue_node(node, bound);
}

void Propagation::queue_node(NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  bool& flag = anchored(state.value) ? state.queued : state.deferred;
  if (flag) return;
  flag = true;
  (anchored(state.value) ? queue_ : deferred_).push({node, bound, true});
}

void Propagation::queue_constraint(Constraint k, Bound bound) {
  const bool tied = anchored(at(arcs_.source(k, bound), bound).value);
  (tied ? queue_ : deferred_).push({k, bound, false});
}

Propagation::Item Propagation::Queue::pop() {
  const Item item = items_[head_++];
  if (empty()) {
    items_.clear();
    head_ = 0;
  } else if (head_ >= kLeastDropped && 2 * head_ >= items_.size()) {
    items_.erase(items_.begin(), items_.begin() + static_cast<std::ptrdiff_t>(head_));
    head_ = 0;
  }
  return item;
}

void Propagation::propagate() {
  overflowed_ = false;
  while (true) {
    if (!queue_.empty()) {
      process(queue_.pop());
    } else if (!deferred_.empty()) {
      process_deferred(deferred_.pop());
    } else {
      return;
    }
  }
}

void Propagation::process(Item item) {
  if (item.is_node) {
    at(item.id, item.bound).queued = false;
    if (anchored(at(item.id, item.bound).value)) revise_from(item.id, item.bound);
  } else if (anchored(at(arcs_.source(item.id, item.bound), item.bound).value)) {
    revise(item.id, item.bound);
  } else {
    deferred_.push(item);
  }
}

/// By now every node that can be tied to the origin is, and its constraints were revised then.
void Propagation::process_deferred(Item item) {
  const NodeIndex node = item.is_node ? item.id : arcs_.source(item.id, item.bound);
  const bool tied = anchored(at(node, item.bound).value);
  if (item.is_node) at(node, item.bound).deferred = false;
  if (tied) return;
  if (item.is_node) {
    revise_from(node, item.bound);
  } else {
    revise(item.id, item.bound);
  }
}

void Propagation::revise_from(NodeIndex node, Bound bound) {
  arcs_.each_end(node, [&](std::uint32_t end) { revise(end ^ side(bound), bound); });
}

void Propagation::revise(Constraint k, Bound bound) {
  const NodeIndex node = arcs_.target(k, bound);
  if (arcs_.weight(k) == kMinusInfinite) return remove_pending(k, bound);
  const State& from = at(arcs_.source(k, bound), bound);
  if (from.stale || imported_[node]) return;
  ++checks_;
  const Ticks candidate = from.value + arcs_.weight(k);
  if (candidate <= at(node, bound).value) return remove_pending(k, bound);
  const Ticks offset = anchored(from.value) ? candidate : candidate - kFloating;
  overflowed_ = overflowed_ || offset > kLargest || offset < -kLargest;
  if (offset < -kLargest) return;
  if (offset > kLargest || impossible(k, bound, candidate)) return add_pending(k, bound);
  remove_pending(k, bound);
  raise(k, bound, candidate);
}

bool Propagation::impossible(Constraint k, Bound bound, Ticks candidate) {
  const NodeIndex node = arcs_.target(k, bound);
  if (node == 0) return true;
  const Ticks other = at(node, opposite(bound)).value;
  if (anchored(candidate) && anchored(other) && candidate + other > 0) return true;
  const NodeIndex root = at(arcs_.source(k, bound), bound).root;
  if (root != kNone) {
    const auto& trail = trails_[2 * root + side(bound)];
    if (std::find(trail.begin(), trail.end(), node) != trail.end()) return true;
  }
  return is_cause_of(node, arcs_.source(k, bound), bound);
}

bool Propagation::is_cause_of(NodeIndex node, NodeIndex effect, Bound bound) {
  effects_.clear();
  append_effects(node, bound, true);
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    if (effects_[i] == effect) return true;
    append_effects(effects_[i], bound, true);
  }
  return false;
}

void Propagation::append_effects(NodeIndex node, Bound bound, bool fresh_only) {
  const State& state = at(node, bound);
  if (fresh_only && state.stale) return;
  for (NodeIndex child = state.child; child != kNone; child = at(child, bound).next) {
    if (!fresh_only || !at(child, bound).stale) effects_.push_back(child);
  }
}

void Propagation::mark_effects_stale(Bound bound) {
  for (const NodeIndex node : effects_) {
    at(node, bound).stale = true;
    log({Write::kStale, bound, false, node, 0, kNone, kNone});
  }
}

/// Follows `impossible`, whose last test left the effects of the target in effects_.
void Propagation::raise(Constraint k, Bound bound, Ticks value) {
  mark_effects_stale(bound);
  const NodeIndex node = arcs_.target(k, bound);
  write_state(node, bound, value, k, at(arcs_.source(k, bound), bound).root);
  queue_node(node, bound);
}

void Propagation::write_state(NodeIndex node, Bound bound, Ticks value, Constraint cause,
                              NodeIndex root) {
  State& state = at(node, bound);
  log({Write::kState, bound, state.stale, node, state.value, state.cause, state.root});
  note_change(node, bound);
  if (state.cause != kNone) unlink_effect(node, bound);
  state.value = value;
  state.cause = cause;
  state.root = root;
  state.stale = false;
  if (cause != kNone) link_effect(node, bound);
}

void Propagation::link_effect(NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  State& parent = at(arcs_.source(state.cause, bound), bound);
  state.previous = kNone;
  state.next = parent.child;
  if (parent.child != kNone) at(parent.child, bound).previous = node;
  parent.child = node;
}

void Propagation::unlink_effect(NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  if (state.previous != kNone) {
    at(state.previous, bound).next = state.next;
  } else {
    at(arcs_.source(state.cause, bound), bound).child = state.next;
  }
  if (state.next != kNone) at(state.next, bound).previous = state.previous;
}

void Propagation::note_change(NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  if (state.changed) return;
  state.changed = true;
  changed_.push_back({2 * node + side(bound), state.value});
}

void Propagation::add_pending(Constraint k, Bound bound) {
  if (is_pending(k, bound)) return;
  log({Write::kPendingAdded, bound, false, k, 0, kNone, kNone});
  pending_at_[2 * k + side(bound)] = static_cast<std::uint32_t>(pending_.size());
  pending_.push_back({k, bound});
}

void Propagation::remove_pending(Constraint k, Bound bound) {
  const std::uint32_t place = pending_at_[2 * k + side(bound)];
  if (place == kNone) return;
  log({Write::kPendingRemoved, bound, false, k, 0, kNone, kNone});
  const Pending last = pending_.back();
  pending_[place] = last;
  pending_at_[2 * last.constraint + side(last.bound)] = place;
  pending_at_[2 * k + side(bound)] = kNone;
  pending_.pop_back();
}

}  // namespace skein::temporal
