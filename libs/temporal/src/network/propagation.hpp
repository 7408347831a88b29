// SPDX-License-Identifier: Apache-2.0
// The propagation common to the engine and to the agents: two bound systems with chains of causes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "arc_table.hpp"
#include "cause_trees.hpp"
#include "pending_constraints.hpp"
#include "skein/temporal/network.hpp"
#include "skein/temporal/stn_engine.hpp"
#include "undo_log.hpp"

namespace skein::temporal {

constexpr Bound opposite(Bound bound) {
  return bound == Bound::kLower ? Bound::kUpper : Bound::kLower;
}

/// kEmptyInterval, kOverflow or nothing.
std::optional<StnError> check_interval(Ticks min, Ticks max);

/// Incremental propagation, in two phases that a caller may separate (DIP-L does): `relax()` resets
/// what followed from weakened constraints, `propagate()` revises until nothing changes.
///
/// A raise of v by a constraint from u is impossible, and the constraint goes to `pending()`, when
/// v is the origin, when the earliest date of v would pass its latest, when v is itself a cause of
/// u, or when the chain of u comes from an import whose trail contains v. The third test walks the
/// effects of v and marks them stale: they will rise too, so nothing is derived from them meanwhile
/// and no later test walks them again (Tarjan's subtree disassembly; walking up the chain of u
/// would cost its length at each raise). Callers check their arguments. Source: notes 5.2.
class Propagation {
 public:
  struct BoundRef {
    NodeIndex node;
    Bound bound;
  };
  using Pending = PendingConstraints::Pending;

  /// The origin only. `literal_upper_test`: erratum 1 of the paper, for mutation tests.
  explicit Propagation(bool literal_upper_test = false);

  /// An imported node is raised by `set_import` only.
  NodeIndex add_node(bool imported = false);
  /// Preconditions: the nodes exist and differ; the interval passes `check_interval`.
  ArcId add_arc(const Arc& arc);
  /// Precondition: its interval was relaxed to ]-∞, +∞[ and propagated.
  void remove_arc(ArcId arc);

  /// Sets new bounds; must be followed by `relax()`.
  void set_bounds(const ArcBounds& bounds);
  void set_import(NodeIndex node, Bound bound, Ticks value, std::vector<NodeIndex> trail);
  /// Resets an import and all that follows from it.
  void drop_import(NodeIndex node, Bound bound);
  void relax();
  void propagate();

  bool consistent() const { return pending().empty(); }
  Ticks value(NodeIndex node, Bound bound) const { return trees_.at(node, bound).value; }
  Ticks date(NodeIndex node, Bound bound) const { return to_date(bound, value(node, bound)); }
  /// The import that the chain of causes starts from, else kNone.
  NodeIndex root(NodeIndex node, Bound bound) const { return trees_.at(node, bound).root; }
  Constraint cause(NodeIndex node, Bound bound) const { return trees_.at(node, bound).cause; }
  const std::vector<Pending>& pending() const { return pending_.all(); }
  const ArcTable& arcs() const { return arcs_; }

  /// The bounds that were reset since the last call.
  std::vector<BoundRef> take_resets();
  void forget_resets() { resets_.clear(); }
  /// The bounds with a net change since the last call, in the order of their first change.
  void take_changes(std::vector<BoundChange>& changes) { trees_.take_changes(changes); }

  /// Undo. While at least one mark is open every write is logged.
  void mark() { log_.mark(); }
  void undo_to_mark();  ///< the mark stays
  void drop_mark() { log_.drop_mark(); }

  /// Whether a date passed ±kLargest in the last `propagate()`. The constraint is then pending.
  bool overflowed() const { return overflowed_; }
  std::uint64_t checks() const { return checks_; }
  std::size_t memory_bytes() const;
  /// Releases unused memory after construction.
  void shrink();

 private:
  struct Item {
    std::uint32_t id;  ///< of a constraint or of a node
    Bound bound;
    bool is_node;
  };
  /// First in, first out, on one array that is used again.
  class Queue {
   public:
    void push(Item item) { items_.push_back(item); }
    bool empty() const { return head_ == items_.size(); }
    Item pop();
    std::size_t memory_bytes() const { return items_.capacity() * sizeof(Item); }
    void shrink() { items_.shrink_to_fit(); }

   private:
    /// What was taken is dropped once it is this many and half of all, so that memory follows what
    /// waits and not what was ever put in.
    static constexpr std::size_t kLeastDropped = 1024;

    std::vector<Item> items_;
    std::size_t head_ = 0;
  };
  void set_weight(Constraint k, Ticks weight);

  void process(Item item);
  void process_deferred(Item item);
  void revise_from(NodeIndex node, Bound bound);
  void revise(Constraint k, Bound bound);
  bool impossible(Constraint k, Bound bound, Ticks candidate);
  void raise(Constraint k, Bound bound, Ticks value);
  void queue_node(NodeIndex node, Bound bound);
  void queue_constraint(Constraint k, Bound bound);

  void reset_tree(NodeIndex root, Bound bound);
  void revise_again(NodeIndex node, Bound bound);
  void undo(const Undo& undo);

  bool literal_upper_test_;
  ArcTable arcs_;
  std::vector<bool> imported_;
  CauseTrees trees_;
  PendingConstraints pending_;
  std::vector<std::vector<NodeIndex>> trails_;  ///< of each bound, when there are imports
  Queue queue_;
  Queue deferred_;  ///< from nodes not tied to the origin: they wait for the others
  std::vector<Constraint> weakened_;
  std::vector<BoundRef> resets_;
  UndoLog log_;
  std::uint64_t checks_ = 0;
  bool overflowed_ = false;
};

/// A negative cycle, from the chains of the pending constraints, else by Bellman–Ford.
std::vector<ConflictArc> find_conflict(const Propagation& network);

}  // namespace skein::temporal
