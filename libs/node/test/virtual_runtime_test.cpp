// SPDX-License-Identifier: Apache-2.0
#include "skein/node/virtual_runtime.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>

#include "testing/fake_node.hpp"
#include "testing/ping_system.hpp"

namespace skein::node {
namespace {

using journal::Record;
using testing::abort_request;
using testing::at;
using testing::Diary;
using testing::FakeNode;
using testing::PingSystem;
using End = VirtualOutcome::End;

Record note(MissionTime when, const std::string& node, std::uint64_t number = 0) {
  return Record(when, node, "note").with("number", number);
}

// A system of fakes; each node's diary stays over its restarts.
class Virtual : public ::testing::Test {
 protected:
  VirtualOutcome run(const std::function<bool(MissionTime)>& keep_going = {}) {
    return run_virtual(
        roster_, [this](const std::string& name) { return std::make_unique<FakeNode>(of[name]); },
        config, [this](const Record& record) { records.push_back(record); }, keep_going);
  }

  // Wakes the node at these instants; it writes a note each time.
  void note_at(const std::string& name, std::vector<double> instants) {
    Diary& diary = of[name];
    const auto left = std::make_shared<std::vector<double>>(std::move(instants));
    diary.wakeup = at(left->front());
    diary.answer = [&diary, left, name](const Input& input, MissionTime now) -> Effects {
      if (!std::holds_alternative<Wakeup>(input)) return {};
      left->erase(left->begin());
      if (!left->empty()) diary.wakeup = at(left->front());
      return {Log{note(now, name)}};
    };
  }

  std::vector<std::string> lines(const std::string& kind) const {
    std::vector<std::string> found;
    for (const Record& record : records) {
      if (record.kind() == kind) found.push_back(to_json(record));
    }
    return found;
  }

  Roster roster_{{"a", "b"}};
  std::map<std::string, Diary> of;
  VirtualConfig config{.time_limit = at(20), .crashes = {}};
  std::vector<Record> records;
};

TEST_F(Virtual, EveryNodeButTheRunnerIsStartedOnce) {
  run();

  for (const char* name : {"ground", "sim", "a", "b"}) {
    ASSERT_EQ(of[name].all<Started>().size(), 1U) << name;
    EXPECT_EQ(of[name].all<Started>()[0].incarnation, 1U);
  }
  EXPECT_EQ(of.count("runner"), 0U);
}

TEST_F(Virtual, WakeupsComeAtTheirInstantsInOrder) {
  note_at("b", {1, 2.5, 4});
  note_at("a", {0.5, 3});

  run();

  EXPECT_EQ(lines("note"),
            (std::vector<std::string>{R"({"at":0.5,"node":"a","kind":"note","number":0})",
                                      R"({"at":1,"node":"b","kind":"note","number":0})",
                                      R"({"at":2.5,"node":"b","kind":"note","number":0})",
                                      R"({"at":3,"node":"a","kind":"note","number":0})",
                                      R"({"at":4,"node":"b","kind":"note","number":0})"}));
}

TEST_F(Virtual, AtOneInstantNodesGoInTheOrderOfTheRoster) {
  for (const char* name : {"b", "sim", "a", "ground"}) note_at(name, {7});

  run();

  ASSERT_EQ(lines("note").size(), 4U);
  std::string order;
  for (const Record& record : records) {
    if (record.kind() == "note") order += record.node() + " ";
  }
  EXPECT_EQ(order, "ground sim a b ");
}

TEST_F(Virtual, TheTimeLimitEndsARun) {
  note_at("a", {19, 20, 20.5});

  const auto outcome = run();

  EXPECT_EQ(outcome.end, End::kTimeLimit);
  EXPECT_EQ(outcome.at, at(20));
  EXPECT_EQ(lines("note").size(), 2U);
  EXPECT_GT(outcome.steps, 0U);
}

TEST_F(Virtual, FinishEndsARunSoonAfter) {
  of["ground"].wakeup = at(5);
  of["ground"].answer = [](const Input& input, MissionTime) -> Effects {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {Send{NodeNumber(10), abort_request(1)}, Finish{}};
  };
  note_at("b", {6, 8});

  const auto outcome = run();

  EXPECT_EQ(outcome.end, End::kFinished);
  EXPECT_GE(outcome.at, at(6));
  EXPECT_LE(outcome.at, at(7));
  EXPECT_EQ(of["a"].samples<wire::TaskRequest>().size(), 1U);  // last messages are still handled
  EXPECT_EQ(lines("note").size(), 1U);
}

TEST_F(Virtual, ARunThatNobodyIsLeftInEnds) {
  for (const char* name : {"ground", "sim", "a", "b"}) {
    config.crashes.push_back({at(3), name, std::nullopt});
  }

  const auto outcome = run();

  EXPECT_EQ(outcome.end, End::kNothingLeftToDo);
  EXPECT_EQ(outcome.at, at(3));
}

TEST_F(Virtual, WhoeverWatchesCanStopIt) {
  std::vector<MissionTime> asked;

  const auto outcome = run([&](MissionTime now) {
    asked.push_back(now);
    return now < at(5);
  });

  EXPECT_EQ(outcome.end, End::kStopped);
  EXPECT_GE(outcome.at, at(5));
  EXPECT_LE(outcome.at, at(7)) << "at the first wake-up a second after it was asked last";
  for (std::size_t i = 1; i < asked.size(); ++i) {
    EXPECT_GE(asked[i] - asked[i - 1], Duration::seconds(1));
  }
}

TEST_F(Virtual, AJobsResultComesBackAfterItsLatency) {
  config.jobs = {Duration::seconds(0.75), Duration::seconds(0.75)};
  of["a"].wakeup = at(2);
  of["a"].answer = [](const Input& input, MissionTime) -> Effects {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {StartJob{9, [](const TimeIsUp&) { return std::any(42); }}};
  };

  run();

  const auto done = of["a"].all<JobDone>();
  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].id, 9U);
  EXPECT_EQ(std::any_cast<int>(done[0].result), 42);
  for (const auto& [when, input] : of["a"].inputs) {
    if (std::holds_alternative<JobDone>(input)) {
      EXPECT_EQ(when, at(2.75));
    }
  }
}

TEST_F(Virtual, AJobThatStartsAnotherWithoutLatencyComesBackAtTheSameInstant) {
  config.jobs = {Duration(), Duration()};
  of["a"].wakeup = at(2);
  of["a"].answer = [](const Input& input, MissionTime) -> Effects {
    const auto* done = std::get_if<JobDone>(&input);
    const std::uint64_t next = done == nullptr ? 1 : done->id + 1;
    if ((done == nullptr && !std::holds_alternative<Wakeup>(input)) || next > 3) return {};
    return {StartJob{next, [](const TimeIsUp&) { return std::any(); }}};
  };

  run();

  EXPECT_EQ(of["a"].all<JobDone>().size(), 3U);
}

TEST_F(Virtual, AJobsResultDoesNotReachTheNextIncarnation) {
  config.jobs = {Duration::seconds(2), Duration::seconds(2)};
  config.crashes = {{at(3), "a", at(3.5)}};
  of["a"].wakeup = at(2);
  of["a"].answer = [](const Input& input, MissionTime) -> Effects {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {StartJob{9, [](const TimeIsUp&) { return std::any(); }}};
  };

  run();

  EXPECT_EQ(of["a"].all<Started>().size(), 2U);
  EXPECT_TRUE(of["a"].all<JobDone>().empty());
}

TEST_F(Virtual, ACrashedNodeIsStartedAgainAsANewIncarnation) {
  config.crashes = {{at(3), "a", at(4)}};

  run();

  const auto started = of["a"].all<Started>();
  ASSERT_EQ(started.size(), 2U);
  EXPECT_EQ(started[1].incarnation, 2U);
  EXPECT_TRUE(started[0].first_life);
  EXPECT_FALSE(started[1].first_life);
  EXPECT_EQ(lines("fault"),
            (std::vector<std::string>{
                R"({"at":3,"node":"runner","kind":"fault","what":"kill","target":"a"})",
                R"({"at":4,"node":"runner","kind":"fault","what":"restart","target":"a"})"}));
  bool seen = false;
  for (const Reachability& reach : of["b"].all<Reachability>()) {
    seen = seen || (reach.peer == NodeNumber(10) && reach.restarted);
  }
  EXPECT_TRUE(seen);
}

TEST_F(Virtual, ADeadNodeIsGivenNothing) {
  config.crashes = {{at(3), "a", std::nullopt}};
  note_at("a", {1, 5});

  run();

  EXPECT_EQ(lines("note").size(), 1U);
  for (const auto& [when, input] : of["a"].inputs) EXPECT_LE(when, at(3));
  EXPECT_FALSE(of["b"].all<Reachability>().back().reachable);
}

TEST_F(Virtual, CrashesThatOverlapKillAndRestartOnce) {
  config.crashes = {{at(3), "a", at(6)}, {at(4), "a", at(8)}};

  run();

  EXPECT_EQ(lines("fault").size(), 2U);
  EXPECT_EQ(of["a"].all<Started>().size(), 2U);
}

TEST_F(Virtual, AnEventSentToADeadNodeReachesItsNextLife) {
  config.crashes = {{at(3), "a", at(10)}};
  of["ground"].wakeup = at(5);
  of["ground"].answer = [](const Input& input, MissionTime) -> Effects {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {Send{NodeNumber(10), abort_request(1)}};
  };

  run();

  ASSERT_EQ(of["a"].samples<wire::TaskRequest>().size(), 1U);
}

TEST_F(Virtual, ALinkThatTheSimulatorCutsIsCut) {
  of["sim"].wakeup = at(1);
  of["sim"].answer = [](const Input& input, MissionTime) -> Effects {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {Publish{testing::link(NodeNumber(1), NodeNumber(10), false)},
            Publish{testing::link(NodeNumber(10), NodeNumber(1), false)}};
  };

  run();

  EXPECT_FALSE(of["ground"].all<Reachability>().back().reachable);
}

TEST(VirtualRuntimeDeterminism, TheSameSeedGivesTheSameBytes) {
  PingSystem system;
  system.seed = 7;
  system.uavs = 3;
  system.crashes = {{at(6), "uav-1", at(9)}, {at(8), "ground", at(8.5)}};
  system.cuts = {{"ground", "uav-0", at(3), at(7)}, {"uav-0", "uav-2", at(5), at(15)}};

  const auto first = system.play();
  const auto second = system.play();

  EXPECT_GT(first.log.size(), 10'000U);
  EXPECT_EQ(first.log, second.log);
  EXPECT_EQ(first.outcome.steps, second.outcome.steps);
}

/// What `node` found out about `peer`, with the instants.
std::vector<std::pair<double, bool>> reach_of(const std::string& log, const std::string& node,
                                              const std::string& peer) {
  std::vector<std::pair<double, bool>> found;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    const auto record = nlohmann::json::parse(line);
    if (record["kind"] != "reach" || record["node"] != node || record["peer"] != peer) continue;
    found.emplace_back(record["at"], record["reachable"]);
  }
  return found;
}

TEST(VirtualRuntime, NodesFindOutByThemselvesWhatTheRadioCuts) {
  PingSystem system;
  system.uavs = 2;
  system.cuts = {{"ground", "uav-0", at(5.3), at(11.7)}};
  system.silent = true;
  system.loss = 0;

  const auto played = system.play();

  for (const auto& [node, peer] : {std::pair("ground", "uav-0"), std::pair("uav-0", "ground")}) {
    const auto reach = reach_of(played.log, node, peer);
    ASSERT_EQ(reach.size(), 3U) << node << ": heard, lost, heard again";
    EXPECT_FALSE(reach[1].second);
    EXPECT_GE(reach[1].first, 5.3 + 2);
    EXPECT_LE(reach[1].first, 5.3 + 3 + 0.04) << "within three heartbeats of a second";
    EXPECT_TRUE(reach[2].second);
    EXPECT_LE(reach[2].first, 11.7 + 2);
  }
  EXPECT_EQ(reach_of(played.log, "ground", "uav-1").size(), 1U) << "the other link holds";
  EXPECT_EQ(played.violation, "");
}

TEST(VirtualRuntimeDeterminism, AnotherSeedGivesAnotherRun) {
  PingSystem system;
  system.seed = 7;
  const auto first = system.play();
  system.seed = 8;

  const auto second = system.play();

  EXPECT_NE(first.log, second.log);
}

// Random small systems of nodes that talk all the time, under random cuts and crashes: a run comes
// to its end, is the same each time, and what is received was sent, in order, and once by each
// incarnation.
RC_GTEST_PROP(VirtualRuntimeDeterminism, HoldsUnderRandomCutsAndCrashes, (std::uint64_t seed)) {
  const PingSystem system = PingSystem::random(seed);

  const auto first = system.play();
  const auto second = system.play();

  RC_ASSERT(first.outcome.end == End::kTimeLimit || first.outcome.end == End::kNothingLeftToDo);
  RC_ASSERT(first.log == second.log);
  RC_ASSERT(first.violation == "");
}

}  // namespace
}  // namespace skein::node
