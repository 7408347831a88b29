// SPDX-License-Identifier: Apache-2.0
// A wall clock that the test sets: preloaded into a process (LD_PRELOAD), it adds what stands in
// the file ADVERSITY_CLOCK (eight bytes, seconds, signed) to CLOCK_REALTIME, at every call anew.
// Waits until an instant of that clock follow it, as those of the kernel do when a clock is set.
// They are made of slices; a signal that comes when a slice is over already, and the thread waits
// for its processor or its mutex, is not lost: signals are counted.
// The steady clocks are left alone. Without the variable nothing is changed.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;  // [ns]
constexpr std::int64_t kSlice = kSecond / 20;  // between two looks at the clock while waiting [ns]
// Instants of CLOCK_MONOTONIC count from the start of the machine, those of CLOCK_REALTIME from
// 1970: what lies before 2001 is of the former, after the shift of no more than a day back too.
constexpr std::int64_t kLongAgo = 1'000'000'000;  // [s]

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));  // NOLINT: how dlsym gives functions
}

using Shift = std::atomic<std::int64_t>;

const Shift* shared_shift() {
  const char* file = std::getenv("ADVERSITY_CLOCK");
  if (file == nullptr) return nullptr;
  const int descriptor = open(file, O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  void* const page = mmap(nullptr, sizeof(Shift), PROT_READ, MAP_SHARED, descriptor, 0);
  close(descriptor);
  return page == MAP_FAILED ? nullptr : static_cast<const Shift*>(page);
}

std::int64_t shift() {  // [s]
  static const Shift* const shared = shared_shift();
  return shared == nullptr ? 0 : shared->load();
}

bool is_wall(clockid_t clock) { return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE; }

int true_time(clockid_t clock, timespec* time) {
  static const auto real = next<int (*)(clockid_t, timespec*)>("clock_gettime");
  return real(clock, time);
}

std::int64_t true_wall() {  // [ns]
  timespec time{};
  true_time(CLOCK_REALTIME, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

timespec to_timespec(std::int64_t ns) { return {ns / kSecond, ns % kSecond}; }

/// Waits by `wait` until the instant of the shifted clock, a slice after the other: the shift may
/// change meanwhile. An instant of another clock is passed on.
template <class Wait>
int until(const timespec* limit, const Wait& wait) {
  if (limit->tv_sec < kLongAgo) return wait(limit);
  while (true) {
    const std::int64_t now = true_wall();
    const std::int64_t end = (limit->tv_sec - shift()) * kSecond + limit->tv_nsec;
    const timespec slice = to_timespec(std::min(end, now + kSlice));
    const int result = wait(&slice);
    if (result != ETIMEDOUT || end <= now + kSlice) return result;
  }
}

/// Signals given so far to this condition, or to another of the few with which it shares a counter:
/// those wake it too, which POSIX allows.
std::atomic<std::uint32_t>& signals_of(const pthread_cond_t* condition) {
  static std::array<std::atomic<std::uint32_t>, 4096> counters;
  return counters[reinterpret_cast<std::uintptr_t>(condition) / 16 % counters.size()];  // NOLINT
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const int result = true_time(clock, time);
  if (result == 0 && is_wall(clock)) time->tv_sec += shift();
  return result;
}

int gettimeofday(timeval* __restrict time, void* __restrict zone) noexcept {
  static const auto real = next<int (*)(timeval*, void*)>("gettimeofday");
  const int result = real(time, zone);
  if (result == 0) time->tv_sec += shift();
  return result;
}

time_t time(time_t* also) noexcept {
  const time_t now = true_wall() / kSecond + shift();
  if (also != nullptr) *also = now;
  return now;
}

int pthread_cond_timedwait(pthread_cond_t* __restrict condition, pthread_mutex_t* __restrict mutex,
                           const timespec* __restrict limit) {
  static const auto real =
      next<int (*)(pthread_cond_t*, pthread_mutex_t*, const timespec*)>("pthread_cond_timedwait");
  const std::uint32_t before = signals_of(condition);
  return until(limit, [&](const timespec* at) {
    const int result = real(condition, mutex, at);
    return result == ETIMEDOUT && signals_of(condition) != before ? 0 : result;
  });
}

int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  static const auto real = next<int (*)(pthread_cond_t*)>("pthread_cond_signal");
  ++signals_of(condition);
  return real(condition);
}

int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  static const auto real = next<int (*)(pthread_cond_t*)>("pthread_cond_broadcast");
  ++signals_of(condition);
  return real(condition);
}

int pthread_mutex_timedlock(pthread_mutex_t* __restrict mutex,
                            const timespec* __restrict limit) noexcept {
  static const auto real =
      next<int (*)(pthread_mutex_t*, const timespec*)>("pthread_mutex_timedlock");
  return until(limit, [&](const timespec* at) { return real(mutex, at); });
}

int sem_timedwait(sem_t* __restrict semaphore, const timespec* __restrict limit) {
  static const auto real = next<int (*)(sem_t*, const timespec*)>("sem_timedwait");
  const int error =
      until(limit, [&](const timespec* at) { return real(semaphore, at) == 0 ? 0 : errno; });
  if (error == 0) return 0;
  errno = error;
  return -1;
}

}  // extern "C"
