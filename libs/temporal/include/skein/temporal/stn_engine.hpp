// SPDX-License-Identifier: Apache-2.0
// The dynamic simple temporal network: incremental contraction and relaxation, undo, explanations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/network.hpp"

namespace skein::temporal {

/// Which bound of a node or of an arc: LB (earliest date, min) or UB (latest date, max).
enum class Bound : std::uint8_t { kLower, kUpper };

/// Names an arc for as long as it is in the network; the number of a removed arc is used again. The
/// arcs of `StnEngine::make` are numbered by their position in `Stn::arcs`.
using ArcId = std::uint32_t;

enum class StnError : std::uint8_t {
  kUnknownNode,
  kUnknownArc,
  kArcGivenTwice,  ///< the same (from, to) as an arc already there: change that one instead
  kArcToItself,    ///< from = to
  kEmptyInterval,  ///< min > max, min = +∞ or max = -∞
  kOverflow,       ///< a finite bound, or a date that follows, is beyond ±kLargest
};

/// Why a call was refused; the network is then as it was before.
struct StnRefusal {
  StnError error = StnError::kUnknownNode;
  std::uint32_t where =
      0;  ///< the node (kUnknownNode), else the arc: its id or position in the call
  bool operator==(const StnRefusal&) const = default;
};
std::string to_text(StnError error);

/// New bounds of an arc, both at once.
struct ArcBounds {
  ArcId arc = 0;
  Ticks min = kMinusInfinite;
  Ticks max = kInfinite;
  bool operator==(const ArcBounds&) const = default;
};

/// A bound of a node and its new value: its earliest date (kMinusInfinite: none) for kLower, its
/// latest (kInfinite: none) for kUpper.
struct BoundChange {
  NodeIndex node = 0;
  Bound bound = Bound::kLower;
  Ticks value = 0;
  bool operator==(const BoundChange&) const = default;
};

/// One constraint of a negative cycle: the arc crossed forward by its min, or backward by its max.
struct ConflictArc {
  ArcId arc = 0;
  Bound bound = Bound::kLower;
  bool operator==(const ConflictArc&) const = default;
};

class Propagation;

/// A simple temporal network kept propagated under changes.
///
/// Laws. After every call: `consistent()` iff the network has a solution; if so, earliest(v) and
/// latest(v) are the least and the greatest date of v over all solutions. While it is inconsistent
/// the dates are only an aid (what could be applied), and the constraints that could not be are
/// pending: the network recovers by itself once a relaxation frees them. A refused call changes
/// nothing. Nodes that no chain of finite bounds ties to the origin have infinite dates, yet a
/// negative cycle among them is found.
/// Cost. A change costs what it revises, whatever the size of the network; a date costs O(1).
/// Memory: `memory_bytes()`, well under 200 bytes per arc. A value type: a copy is independent.
/// Thread rule: not safe to share. Source: M 2.1, spec 5.1.
class StnEngine {
 public:
  /// Builds and propagates. Errors: every StnError but kUnknownArc.
  static Result<StnEngine, StnRefusal> make(const Stn& network);
  /// A network of the origin (node 0) only.
  StnEngine();
  StnEngine(const StnEngine& other);
  StnEngine(StnEngine&& other) noexcept;
  StnEngine& operator=(const StnEngine& other);
  StnEngine& operator=(StnEngine&& other) noexcept;
  ~StnEngine();

  NodeIndex add_node();
  Result<ArcId, StnRefusal> add_arc(const Arc& arc);
  /// Absent: done. Any mixture of contraction and relaxation.
  std::optional<StnRefusal> set_arc(const ArcBounds& bounds);
  /// All of them as one change; the last wins when an arc comes twice.
  std::optional<StnRefusal> set_arcs(std::span<const ArcBounds> bounds);
  std::optional<StnRefusal> remove_arc(ArcId arc);

  bool consistent() const;
  /// kMinusInfinite when nothing bounds it. Precondition: node < node_count().
  Ticks earliest(NodeIndex node) const;
  /// kInfinite when nothing bounds it. Precondition: node < node_count().
  Ticks latest(NodeIndex node) const;
  /// The bounds changed by the last call that was not refused (an undo included), in the order of
  /// their first change.
  const std::vector<BoundChange>& changes() const;
  /// A negative cycle of the network, in order; each node is on it once. Empty iff consistent.
  /// Cost: the length of the chains of causes; a full Bellman–Ford when these no longer witness it.
  std::vector<ConflictArc> conflict() const;

  /// Absent for an arc that does not exist.
  std::optional<Arc> arc(ArcId arc) const;
  /// The arc from one node to another, if there is one. Cost: the smaller of their degrees.
  std::optional<ArcId> find_arc(NodeIndex from, NodeIndex to) const;
  std::size_t node_count() const;
  std::size_t arc_count() const;

  /// Begins a tentative change; may be nested.
  void checkpoint();
  /// Undoes everything since the last checkpoint, at the cost of what it had changed.
  /// Precondition: a checkpoint is open.
  void rollback();
  /// Keeps everything since the last checkpoint. Precondition: a checkpoint is open.
  void commit();

  /// Evaluations of one difference constraint in one bound system, since construction.
  std::uint64_t checks() const;
  /// What the network holds in memory [bytes].
  std::size_t memory_bytes() const;

 private:
  NodeIndex inner(NodeIndex node) const;
  std::optional<StnError> check(const Arc& arc) const;
  std::optional<StnRefusal> finish(std::uint32_t where);
  void publish();

  std::unique_ptr<Propagation> core_;
  NodeIndex origin_ = 0;  ///< the core's origin is its node 0: the two are exchanged
  std::vector<BoundChange> changes_;
};

}  // namespace skein::temporal
