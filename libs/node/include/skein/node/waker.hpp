// SPDX-License-Identifier: Apache-2.0
// Waiting of a daemon's one loop: for a notice from another thread, a signal, or a time.
#pragma once

#include <optional>

#include "skein/foundation/time.hpp"

namespace skein::node {

/// Waits for notices and for SIGINT, SIGTERM, SIGHUP and SIGCHLD. It blocks these signals in the
/// calling thread and in threads made later, so make it before any other thread starts. SIGHUP only
/// ends a wait: a terminal that is closed does not stop what flies. Thread rule: notify() from any
/// thread, also from a middleware's callback; it does not block.
class Waker {
 public:
  Waker();
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;
  ~Waker();

  void notify() noexcept;
  /// Returns at once if there was a notice since the last wait; otherwise at the first notice or
  /// signal (SIGCHLD and SIGHUP too), or after `timeout` (none: no limit).
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
