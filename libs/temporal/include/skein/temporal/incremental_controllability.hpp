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

  /// A node without links. A node goes by losing its links; it may be used again.
  NodeIndex add_node(std::string name);
  /// An arc more, in the place of one that was removed or as the last one; its position is that of
  /// `placed()`. On an error the state is unchanged.
  Result<DcResult, StnuError> add_arc(const Arc& arc);
  std::uint32_t placed() const;
  /// It stays as an open arc, ]-∞, ∞[, until its place is used again.
  Result<DcResult, StnuError> remove_arc(std::uint32_t arc);
  /// The last one of the contingent links. Cost: a search from its end and what that changes for
  /// others; a check from scratch when the network is not controllable, before or after.
  Result<DcResult, StnuError> add_contingent(const ContingentLink& link);
  /// The last one takes its position.
  Result<DcResult, StnuError> remove_contingent(std::uint32_t link);

  /// Of a controllable network, what follows from contingent links for the execution: nodes that
  /// come no earlier than `delay` after the activation of a link, unless its end has come before
  /// (when delay > min; else in any case). Ordered by link. delay > 0. Nodes that must come after
  /// the end anyway are left out.
  std::vector<WaitEdge> waits() const;
  /// Of a controllable network, what follows from contingent links whatever nature does: it has to
  /// be kept to beside what was given. Ordered by link.
  std::vector<DistanceEdge> implied() const;

  const Stnu& network() const;
  const DcResult& result() const;

 private:
  class State;
  explicit IncrementalDc(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace skein::temporal
