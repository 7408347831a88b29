// SPDX-License-Identifier: Apache-2.0
// Somebody in the process of a node's daemon: a console.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/journal/record.hpp"

namespace skein::node {

/// Where the daemon stands.
struct DaemonState {
  blackboard::Now now;
  double rate = 1;  ///< mission seconds per second
  wire::ClockPhase phase = wire::ClockPhase::kHolding;
};

/// Sees what a node is given, sends (once for each addressee) and publishes, and speaks to it as
/// one member of the roster would over the world channel. Thread rule: all calls come from the
/// daemon's thread, which must not be held up; `wake` may be called from any.
class Companion {
 public:
  Companion() = default;
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  virtual ~Companion() = default;

  /// Once, before everything else: `wake` makes the daemon take soon.
  virtual void attach(std::function<void()> wake) = 0;
  /// Once, at the end; `wake` must not be called after it.
  virtual void detach() = 0;
  /// Who speaks: a name of the roster.
  virtual std::string speaks_as() const = 0;
  /// What it says, with the instance of the header filled in.
  virtual std::vector<wire::Sample> take() = 0;
  virtual void sees(const wire::Sample& sample) = 0;
  virtual void sees(const journal::Record& record) = 0;
  /// At the end of each turn of the daemon's loop.
  virtual void turn(const DaemonState& state) = 0;
};

}  // namespace skein::node
