// SPDX-License-Identifier: Apache-2.0
// Daemons as in flight: no simulator of the whole, no runner, no world channel.
#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <map>

#include "skein/blackboard/domain_lease.hpp"
#include "skein/journal/record.hpp"
#include "testing/dds_run.hpp"

namespace skein::testing {
namespace {

using ::testing::HasSubstr;

/// COMETS with its four nodes and, in the place of three autopilots, one functional layer.
class Flight {
 public:
  Flight() : lease_(blackboard::claim_domain()) {
    EXPECT_TRUE(lease_.has_value());
    files_.take_scenario("confirmed");
    for (const char* uav : {"marvin", "heliv", "karma"})
      files_.change(std::string(uav) + ": {model:",
                    std::string(uav) + ": {functional: autopilot, model:");
    start("autopilot", {"skein-sim", "--node", "autopilot"});
    for (const char* uav : {"marvin", "heliv", "karma"}) start(uav, {"skein-ddn", "--uav", uav});
    start("ground", {"skein-ground"});
  }

  std::optional<run_tool::Process::Status> end_of(const std::string& node, double seconds) {
    run_tool::Process& process = daemons_.at(node);
    holds_within(seconds, [&] { return process.poll().has_value(); });
    return process.poll();
  }
  void stop(const std::string& node) { daemons_.at(node).send(SIGTERM); }
  std::vector<journal::Record> log_of(const std::string& node) {
    std::vector<journal::Record> records;
    std::ifstream file(path(node, ".log"));
    for (std::string line; std::getline(file, line);) {
      auto record = journal::parse_record(line);
      EXPECT_TRUE(record.has_value()) << line;
      if (record) records.push_back(std::move(*record));
    }
    return records;
  }
  std::string told_by(const std::string& node) {
    return run_tool::tail_of(path(node, ".stderr"), 20);
  }
  /// `skein spy WORDS` on the domain, to its end.
  Answered spy(std::vector<std::string> words) {
    words.insert(words.begin(), {kPrograms + "/skein", "spy", "--domain", domain()});
    auto process = run_tool::Process::start(words, path("spy", ".out"));
    EXPECT_TRUE(process.has_value());
    holds_within(30, [&] { return process->poll().has_value(); });
    return {process->poll() ? process->poll()->code : -1,
            run_tool::tail_of(path("spy", ".out"), 20)};
  }

 private:
  std::string domain() const { return std::to_string(lease_->domain()); }
  std::string path(const std::string& node, const char* kind) {
    return files_.file(node + kind).string();
  }
  void start(const std::string& node, std::vector<std::string> command) {
    command[0] = kPrograms + "/" + command[0];
    for (const std::string& word :
         {std::string("--scenario"), files_.file("scenario.yaml").string(), std::string("--domain"),
          domain(), std::string("--rate"), std::string("40"), std::string("--world"),
          std::string("off"), std::string("--log-to"), path(node, ".log")})
      command.push_back(word);
    auto process = run_tool::Process::start(command, path(node, ".stderr"));
    ASSERT_TRUE(process.has_value());
    daemons_.emplace(node, std::move(*process));
  }

  DdsRun files_;
  Result<blackboard::DomainLease, Failure> lease_;
  std::map<std::string, run_tool::Process> daemons_;
};

TEST(DdsFlight, AMissionIsFlownWithoutTheWorldAndEachNodeKeepsItsOwnEventLog) {
  Flight flight;
  const Answered log = flight.spy({"echo", "JournalEntry", "--once", "--timeout", "3"});
  EXPECT_EQ(log.code, 4) << log.text;
  EXPECT_THAT(log.text, HasSubstr("no writer"));
  EXPECT_EQ(flight.spy({"echo", "Clock", "--once", "--timeout", "1"}).code, 4);
  const Answered heard = flight.spy({"echo", "Telemetry", "--once", "--timeout", "20"});
  EXPECT_EQ(heard.code, 0) << heard.text;

  const auto ended = flight.end_of("ground", 150);

  ASSERT_TRUE(ended.has_value()) << flight.told_by("ground");
  EXPECT_EQ(ended->code, 0) << flight.told_by("ground");
  for (const char* node : {"marvin", "heliv", "karma", "autopilot"}) flight.stop(node);
  for (const char* node : {"marvin", "heliv", "karma", "autopilot"}) {
    const auto stopped = flight.end_of(node, 20);
    ASSERT_TRUE(stopped.has_value()) << node;
    EXPECT_EQ(stopped->code, 0) << node << flight.told_by(node);
    const auto records = flight.log_of(node);
    EXPECT_FALSE(records.empty()) << node;
    for (const journal::Record& one : records) EXPECT_EQ(one.node(), node);
  }
  std::map<std::string, int> commands, tasks;
  for (const journal::Record& one : flight.log_of("ground"))
    if (one.kind() == "command") ++commands[std::string(one.text("state"))];
  for (const char* uav : {"marvin", "heliv", "karma"})
    for (const journal::Record& one : flight.log_of(uav))
      if (one.kind() == "task" && one.text("state") == "ended") ++tasks[uav];
  EXPECT_GT(commands["issued"], 10);
  EXPECT_EQ(commands["issued"], commands["acknowledged"]);
  EXPECT_EQ(tasks.size(), 3U) << "each did something to its end";
}

TEST(DdsFlight, TheSimulatorIsTheWorldAndCannotDoWithoutIt) {
  DdsRun files;
  files.take_scenario("confirmed");
  const std::string log = files.file("sim.log").string();
  auto sim = run_tool::Process::start({kPrograms + "/skein-sim", "--scenario",
                                       files.file("scenario.yaml").string(), "--world", "off"},
                                      log);
  ASSERT_TRUE(sim.has_value());
  holds_within(20, [&] { return sim->poll().has_value(); });

  ASSERT_TRUE(sim->poll().has_value());
  EXPECT_EQ(sim->poll()->code, 2);
  EXPECT_THAT(run_tool::tail_of(log, 3), HasSubstr("the simulator is the world"));
}

}  // namespace
}  // namespace skein::testing
