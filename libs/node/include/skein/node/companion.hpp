// SPDX-License-Identifier: Apache-2.0
// The port for an operator console inside the process of a node's daemon.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/journal/record.hpp"

namespace skein::node {

/// Time and clock phase of the daemon.
struct DaemonState {
  blackboard::Now now;
  double rate = 1;  ///< mission seconds per second
  wire::ClockPhase phase = wire::ClockPhase::kHolding;
};

/// Observes the samples that the node receives, sends (once for each addressee) and publishes, and
/// its records; and sends samples to the node as a member of the roster would over the world
/// channel. Thread rule: all calls come from the daemon's thread, and must not block; `wake` may be
/// called from any thread.
class Companion {
 public:
  Companion() = default;
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  virtual ~Companion() = default;

  /// Called once, before everything else. `wake` makes the daemon call take() soon.
  virtual void attach(std::function<void()> wake) = 0;
  /// Called once, at the end; `wake` must not be called after it.
  virtual void detach() = 0;
  /// Name of the roster's member as which the companion sends.
  virtual std::string speaks_as() const = 0;
  /// The samples to be sent since the last call; of the headers only the instance is filled in.
  virtual std::vector<wire::Sample> take() = 0;
  virtual void sees(const wire::Sample& sample) = 0;
  virtual void sees(const journal::Record& record) = 0;
  /// At the end of each turn of the daemon's loop.
  virtual void turn(const DaemonState& state) = 0;
};

}  // namespace skein::node
