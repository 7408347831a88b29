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
  log_.add({.write = Undo::Write::kWeight, .id = k, .value = old});
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
  trees_.is_cause_of(node, kNone, bound);
  trees_.mark_gathered_stale(bound, log_);
  trees_.write(arcs_, node, bound, {value, kNone, node}, log_);
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
      if (trees_.at(node, bound).cause == k) reset_tree(node, bound);
    }
  }
  weakened_.clear();
  for (const Pending& p : pending()) queue_constraint(p.constraint, p.bound);
}

void Propagation::reset_tree(NodeIndex root, Bound bound) {
  const std::vector<NodeIndex>& tree = trees_.tree(root, bound);
  for (const NodeIndex node : tree) {
    trees_.write(arcs_, node, bound, {}, log_);
    resets_.push_back({node, bound});
  }
  for (const NodeIndex node : tree) revise_again(node, bound);
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
  CauseTrees::State& state = trees_.at(node, bound);
  bool& flag = anchored(state.value) ? state.queued : state.deferred;
  if (flag) return;
  flag = true;
  (anchored(state.value) ? queue_ : deferred_).push({node, bound, true});
}

void Propagation::queue_constraint(Constraint k, Bound bound) {
  const bool tied = anchored(trees_.at(arcs_.source(k, bound), bound).value);
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
    trees_.at(item.id, item.bound).queued = false;
    if (anchored(trees_.at(item.id, item.bound).value)) revise_from(item.id, item.bound);
  } else if (anchored(trees_.at(arcs_.source(item.id, item.bound), item.bound).value)) {
    revise(item.id, item.bound);
  } else {
    deferred_.push(item);
  }
}

/// By now every node that can be tied to the origin is, and its constraints were revised then.
void Propagation::process_deferred(Item item) {
  const NodeIndex node = item.is_node ? item.id : arcs_.source(item.id, item.bound);
  const bool tied = anchored(trees_.at(node, item.bound).value);
  if (item.is_node) trees_.at(node, item.bound).deferred = false;
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
  if (arcs_.weight(k) == kMinusInfinite) return pending_.remove(k, bound, log_);
  const CauseTrees::State& from = trees_.at(arcs_.source(k, bound), bound);
  if (from.stale || imported_[node]) return;
  ++checks_;
  const Ticks candidate = from.value + arcs_.weight(k);
  if (candidate <= trees_.at(node, bound).value) return pending_.remove(k, bound, log_);
  const Ticks offset = anchored(from.value) ? candidate : candidate - kFloating;
  overflowed_ = overflowed_ || offset > kLargest || offset < -kLargest;
  if (offset < -kLargest) return;
  if (offset > kLargest || impossible(k, bound, candidate)) return pending_.add(k, bound, log_);
  pending_.remove(k, bound, log_);
  raise(k, bound, candidate);
}

bool Propagation::impossible(Constraint k, Bound bound, Ticks candidate) {
  const NodeIndex node = arcs_.target(k, bound);
  if (node == 0) return true;
  const Ticks other = trees_.at(node, opposite(bound)).value;
  if (anchored(candidate) && anchored(other) && candidate + other > 0) return true;
  const NodeIndex root = trees_.at(arcs_.source(k, bound), bound).root;
  if (root != kNone) {
    const auto& trail = trails_[2 * root + side(bound)];
    if (std::find(trail.begin(), trail.end(), node) != trail.end()) return true;
  }
  return trees_.is_cause_of(node, arcs_.source(k, bound), bound);
}

/// Follows `impossible`, whose last test gathered the effects of the target.
void Propagation::raise(Constraint k, Bound bound, Ticks value) {
  trees_.mark_gathered_stale(bound, log_);
  const NodeIndex node = arcs_.target(k, bound);
  const NodeIndex root = trees_.at(arcs_.source(k, bound), bound).root;
  trees_.write(arcs_, node, bound, {value, k, root}, log_);
  queue_node(node, bound);
}

}  // namespace skein::temporal
