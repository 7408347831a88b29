// SPDX-License-Identifier: Apache-2.0
// Reachability of the states of an automaton's componels.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compiled.hpp"
#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// An over-approximation: states that are unreachable here are truly unreachable.
class Possibilities {
 public:
  /// With `staying`, a block: only states before that block, or one around it, is left.
  explicit Possibilities(const Automaton& automaton,
                         std::optional<ComponelIndex> staying = std::nullopt);

  bool reaches(ComponelIndex componel, AskedState state) const {
    return reached_[componel][static_cast<std::size_t>(state)];
  }
  /// Whether the literal may be true in this formula of this block.
  bool may_hold(const Literal& literal, Watch where) const;
  /// Whether all clauses may be true together. An empty formula as its kind says.
  bool may_hold(Watch where) const;
  const Formula& formula(Watch where) const;

 private:
  bool may_hold(const ComponelIs& is, bool negated, Watch where) const;
  bool contradicts_itself(const Formula& formula) const;
  bool grow();
  bool grow_block(ComponelIndex index);
  bool may_end(ComponelIndex plan) const;
  bool may_be_over(ComponelIndex block) const;
  void note_staying(ComponelIndex block);
  bool reach(ComponelIndex componel, AskedState state);

  const Automaton& automaton_;
  std::vector<std::array<bool, 6>> reached_;
  std::vector<bool> stays_;  ///< of each componel: it is not left
};

}  // namespace skein::interaction
