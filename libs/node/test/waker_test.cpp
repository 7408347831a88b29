// SPDX-License-Identifier: Apache-2.0
#include "skein/node/waker.hpp"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

namespace skein::node {
namespace {

// Long enough to tell that something else than the time ended a wait.
constexpr Duration kLong = Duration::milliseconds(60'000);

Duration time_of(const std::function<void()>& action) {
  const Duration before = Waker::steady_now();
  action();
  return Waker::steady_now() - before;
}

TEST(Waker, AWaitEndsAtItsTime) {
  Waker waker;

  const Duration took = time_of([&] { waker.wait(Duration::milliseconds(20)); });

  EXPECT_GE(took, Duration::milliseconds(20));
  EXPECT_LT(took, kLong);
}

TEST(Waker, ATimeThatIsPastIsNoWait) {
  Waker waker;

  EXPECT_LT(time_of([&] { waker.wait(Duration::seconds(-5)); }), kLong);
  EXPECT_LT(time_of([&] { waker.wait(Duration()); }), kLong);
}

TEST(Waker, ANoticeBeforeTheWaitEndsItAtOnce) {
  Waker waker;

  waker.notify();

  EXPECT_LT(time_of([&] { waker.wait(kLong); }), kLong);
}

TEST(Waker, NoticesAreForgottenOnceWaitedFor) {
  Waker waker;
  for (int i = 0; i < 1000; ++i) waker.notify();
  waker.wait(kLong);

  const Duration took = time_of([&] { waker.wait(Duration::milliseconds(20)); });

  EXPECT_GE(took, Duration::milliseconds(20));
}

TEST(Waker, ANoticeFromAnotherThreadEndsAWaitWithoutLimit) {
  Waker waker;
  std::thread other([&] { waker.notify(); });

  waker.wait(std::nullopt);
  other.join();

  EXPECT_FALSE(waker.stop_requested());
}

class StopSignal : public ::testing::TestWithParam<int> {};

TEST_P(StopSignal, EndsAWaitAndIsRemembered) {
  Waker waker;
  ASSERT_FALSE(waker.stop_requested());

  pthread_kill(pthread_self(), GetParam());
  waker.wait(std::nullopt);

  EXPECT_TRUE(waker.stop_requested());
  waker.wait(Duration());
  EXPECT_TRUE(waker.stop_requested());
}
INSTANTIATE_TEST_SUITE_P(Signals, StopSignal, ::testing::Values(SIGTERM, SIGINT));

TEST(Waker, AClosedTerminalDoesNotStop) {
  Waker waker;

  pthread_kill(pthread_self(), SIGHUP);
  waker.wait(std::nullopt);

  EXPECT_FALSE(waker.stop_requested());
}

TEST(Waker, TheEndOfAChildWakesButDoesNotStop) {
  Waker waker;
  const pid_t child = fork();
  if (child == 0) _exit(0);

  const Duration took = time_of([&] { waker.wait(kLong); });
  waitpid(child, nullptr, 0);

  EXPECT_LT(took, kLong);
  EXPECT_FALSE(waker.stop_requested());
}

TEST(Waker, SteadyTimeNeverDecreases) {
  Duration last = Waker::steady_now();

  for (int i = 0; i < 10'000; ++i) {
    const Duration now = Waker::steady_now();
    ASSERT_GE(now, last);
    last = now;
  }
}

}  // namespace
}  // namespace skein::node
