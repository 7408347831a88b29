// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as something that is asked for.
#pragma once

#include <csignal>

namespace skein::run_tool {

/// While it lives, Ctrl-C and a request to end are only remembered. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  /// Since the last guard was made.
  static bool interrupted();

 private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
};

}  // namespace skein::run_tool
