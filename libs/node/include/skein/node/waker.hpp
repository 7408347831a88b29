// SPDX-License-Identifier: Apache-2.0
// Waiting of a daemon's one loop: for a notice from another thread, a signal, or a time.
#pragma once

#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::node {

/// Blocks SIGINT, SIGTERM and SIGCHLD in this thread and those made after it (so make it before any
/// other thread starts) and waits for them together with notices. `notify` may be called from any
/// thread, also from a middleware's callback: it does not block.
class Waker {
 public:
  Waker();
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;
  ~Waker();

  void notify() noexcept;
  /// Returns at once if there was a notice since the last wait; else at the first of: a notice, a
  /// signal (SIGCHLD too), `timeout` (none: no limit).
  void wait(std::optional<Duration> timeout);
  /// True once SIGINT or SIGTERM has come.
  bool stop_requested() const { return stop_; }

  /// Monotonic time since some fixed origin of the machine.
  static Duration steady_now();

 private:
  int event_ = -1;
  int signal_ = -1;
  bool stop_ = false;
};

}  // namespace skein::node
