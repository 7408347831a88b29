// SPDX-License-Identifier: Apache-2.0
#include "skein/node/waker.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>

#include "skein/foundation/contract.hpp"

namespace skein::node {

Waker::Waker() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGHUP);
  sigaddset(&signals, SIGCHLD);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signal_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
  event_ = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  SKEIN_ENSURES(signal_ >= 0 && event_ >= 0);
}

Waker::~Waker() {
  close(event_);
  close(signal_);
}

void Waker::notify() noexcept {
  const std::uint64_t one = 1;
  // It can only fail when the counter is full, and then the loop is being woken already.
  [[maybe_unused]] const auto written = write(event_, &one, sizeof one);
}

void Waker::wait(std::optional<Duration> timeout) {
  pollfd files[] = {{event_, POLLIN, 0}, {signal_, POLLIN, 0}};
  timespec limit{};
  if (timeout) {
    const std::int64_t ns = std::max<std::int64_t>(timeout->count(), 0);
    limit = {ns / 1'000'000'000, ns % 1'000'000'000};
  }
  if (ppoll(files, 2, timeout ? &limit : nullptr, nullptr) <= 0) return;
  std::uint64_t count = 0;
  [[maybe_unused]] const auto drained = read(event_, &count, sizeof count);
  signalfd_siginfo info{};
  while (read(signal_, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo == SIGINT || info.ssi_signo == SIGTERM) stop_ = true;
  }
}

Duration Waker::steady_now() {
  return Duration::nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(
                                   std::chrono::steady_clock::now().time_since_epoch())
                                   .count());
}

}  // namespace skein::node
