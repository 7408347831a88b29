// SPDX-License-Identifier: Apache-2.0
// Daemons over real DDS, each in its own process, and a reader as the runner is one.
#include "skein/node/daemon.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "skein/blackboard/dds_transport.hpp"
#include "skein/blackboard/domain_lease.hpp"
#include "skein/node/waker.hpp"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to us

namespace skein::node {
namespace {

// Far longer than anything here takes: a test that gets there has failed.
constexpr Duration kDeadline = Duration::milliseconds(30'000);

// "mixed": the reader and the ground are on Cyclone DDS, the others on Fast DDS.
blackboard::DdsVendor vendor_of(const std::string& mix, const std::string& node) {
  if (const auto all = blackboard::dds_from_name(mix)) return *all;
  const bool cyclone = node == "ground" || node == "runner";
  return cyclone ? blackboard::DdsVendor::kCycloneDds : blackboard::DdsVendor::kFastDds;
}

std::unique_ptr<blackboard::Transport> make_transport(const std::string& mix,
                                                      std::uint32_t domain) {
  blackboard::DdsConfig config;
  config.domain = domain;
  config.participant_name = "runner";
  config.network.dds = vendor_of(mix, config.participant_name);
  return blackboard::make_dds_transport(std::move(config));
}

// Three daemons in a DDS domain of their own, and what a reader on the world channel sees of them.
class Daemons : public ::testing::TestWithParam<const char*> {
 protected:
  Daemons() {
    std::filesystem::create_directories(folder_);
    transport_->on_arrival([this] { waker_.notify(); });
    blackboard::Config config;
    config.self = roster_.runner();
    config.channels = roster_.channels_of(*roster_.find("runner"));
    config.world_reads = roster_.world_reads_of(wire::Role::kRunner);
    auto opened = blackboard::Blackboard::open(std::move(config), *transport_);
    EXPECT_TRUE(opened.has_value());
    board_.emplace(std::move(*opened));
  }
  ~Daemons() override {
    for (const auto& [name, process] : running_) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
    }
    std::filesystem::remove_all(folder_);
  }

  void start(const std::string& name, const std::string& finish = "0",
             const std::string& zones = "1") {
    const std::string program = SKEIN_BINARY_DIR "/bin/skein_node_test_daemon";
    std::vector<std::string> words{
        program,       std::to_string(lease_.value().domain()),           name,  finish,
        file_of(name), std::string(name_of(vendor_of(GetParam(), name))), zones, "on"};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t process = 0;
    ASSERT_EQ(posix_spawn(&process, program.c_str(), nullptr, nullptr, arguments.data(), environ),
              0);
    running_[name] = process;
  }
  void start_all(const std::string& finish = "0") {
    for (const char* name : {"sim", "ground", "a"}) start(name, finish);
  }
  void stop(const std::string& name, int signal = SIGTERM) { kill(running_.at(name), signal); }

  // Reads until the condition holds; false if it does not within the deadline.
  bool until(const std::function<bool()>& condition) {
    const Duration deadline = Waker::steady_now() + kDeadline;
    while (!condition()) {
      if (Waker::steady_now() > deadline) return false;
      waker_.wait(Duration::milliseconds(100));
      for (auto& incoming : board_->step({MissionTime(), Waker::steady_now()})) {
        if (auto* received = std::get_if<blackboard::Received>(&incoming)) see(received->sample);
      }
      collect_ends();
    }
    return true;
  }
  bool until_ended(const std::string& name) {
    return until([&] { return ends_.count(name) > 0; });
  }
  bool until_all_ended() {
    return until([&] { return running_.empty(); });
  }

  // The records of a daemon by its own account, and what the reader got of them.
  std::vector<std::string> written(const std::string& name) const {
    return lines_of(file_of(name));
  }
  std::vector<std::string> waits(const std::string& name) const {
    return lines_of(file_of(name) + ".waits");
  }
  std::vector<std::string> read(const std::string& name) const {
    const auto found = records_.find(roster_.find(name)->number);
    return found == records_.end() ? std::vector<std::string>() : found->second;
  }
  std::size_t ticks_read(const std::string& name) const {
    const auto lines = read(name);
    return static_cast<std::size_t>(std::count_if(
        lines.begin(), lines.end(),
        [](const std::string& line) { return line.find("\"tick\"") != std::string::npos; }));
  }

  std::map<std::string, int> ends_;  // exit codes; signals count negative
  std::vector<wire::Clock> clocks_;
  std::map<std::string, wire::DirectoryEntry> directory_;

 private:
  static std::vector<std::string> lines_of(const std::string& file) {
    std::vector<std::string> lines;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }
  std::string file_of(const std::string& name) const {
    return (folder_ / (name + ".jsonl")).string();
  }

  void see(const wire::Sample& sample) {
    if (const auto* clock = std::get_if<wire::Clock>(&sample)) clocks_.push_back(*clock);
    if (const auto* entry = std::get_if<wire::DirectoryEntry>(&sample)) {
      directory_[entry->name] = *entry;
    }
    if (const auto* entry = std::get_if<wire::JournalEntry>(&sample)) {
      records_[NodeNumber(entry->header.origin)].push_back(entry->record);
    }
  }
  void collect_ends() {
    std::erase_if(running_, [this](const auto& one) {
      int status = 0;
      if (waitpid(one.second, &status, WNOHANG) != one.second) return false;
      ends_[one.first] = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
      return true;
    });
  }

  const Roster roster_{{"a"}};
  Result<blackboard::DomainLease, Failure> lease_ = blackboard::claim_domain();
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("skein-daemon-test-" + std::to_string(getpid()));
  Waker waker_;
  std::unique_ptr<blackboard::Transport> transport_ =
      make_transport(GetParam(), lease_.value().domain());
  std::optional<blackboard::Blackboard> board_;
  std::map<std::string, pid_t> running_;
  std::map<NodeNumber, std::vector<std::string>> records_;
};

TEST_P(Daemons, TheClockStartsOnceEverybodyIsReady) {
  start("sim");
  start("ground");
  ASSERT_TRUE(until([&] { return clocks_.size() >= 5; }));
  for (const wire::Clock& clock : clocks_) EXPECT_EQ(clock.phase, wire::ClockPhase::kHolding);

  start("a");

  ASSERT_TRUE(until([&] { return clocks_.back().phase == wire::ClockPhase::kRunning; }));
  ASSERT_TRUE(until([&] { return directory_.count("a") > 0 && directory_.at("a").ready; }));
  EXPECT_EQ(directory_.at("sim").role, wire::Role::kSim);
  EXPECT_EQ(clocks_.back().rate, 10);
}

TEST_P(Daemons, SayOnceWhomTheStartWaitsFor) {
  start("ground");
  ASSERT_TRUE(until([&] { return !waits("ground").empty(); }));
  EXPECT_EQ(waits("ground").front(), "waits for the mission to start: its clock is not heard");

  start("sim");
  ASSERT_TRUE(until([&] { return !waits("sim").empty() && waits("ground").size() > 1; }));
  EXPECT_EQ(waits("sim").front(), "the mission waits for a, not heard of");
  EXPECT_EQ(waits("ground").back(), "waits for the mission to start: not all are ready");

  start("a");
  EXPECT_TRUE(until([&] { return ticks_read("a") >= 50; }));
}

TEST_P(Daemons, TheClockDoesNotStartWithOneThatFliesAnotherScenario) {
  start("sim");
  start("ground");
  start("a", "0", "2");

  const std::map<std::string, std::string> expected{
      {"sim", "the mission waits: the scenario of a differs in zones"},
      {"ground", "waits for the mission to start: the scenario of a differs in zones"},
      {"a", "waits for the mission to start: the scenario of ground, sim differs in zones"}};
  for (const auto& [name, text] : expected) {
    EXPECT_TRUE(until([&] { return !waits(name).empty() && waits(name).back() == text; }))
        << name << ": " << ::testing::PrintToString(waits(name));
  }
  for (const wire::Clock& clock : clocks_) EXPECT_EQ(clock.phase, wire::ClockPhase::kHolding);

  stop("a", SIGKILL);
  ASSERT_TRUE(until_ended("a"));
  start("a");
  EXPECT_TRUE(until([&] { return ticks_read("a") >= 50; }));
}

TEST_P(Daemons, OneThatComesBackWithAnotherScenarioTakesNoPart) {
  start_all();
  ASSERT_TRUE(until([&] { return ticks_read("a") >= 50; }));
  stop("a", SIGKILL);
  ASSERT_TRUE(until_ended("a"));
  ends_.clear();

  start("a", "0", "2");

  ASSERT_TRUE(until_ended("a"));
  EXPECT_EQ(ends_.at("a"), 2);
  ASSERT_FALSE(written("a").empty());
  EXPECT_NE(written("a").back().find("a mission is under way, and the scenario of "),
            std::string::npos);
  for (const std::string& line : written("a")) EXPECT_EQ(line.find("life"), line.npos) << line;
  ends_.clear();
  start("a");
  EXPECT_TRUE(until([&] {
    const auto lines = written("a");
    return std::ranges::any_of(lines,
                               [](const auto& line) { return line.find("tick") != line.npos; });
  }));
}

TEST_P(Daemons, MissionTimeAdvancesAtTheFollowersInStepWithTheLeaders) {
  start_all();

  ASSERT_TRUE(until([&] { return ticks_read("a") >= 250; }));

  // The n-th burst is written when mission second n has come there.
  std::size_t ticks = 0;
  for (const std::string& line : read("a")) {
    const auto record = journal::parse_record(line);
    ASSERT_TRUE(record.has_value()) << line;
    if (record->text("what") != "tick") continue;
    const double second = static_cast<double>(ticks++ / 50 + 1);
    EXPECT_GE(record->at().to_seconds(), second) << line;
  }
}

// Without a state folder all that they know is whether the mission's clock has begun.
TEST_P(Daemons, OneThatIsThereBeforeTheClockBeginsLivesForTheFirstTime) {
  const auto lives_of_a = [this](const std::string& what) {
    const auto lines = read("a");
    return std::count_if(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find('"' + what + '"') != std::string::npos;
    });
  };
  start_all();
  ASSERT_TRUE(until([&] { return ticks_read("a") >= 50; }));
  EXPECT_EQ(lives_of_a("first life"), 1);

  stop("a", SIGKILL);
  ASSERT_TRUE(until_ended("a"));
  start("a");

  EXPECT_TRUE(until([&] { return lives_of_a("another life") == 1; }));
  EXPECT_EQ(lives_of_a("first life"), 1);
}

TEST_P(Daemons, JobsComeBackWhileTheLoopGoesOn) {
  start_all();

  EXPECT_TRUE(until([&] {
    const auto lines = read("ground");
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("\"job\"") != std::string::npos;
    });
  }));
}

TEST_P(Daemons, NoJobWaitsForOneOfTheSecondLane) {
  start_all();

  EXPECT_TRUE(until([&] {
    const auto lines = read("ground");
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("\"beside\"") != std::string::npos;
    });
  }));
}

// As a machine that sleeps and wakes: nobody has said anything, and nobody has listened.
TEST_P(Daemons, ThoseWhomTheMachineHeldUpDoNotTakeEachOtherForSilent) {
  start_all();
  ASSERT_TRUE(until([&] { return ticks_read("a") >= 50 && ticks_read("ground") >= 50; }));
  for (const char* name : {"ground", "sim", "a"}) stop(name, SIGSTOP);
  const Duration wakes = Waker::steady_now() + Duration::milliseconds(1'000);  // ten periods
  ASSERT_TRUE(until([&] { return Waker::steady_now() >= wakes; }));
  for (const char* name : {"ground", "sim", "a"}) stop(name, SIGCONT);

  const auto ticks = ticks_read("a");
  ASSERT_TRUE(until([&] { return ticks_read("a") > ticks + 200; }));
  for (const char* name : {"ground", "a"}) {
    for (const std::string& line : read(name))
      EXPECT_EQ(line.find("\"reachable\":false"), line.npos) << line;
  }
}

TEST_P(Daemons, TheEndOfTheMissionEndsThemAll) {
  start_all("3");

  ASSERT_TRUE(until_all_ended());

  EXPECT_EQ(ends_, (std::map<std::string, int>{{"a", 0}, {"ground", 0}, {"sim", 0}}));
  EXPECT_EQ(clocks_.back().phase, wire::ClockPhase::kFinished);
  EXPECT_GE(clocks_.back().time, MissionTime::seconds(5).count());  // two seconds after the end
}

// The clock waits for the daemons, not for a reader: the mission lasts 3 s of the wall, in which
// the reader meets the last of them.
TEST_P(Daemons, EveryRecordArrivesInOrderUpToTheLast) {
  start("sim", "30");
  start("ground", "30");
  ASSERT_TRUE(until([&] { return directory_.count("sim") + directory_.count("ground") == 2; }));
  start("a", "30");

  ASSERT_TRUE(until_all_ended());

  for (const char* name : {"ground", "sim", "a"}) {
    ASSERT_GE(written(name).size(), 200U) << name;
    EXPECT_TRUE(until([&] { return read(name).size() >= written(name).size(); })) << name;
    EXPECT_EQ(read(name).size(), written(name).size()) << name;
    EXPECT_TRUE(read(name) == written(name)) << name;
  }
}

TEST_P(Daemons, ASignalStopsOneAndItsLastRecordsArrive) {
  start_all();
  ASSERT_TRUE(until([&] { return ticks_read("a") >= 50; }));

  stop("a");

  ASSERT_TRUE(until_ended("a"));
  EXPECT_EQ(ends_.at("a"), 10);
  EXPECT_EQ(ends_.size(), 1U);  // the others go on
  EXPECT_TRUE(until([&] { return read("a").size() >= written("a").size(); }));
  EXPECT_EQ(read("a"), written("a"));
}

TEST_P(Daemons, ASignalStopsTheLeader) {
  start_all();
  ASSERT_TRUE(until([&] { return !clocks_.empty(); }));

  stop("sim");

  ASSERT_TRUE(until_ended("sim"));
  EXPECT_EQ(ends_.at("sim"), 10);
}

TEST_P(Daemons, OneThatDiedDoesNotHoldTheOthersUp) {
  start_all();
  ASSERT_TRUE(until([&] { return ticks_read("a") >= 50; }));

  stop("ground", SIGKILL);
  stop("sim");
  stop("a");

  ASSERT_TRUE(until_all_ended());
  EXPECT_EQ(ends_, (std::map<std::string, int>{{"a", 10}, {"ground", -SIGKILL}, {"sim", 10}}));
}

std::string name_of_mix(const ::testing::TestParamInfo<const char*>& mix) { return mix.param; }
INSTANTIATE_TEST_SUITE_P(On, Daemons, ::testing::Values("fastdds", "cyclonedds", "mixed"),
                         name_of_mix);

}  // namespace
}  // namespace skein::node
