// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a flag that the program polls.
#pragma once

#include <csignal>

namespace skein::run_tool {

/// While a guard exists, SIGINT (Ctrl-C), termination requests and the loss of the terminal
/// (SIGHUP, unless it is ignored already) only set a flag. At most one guard at a time.
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
  struct sigaction old_hang_up_ {};
};

}  // namespace skein::run_tool
