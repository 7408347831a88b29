// SPDX-License-Identifier: Apache-2.0
// Processor time for laws about budgets, and how slow the machine is at this moment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <vector>

namespace skein::testing {

/// How long after its budget of processor time a service may end [s].
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kRoom = 0.5;
#else
constexpr double kRoom = 0.05;
#endif

/// What the work of `work_seconds` takes on machine A with nothing beside it [s].
constexpr double kUsualWork = 0.003;

/// Of this thread [s].
inline double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A fixed piece of work, in and out of the caches [s].
inline double work_seconds() {
  static std::vector<std::uint32_t> table(1U << 20U, 1);
  const double began = processor_seconds();
  std::uint32_t state = 1;
  for (int i = 0; i < 1'000'000; ++i) {
    state = state * 1664525U + 1013904223U;
    table[state >> 12U] += state;
  }
  return processor_seconds() - began;
}

/// How many times as long as usual everything takes here and now, at least once: who shares the
/// cores and the caches of a machine makes its processor seconds longer.
inline double slowness() { return std::max(1.0, work_seconds() / kUsualWork); }

/// So many seconds late by the machine's clock, told as on machine A.
inline double late_here(double seconds) { return seconds > kRoom ? seconds / slowness() : seconds; }

}  // namespace skein::testing
