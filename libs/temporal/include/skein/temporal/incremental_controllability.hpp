// SPDX-License-Identifier: Apache-2.0
// Dynamic controllability kept up to date while bounds, nodes and links change one by one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "skein/temporal/dispatchable_network.hpp"
#include "skein/temporal/stnu_controllability.hpp"

namespace skein::temporal {

/// Keeps a schedule of the best case and, for each contingent link, the distances to its end; a
/// change of bounds or of structure recomputes what depends on it. Memory: about 8·k·n bytes beside
/// the network.
/// Thread rule: not safe to share. Movable.
class IncrementalDc {
 public:
  /// Cost: a check from scratch.
  static Result<IncrementalDc, StnuError> create(Stnu network);
  IncrementalDc(IncrementalDc&&) noexcept;
  IncrementalDc& operator=(IncrementalDc&&) noexcept;
  ~IncrementalDc();

  /// Gives an arc new bounds; both may change at once. On an error the state is unchanged.
  /// A network that is not controllable remembers its last controllable form: later changes are
  /// worked out from there, and changes that loosen nothing of the conflict cost O(1).
  Result<DcResult, StnuError> change_arc(std::uint32_t arc, Ticks min, Ticks max);

  /// Gives a contingent link new bounds. Cost: as taking it out and putting it in again; a check
  /// from scratch when min = max before or after, or when the network is not controllable
  /// afterwards.
  Result<DcResult, StnuError> change_contingent(std::uint32_t link, Ticks min, Ticks max);

  /// Adds a node without links. A node is removed by removing its links; its index may be reused.
  NodeIndex add_node(std::string name);
  /// Adds an arc, at the position of a removed one or as the last; `placed()` has its position. On
  /// an error the state is unchanged.
  Result<DcResult, StnuError> add_arc(const Arc& arc);
  std::uint32_t placed() const;
  /// Removes an arc; it remains as an open arc, ]-∞, ∞[, until its position is reused.
  Result<DcResult, StnuError> remove_arc(std::uint32_t arc);
  /// Adds a contingent link, as the last one. Cost: a search from its end and updates of affected
  /// links; a check from scratch if the network is not controllable before or after.
  Result<DcResult, StnuError> add_contingent(const ContingentLink& link);
  /// Removes a contingent link; the last one takes its position.
  Result<DcResult, StnuError> remove_contingent(std::uint32_t link);

  /// Waits of a controllable network: nodes that come no earlier than `delay` after the activation
  /// of a contingent link, unless its end has come before (if delay > min; else in any case).
  /// Ordered by link. delay > 0. Nodes that must come after the end anyway are left out.
  std::vector<WaitEdge> waits() const;
  /// Bounds of a controllable network that follow from contingent links for any durations, and must
  /// be kept in addition to the given ones. Ordered by link.
  std::vector<DistanceEdge> implied() const;

  const Stnu& network() const;
  const DcResult& result() const;

 private:
  class State;
  explicit IncrementalDc(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace skein::temporal
