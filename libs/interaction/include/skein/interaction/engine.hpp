// SPDX-License-Identifier: Apache-2.0
// The processing engine of a role's execution automaton.
#pragma once

#include <memory>
#include <optional>

#include "skein/foundation/result.hpp"
#include "skein/foundation/time.hpp"
#include "skein/interaction/automaton.hpp"
#include "skein/interaction/effect.hpp"
#include "skein/interaction/input.hpp"

namespace skein::interaction {

/// Runs one automaton once. Blocks are inactive (BI: scheduled), active (BA: running or aborting)
/// or out (not activated, or over). An input changes states or adds messages; then the engine
/// cycles through three steps until a cycle changes nothing:
///   1. exits of blocks in BI: if true, its messages are read and the block is aborted;
///   2. exits of blocks in BA that are not leaving: if true, its messages are read; a loop whose
///      true literals all have the effect kContinue begins anew, other blocks are deactivated;
///   3. preconditions of blocks in BI: if true, its messages are read and the block is activated;
///      if it can never be true, the block is aborted.
/// Each step visits the blocks that are in BI or BA when it begins, in document order; a condition
/// is evaluated on the state at its turn.
///
///   from                on                                            to
///   (new)               its parent is activated                       scheduled
///   scheduled (block)   precondition                                  running
///   scheduled (block)   exit, impossible precondition, parent leaves  aborted
///   scheduled (other)   status                                        running, ended, aborted
///   running (other)     status                                        ended, aborted
///   running             parent leaves; of blocks also exit            aborting
///   running (plan)      content over, end of an immediate block       ended
///   aborting            status; of blocks: content over               aborted
///
/// Laws: no block is active outside an active parent; an activated block is over as soon as its
/// tasks and actions are, if it is left; every interruption is an effect; same inputs, same
/// effects. A loop that begins anew 1,000 times at one instant aborts the model. Cost of an input:
/// proportional to the componels that change and to the conditions on them, with logarithmic
/// look-ups; independent of the automaton's size. Thread rule: one thread at a time. Source: T
/// V.4.2, figures V.8 and V.9, spec 7.2, 7.8.
class Engine {
 public:
  /// Precondition: no condition names its seconds any more (with_times()).
  explicit Engine(std::shared_ptr<const Automaton> automaton);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// Handles the instants up to and including `now` that conditions wait for, in order, each with
  /// its own cycles; then the input. Errors, without any effect: a `now` before the last one, a
  /// second Start, a Status for a componel that is not a task or action. After the end of the model
  /// all other inputs are accepted and change nothing.
  Result<Effects, Failure> handle(const Input& input, MissionTime now);

  /// The next instant that a condition of a block waits for; call handle(Tick{}, …) then.
  std::optional<MissionTime> next_wakeup() const;

  ComponelState state(ComponelIndex componel) const;
  bool is_over() const;
  const Automaton& automaton() const;

 private:
  class Core;
  std::unique_ptr<Core> core_;
};

}  // namespace skein::interaction
