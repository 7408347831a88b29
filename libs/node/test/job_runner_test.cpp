// SPDX-License-Identifier: Apache-2.0
#include "job_runner.hpp"

#include <gtest/gtest.h>

#include <future>
#include <latch>
#include <semaphore>

namespace skein::node {
namespace {

// Collects results as a daemon's loop does: after each notice.
class Collector {
 public:
  std::function<void()> notify() {
    return [this] { notices_.release(); };
  }
  // Waits for this many results.
  std::vector<JobDone> take(JobRunner& runner, std::size_t count) {
    std::vector<JobDone> all;
    while (all.size() < count) {
      notices_.acquire();
      for (JobDone& done : runner.take_done()) all.push_back(std::move(done));
    }
    return all;
  }

 private:
  std::counting_semaphore<> notices_{0};
};

TEST(JobRunner, GivesBackTheResultWithTheJobsId) {
  Collector collector;
  JobRunner runner(collector.notify());

  runner.submit({7, [](const TimeIsUp&) { return std::any(std::string("route")); }});
  const auto done = collector.take(runner, 1);

  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].id, 7U);
  EXPECT_EQ(std::any_cast<std::string>(done[0].result), "route");
}

TEST(JobRunner, WorksInAnotherThread) {
  Collector collector;
  JobRunner runner(collector.notify());

  runner.submit({1, [](const TimeIsUp&) { return std::any(std::this_thread::get_id()); }});
  const auto done = collector.take(runner, 1);

  EXPECT_NE(std::any_cast<std::thread::id>(done[0].result), std::this_thread::get_id());
}

TEST(JobRunner, SubmittingDoesNotWaitForTheJobThatRuns) {
  Collector collector;
  std::latch running(1), go_on(1);
  JobRunner runner(collector.notify());

  runner.submit({1, [&](const TimeIsUp&) {
                   running.count_down();
                   go_on.wait();
                   return std::any();
                 }});
  running.wait();
  runner.submit({2, [](const TimeIsUp&) { return std::any(); }});
  const bool nothing_yet = runner.take_done().empty();
  go_on.count_down();

  EXPECT_TRUE(nothing_yet);
  EXPECT_EQ(collector.take(runner, 2).size(), 2U);
}

TEST(JobRunner, JobsRunInTheOrderOfTheirArrival) {
  Collector collector;
  JobRunner runner(collector.notify());

  for (std::uint64_t id = 1; id <= 100; ++id) {
    runner.submit({id, [id](const TimeIsUp&) { return std::any(id * id); }});
  }
  const auto done = collector.take(runner, 100);

  for (std::size_t i = 0; i < done.size(); ++i) {
    EXPECT_EQ(done[i].id, i + 1);
    EXPECT_EQ(std::any_cast<std::uint64_t>(done[i].result), (i + 1) * (i + 1));
  }
}

TEST(JobRunner, ResultsAreTakenOnce) {
  Collector collector;
  JobRunner runner(collector.notify());
  runner.submit({1, [](const TimeIsUp&) { return std::any(); }});

  const auto first = collector.take(runner, 1);

  EXPECT_EQ(first.size(), 1U);
  EXPECT_TRUE(runner.take_done().empty());
}

TEST(JobRunner, ItsEndWaitsForTheJobThatRunsAndDropsThoseThatWait) {
  std::latch running(1), go_on(1);
  bool finished = false, second_ran = false;
  std::thread helper;
  {
    JobRunner runner([] {});
    runner.submit({1, [&](const TimeIsUp&) {
                     running.count_down();
                     go_on.wait();
                     finished = true;
                     return std::any();
                   }});
    running.wait();
    runner.submit({2, [&](const TimeIsUp&) {
                     second_ran = true;
                     return std::any();
                   }});
    std::promise<void> ending;
    helper = std::thread([&go_on, end = ending.get_future()]() mutable {
      end.wait();
      go_on.count_down();
    });
    ending.set_value();
  }
  helper.join();

  EXPECT_TRUE(finished);
  (void)second_ran;  // whether it was still dropped depends on who was quicker
}

TEST(JobRunner, TellsAJobWhenItHasHadItsTime) {
  Collector collector;
  JobRunner runner(collector.notify());
  const auto until_told = [](const TimeIsUp& time_is_up) {
    std::uint64_t asked = 0;
    for (; !time_is_up(); ++asked) std::this_thread::yield();
    return std::any(asked);
  };

  runner.submit({1, until_told, Duration::milliseconds(20)});
  runner.submit({2, [](const TimeIsUp& time_is_up) { return std::any(time_is_up()); }});
  const auto done = collector.take(runner, 2);

  EXPECT_GT(std::any_cast<std::uint64_t>(done[0].result), 0U);
  EXPECT_FALSE(std::any_cast<bool>(done[1].result)) << "who has no limit has all the time it needs";
}

TEST(JobRunner, TellsAJobWhenNobodyWantsItsResultAnyMore) {
  Collector collector;
  JobRunner runner(collector.notify());
  std::latch running(1);

  runner.submit({1, [&](const TimeIsUp& time_is_up) {
                   running.count_down();
                   while (!time_is_up()) std::this_thread::yield();
                   return std::any();
                 }});
  runner.submit({2, [](const TimeIsUp& time_is_up) { return std::any(time_is_up()); }});
  runner.submit({3, [](const TimeIsUp& time_is_up) { return std::any(time_is_up()); }});
  running.wait();
  runner.stop(2);
  runner.stop(1);
  const auto done = collector.take(runner, 3);

  EXPECT_TRUE(std::any_cast<bool>(done[1].result)) << "also when it waited";
  EXPECT_FALSE(std::any_cast<bool>(done[2].result));
}

TEST(JobRunner, EndsWithNothingToDo) {
  JobRunner runner([] { FAIL() << "nothing was submitted"; });

  EXPECT_TRUE(runner.take_done().empty());
}

}  // namespace
}  // namespace skein::node
