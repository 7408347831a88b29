// SPDX-License-Identifier: Apache-2.0
// Dynamic controllability kept up to date while bounds change one by one.
#pragma once

#include <memory>

#include "skein/temporal/stnu_controllability.hpp"

namespace skein::temporal {

/// Keeps a schedule of the best case and, for each contingent link, the distances to its end; a
/// change recomputes what depends on it. The nodes and the ends of links are fixed; an arc may be
/// opened to
/// (-∞, ∞). Memory: about 8·k·n bytes beside the network.
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

  /// Gives a contingent link new bounds. Cost: a check from scratch.
  Result<DcResult, StnuError> change_contingent(std::uint32_t link, Ticks min, Ticks max);

  const Stnu& network() const;
  const DcResult& result() const;

 private:
  class State;
  explicit IncrementalDc(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace skein::temporal
