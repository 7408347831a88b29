// SPDX-License-Identifier: Apache-2.0
// The bounds of the nodes of a network, each with the constraint that it follows from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "arc_table.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "undo_log.hpp"

namespace skein::temporal {

/// Values tied to the origin lie within ±kLargest; the others are offsets from kFloating, far
/// below, as if a virtual source were at -∞: so a cycle among nodes not tied to v0 is found too.
inline constexpr Ticks kFloating = -(Ticks{1} << 62);
constexpr bool anchored(Ticks value) { return value >= -kLargest; }
/// The date that a stored value stands for.
constexpr Ticks to_date(Bound bound, Ticks value) {
  if (!anchored(value)) return bound == Bound::kLower ? kMinusInfinite : kInfinite;
  return bound == Bound::kLower ? value : -value;
}

/// Two values for each node. A value with a cause is an effect of the value at the cause's source,
/// and so the values of one kind are trees. Those that will rise for sure are stale until they are
/// written. Notes which values have changed. The arcs are always those of one network, in which the
/// source of a cause stays what it is. Callers check their arguments.
class CauseTrees {
 public:
  struct Value {
    Ticks value = kFloating;
    Constraint cause = kNone;
    NodeIndex root = kNone;  ///< the import that the chain of causes starts from
  };
  struct State : Value {
    std::uint32_t child = kNone;  ///< first effect; the next ones are its siblings
    std::uint32_t next = kNone;
    std::uint32_t previous = kNone;
    bool stale = false;
    bool queued = false;    ///< of who propagates: it waits there
    bool deferred = false;  ///< likewise, behind those that are tied to the origin
    bool changed = false;
  };

  void add_node() { states_.resize(states_.size() + 2); }
  /// Removes the last node. Precondition: it has no effects.
  void drop_node() { states_.resize(states_.size() - 2); }

  State& at(NodeIndex node, Bound bound) { return states_[2 * node + side(bound)]; }
  const State& at(NodeIndex node, Bound bound) const { return states_[2 * node + side(bound)]; }

  /// The value follows from the cause (kNone: from nothing) from now on, and is not stale.
  void write(const ArcTable& arcs, NodeIndex node, Bound bound, const Value& value, UndoLog& log);
  /// It is as it was before the write.
  void undo(const ArcTable& arcs, const Undo& undo, UndoLog& log);

  /// Gathers the effects of a node, theirs and so on that are not stale, unless `effect` is among
  /// them: then returns true.
  bool is_cause_of(NodeIndex node, NodeIndex effect, Bound bound);
  /// Those that were gathered last become stale.
  void mark_gathered_stale(Bound bound, UndoLog& log);
  /// The node and all that follows from it, causes before their effects. Valid until the next call
  /// of this or is_cause_of().
  const std::vector<NodeIndex>& tree(NodeIndex root, Bound bound);

  /// The bounds with a net change since the last call, in the order of their first change.
  void take_changes(std::vector<BoundChange>& changes);

  std::size_t memory_bytes() const;
  void shrink();

 private:
  struct Changed {
    std::uint32_t state;
    Ticks old_value;
  };
  void append_effects(NodeIndex node, Bound bound, bool fresh_only);
  void link(const ArcTable& arcs, NodeIndex node, Bound bound);
  void unlink(const ArcTable& arcs, NodeIndex node, Bound bound);

  std::vector<State> states_;
  std::vector<Changed> changed_;
  std::vector<NodeIndex> gathered_;
};

// What a propagation does again and again.

inline void CauseTrees::link(const ArcTable& arcs, NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  State& parent = at(arcs.source(state.cause, bound), bound);
  state.previous = kNone;
  state.next = parent.child;
  if (parent.child != kNone) at(parent.child, bound).previous = node;
  parent.child = node;
}

inline void CauseTrees::unlink(const ArcTable& arcs, NodeIndex node, Bound bound) {
  State& state = at(node, bound);
  if (state.previous != kNone) {
    at(state.previous, bound).next = state.next;
  } else {
    at(arcs.source(state.cause, bound), bound).child = state.next;
  }
  if (state.next != kNone) at(state.next, bound).previous = state.previous;
}

inline void CauseTrees::write(const ArcTable& arcs, NodeIndex node, Bound bound, const Value& value,
                              UndoLog& log) {
  State& state = at(node, bound);
  log.add({Undo::Write::kState, bound, state.stale, node, state.value, state.cause, state.root});
  if (!state.changed) changed_.push_back({2 * node + side(bound), state.value});
  state.changed = true;
  if (state.cause != kNone) unlink(arcs, node, bound);
  static_cast<Value&>(state) = value;
  state.stale = false;
  if (value.cause != kNone) link(arcs, node, bound);
}

inline void CauseTrees::undo(const ArcTable& arcs, const Undo& undo, UndoLog& log) {
  write(arcs, undo.id, undo.bound, {undo.value, undo.cause, undo.root}, log);
  at(undo.id, undo.bound).stale = undo.stale;
}

inline void CauseTrees::append_effects(NodeIndex node, Bound bound, bool fresh_only) {
  const State& state = at(node, bound);
  if (fresh_only && state.stale) return;
  for (NodeIndex child = state.child; child != kNone; child = at(child, bound).next) {
    if (!fresh_only || !at(child, bound).stale) gathered_.push_back(child);
  }
}

inline bool CauseTrees::is_cause_of(NodeIndex node, NodeIndex effect, Bound bound) {
  gathered_.clear();
  append_effects(node, bound, true);
  for (std::size_t i = 0; i < gathered_.size(); ++i) {
    if (gathered_[i] == effect) return true;
    append_effects(gathered_[i], bound, true);
  }
  return false;
}

inline void CauseTrees::mark_gathered_stale(Bound bound, UndoLog& log) {
  for (const NodeIndex node : gathered_) {
    at(node, bound).stale = true;
    log.add({.write = Undo::Write::kStale, .bound = bound, .id = node});
  }
}

}  // namespace skein::temporal
