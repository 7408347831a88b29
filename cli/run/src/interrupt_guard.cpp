// SPDX-License-Identifier: Apache-2.0
#include "skein/run_tool/interrupt_guard.hpp"

#include <atomic>

namespace skein::run_tool {

namespace {

std::atomic<bool> was_interrupted{false};

}  // namespace

InterruptGuard::InterruptGuard() {
  was_interrupted = false;
  struct sigaction action {};
  action.sa_handler = [](int) { was_interrupted = true; };
  sigaction(SIGINT, &action, &old_int_);
  sigaction(SIGTERM, &action, &old_term_);
  sigaction(SIGHUP, nullptr, &old_hang_up_);
  if (old_hang_up_.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &old_int_, nullptr);
  sigaction(SIGTERM, &old_term_, nullptr);
  sigaction(SIGHUP, &old_hang_up_, nullptr);
}

bool InterruptGuard::interrupted() { return was_interrupted; }

}  // namespace skein::run_tool
