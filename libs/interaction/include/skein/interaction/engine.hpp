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
/// or out (not activated, or over). An input changes states or adds messages; then cycles of
///   1. exits of BI: what is true is read, the block is aborted and never activated;
///   2. exits of BA, not of who is leaving: read; a loop whose true literals all say continue
///      begins anew, every other block is deactivated;
///   3. preconditions of BI: true: read, activated; never to be true: aborted
/// until one changes nothing. Each step goes through the blocks that are there when it begins, in
/// document order; a condition sees all that was done before it is looked at.
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
/// Laws: no block is active outside an active parent; what is activated comes to an end as soon as
/// its tasks and actions do; what is interrupted is told; same inputs, same effects.
/// A loop that begins anew 1,000 times at one instant aborts the model.
/// Cost: an input costs in proportion to the conditions that name what it changes and to the
/// componels that change, with logarithmic look-ups; never to the automaton's size.
/// Thread rule: one thread at a time.
/// Source: T V.4.2, figures V.8 and V.9, spec 7.2, 7.8.
class Engine {
 public:
  explicit Engine(std::shared_ptr<const Automaton> automaton);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// Instants up to and at `now` that conditions wait for pass first, in order, each with cycles of
  /// its own; then the input. Refused, without any effect: a `now` before the last one, a second
  /// start, a status of what is no task or action of the automaton. After the end of the model
  /// everything else is accepted and changes nothing.
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
