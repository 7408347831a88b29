// SPDX-License-Identifier: Apache-2.0
// The static indices of an automaton for its engine: which formulas depend on what.
#pragma once

#include <array>
#include <string>
#include <unordered_map>
#include <vector>

#include "skein/interaction/automaton.hpp"

namespace skein::interaction {

/// Which of the two formulas of a block.
enum class Side : std::uint8_t { kPrecondition, kExit };

inline const Formula& formula_of(const Block& block, Side side) {
  return side == Side::kPrecondition ? block.precondition : block.exit;
}

/// A formula of a block, to be evaluated again when one of its inputs changes.
struct Watch {
  ComponelIndex block = 0;
  Side side = Side::kPrecondition;
};

/// A literal about time: the instant it waits for is known, or follows an event.
struct Timer {
  Watch watch;
  TimeIs is;
};

/// The static part of an engine, made once for an automaton.
class Compiled {
 public:
  explicit Compiled(const Automaton& automaton);

  /// Formulas with literals on the state of a componel.
  const std::vector<Watch>& state_watches(ComponelIndex componel) const {
    return of_[componel].states;
  }
  /// Indices of timers that wait for an event of a componel.
  const std::vector<std::size_t>& event_timers(ComponelIndex componel) const {
    return of_[componel].event_timers;
  }
  const std::vector<Timer>& timers() const { return timers_; }
  /// Indices of the timers of a block's formula.
  const std::vector<std::size_t>& timers_of(Watch watch) const {
    return of_[watch.block].timers[static_cast<std::size_t>(watch.side)];
  }
  /// Blocks that have a formula naming the message, each once, in document order.
  const std::vector<ComponelIndex>& listeners(const std::string& message) const {
    return blocks_in(listeners_, message);
  }
  /// Blocks in which the SCM holds, in document order.
  const std::vector<ComponelIndex>& scm_blocks(const std::string& scm) const {
    return blocks_in(scm_blocks_, scm);
  }

 private:
  using ByName = std::unordered_map<std::string, std::vector<ComponelIndex>>;
  static const std::vector<ComponelIndex>& blocks_in(const ByName& by, const std::string& name);
  void compile(Watch watch, const Formula& formula);

  struct PerComponel {
    std::vector<Watch> states;
    std::vector<std::size_t> event_timers;
    std::array<std::vector<std::size_t>, 2> timers;
  };
  std::vector<PerComponel> of_;
  std::vector<Timer> timers_;
  ByName listeners_, scm_blocks_;
};

}  // namespace skein::interaction
