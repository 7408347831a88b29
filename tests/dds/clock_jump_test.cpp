// SPDX-License-Identifier: Apache-2.0
// The wall clock of a machine is set in mid-mission, by a day forward or back: nobody's lease,
// session or command ends by it, and the mission is the same.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fstream>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include "temporary_folder.hpp"
#include "testing/clocks_apart.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kDay = 86'400;  // [s]
constexpr const char* kLibrary = SKEIN_BINARY_DIR "/lib/libskein_adversity.so";

/// What the processes of a run believe of the wall clock: those that are started while this lives.
class WallClock {
 public:
  explicit WallClock(const fs::path& file)
      : file_(file), descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    set(0);
  }
  WallClock(const WallClock&) = delete;
  WallClock& operator=(const WallClock&) = delete;
  ~WallClock() { close(descriptor_); }

  /// So many seconds beside the true one, from now on.
  void set(std::int64_t seconds) const {
    ASSERT_EQ(pwrite(descriptor_, &seconds, sizeof seconds, 0), ssize_t{sizeof seconds});
  }
  /// Shell: this clock and no other for what is started next.
  std::string variables() const {
    return "ADVERSITY_CLOCK='" + file_.string() + "' LD_PRELOAD='" + kLibrary + "' ";
  }

 private:
  fs::path file_;
  int descriptor_;
};

/// Days of the month (UTC) that stand in the log of a daemon.
std::set<std::string> days_in(const fs::path& log) {
  std::ifstream in(log);
  std::set<std::string> days;
  for (std::string line; std::getline(in, line);)
    if (line.size() > 10 && line[4] == '-' && line[10] == 'T') days.insert(line.substr(0, 10));
  return days;
}

void expect_the_same_mission(DdsRun& run) {
  const auto status = run.wait();
  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_THAT(run.output(), HasSubstr("20 of 20 expectations met"));
  EXPECT_EQ(run.count("command", "state", "expired"), 0U);
  EXPECT_EQ(run.count("contact", "kind", "contact"), 0U);
  EXPECT_EQ(run.count("lost", "kind", "lost"), 0U);
  const std::vector<journal::Record> records = run.records();
  for (const journal::Record& record : records) {
    if (record.kind() == "mission" && record.text("state") == "finished") break;
    EXPECT_TRUE(record.kind() != "reach" || record.truth("reachable")) << to_json(record);
  }
  EXPECT_EQ(breaches_beyond_clocks(records, 20), "");
  EXPECT_TRUE(run.nothing_runs());
}

// What the preloaded clock promises: this test starts itself anew under it.
TEST(WallClockOfTests, LosesNoSignalThatComesWhileAWaiterWaitsForItsMutex) {
  using namespace std::chrono_literals;
  if (std::getenv("ADVERSITY_CLOCK") == nullptr) {
    const TemporaryFolder folder;
    const WallClock clock(folder.path() / "clock");
    const std::string self = fs::read_symlink("/proc/self/exe").string();
    EXPECT_EQ(
        std::system((clock.variables() + self + " --gtest_filter='WallClockOfTests.*'").c_str()),
        0);
    return;
  }
  std::mutex mutex;
  std::condition_variable condition;
  bool ready = false;
  std::unique_lock lock(mutex);
  std::future<bool> heard = std::async(std::launch::async, [&] {
    std::unique_lock own(mutex);
    condition.notify_all();
    return condition.wait_until(own, std::chrono::system_clock::now() + 20s, [&] { return ready; });
  });
  condition.wait(lock);  // until it waits itself
  const auto began = std::chrono::steady_clock::now();
  // What is tried is that time passes: its slice of 50 ms ends while the mutex is not free.
  std::this_thread::sleep_for(300ms);

  ready = true;
  condition.notify_all();
  lock.unlock();

  EXPECT_TRUE(heard.get());
  EXPECT_LT(std::chrono::steady_clock::now() - began, 10s);
}

class DdsClockJump : public ::testing::TestWithParam<const char*> {};

TEST_P(DdsClockJump, OfAllMachinesForwardAndBackChangesNothing) {
  DdsRun run;
  run.take_scenario("confirmed");
  const WallClock clock(run.file("clock"));
  const std::string programs =
      run.programs_with({"skein-sim", "skein-ground", "skein-ddn"},
                        clock.variables() + "exec \"$programs/${0##*/}\" \"$@\"");

  run.start({"--rate", "20", "--dds", GetParam(), "--daemons", programs});
  run.wait_for_output("Confirmation");
  clock.set(kDay);
  run.wait_for_output("Monitoring");
  clock.set(-kDay);
  expect_the_same_mission(run);

  for (const char* daemon : {"sim", "ground", "marvin"})
    EXPECT_EQ(days_in(run.folder() / "logs" / (std::string(daemon) + ".log")).size(), 3U) << daemon;
}

TEST_P(DdsClockJump, OfOneMachineForwardAndBackChangesNothing) {
  DdsRun run;
  run.take_scenario("confirmed");
  const WallClock clock(run.file("clock"));
  const std::string programs = run.programs_with(
      {"skein-ddn"},
      "case \"$*\" in *\"--uav marvin\"*) " + clock.variables() +
          "exec \"$programs/skein-ddn\" \"$@\" ;; esac\nexec \"$programs/skein-ddn\" \"$@\"");

  run.start({"--rate", "20", "--dds", GetParam(), "--daemons", programs});
  run.wait_for_output("Confirmation");
  clock.set(-kDay);
  run.wait_for_output("Monitoring");
  clock.set(kDay);
  expect_the_same_mission(run);

  EXPECT_EQ(days_in(run.folder() / "logs/marvin.log").size(), 3U);
  EXPECT_EQ(days_in(run.folder() / "logs/heliv.log").size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(On, DdsClockJump, ::testing::Values("fastdds", "cyclonedds"));

// A daemon comes back into another day: the others hear it, and it goes on.
TEST(DdsClockJumpInDeath, ByADayBackIsNotSeenByTheOthers) {
  DdsRun run;
  run.take_scenario("confirmed", "faults:\n  - {at: 400, kill: marvin, restart_after: 5}\n");
  const WallClock clock(run.file("clock"));
  const std::string programs =
      run.programs_with({"skein-ddn"}, clock.variables() + "exec \"$programs/skein-ddn\" \"$@\"");

  run.start({"--rate", "20", "--daemons", programs});
  run.wait_for_output("Confirmation");
  clock.set(-kDay);
  const auto status = run.wait();

  ASSERT_TRUE(status.has_value());
  EXPECT_EQ(status->code, 0) << run.output();
  EXPECT_EQ(run.count("fault", "what", "resume"), 1U);
  const std::vector<journal::Record> records = run.records();
  EXPECT_EQ(std::count_if(records.begin(), records.end(),
                          [](const auto& one) { return one.kind() == "resumed"; }),
            1);
}

}  // namespace
}  // namespace skein::testing
