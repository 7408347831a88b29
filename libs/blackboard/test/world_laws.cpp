// SPDX-License-Identifier: Apache-2.0
// Laws of the world channel that hold over every transport: of two processes with one name the
// first is the node to those who are no peers of it. Built once for each transport.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "testing/laws.hpp"

namespace skein::blackboard::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// The ground station publishes; the simulator, which is no peer of it, reads.
class WorldLaws : public BlackboardLaws {
 protected:
  void SetUp() override {
    system.start(kSim);
    system.start(kGround);
    publish(system[kGround], line("1"));
    ASSERT_TRUE(system.run_until([&] { return lines().size() == 1; }));
    // Heartbeats have no history: the first one shows that they are heard.
    run_for(Duration::milliseconds(2'500));
  }
  static wire::JournalEntry line(const std::string& text) {
    wire::JournalEntry entry;
    entry.record = text;
    return entry;
  }
  static wire::DirectoryEntry entry(bool ready) {
    wire::DirectoryEntry entry;
    entry.name = "ground";
    entry.ready = ready;
    return entry;
  }
  void publish(Blackboard& from, wire::Sample sample) {
    ASSERT_TRUE(from.publish(std::move(sample), system.now()));
  }
  /// What the simulator has heard.
  std::vector<std::string> lines() {
    std::vector<std::string> texts;
    for (const auto& entry : system.values<wire::JournalEntry>(kSim)) texts.push_back(entry.record);
    return texts;
  }
  std::vector<bool> readiness() {
    std::vector<bool> said;
    for (const auto& entry : system.values<wire::DirectoryEntry>(kSim))
      if (entry.header.origin == kGround.number.value()) said.push_back(entry.ready);
    return said;
  }
  /// How often it has named something that it refused.
  std::vector<std::string> named() {
    std::vector<std::string> fields;
    for (const Dropped& one : system.reports<Dropped>(kSim))
      if (one.first && !one.why.ends_with(" times)")) fields.push_back(one.field);
    return fields;
  }
  bool is_named() { return !named().empty(); }
  bool run_until_heard(const std::string& text) {
    return system.run_until([&] { return !lines().empty() && lines().back() == text; });
  }
  void run_for(Duration span) {
    const Duration until = system.now().steady + span;
    ASSERT_TRUE(system.run_until([&] { return system.now().steady >= until; }));
  }
};

TEST_F(WorldLaws, ASecondProcessIsRefusedCountedAndNamedOnce) {
  system.start_second(kGround);
  ASSERT_TRUE(system.run_until([&] { return is_named(); }));
  const std::size_t before = system.reports<Dropped>(kSim).size();
  publish(system.second(kGround), line("of the second"));
  publish(system[kGround], line("2"));

  ASSERT_TRUE(run_until_heard("2"));
  ASSERT_TRUE(system.run_until([&] { return system.reports<Dropped>(kSim).size() > before; }));
  EXPECT_THAT(lines(), ElementsAre("1", "2"));
  EXPECT_THAT(named(), ElementsAre("header.incarnation"));
}

// Until it is known that both run the second is heard, as a node that was started again is.
TEST_F(WorldLaws, NoLineOfTheFirstIsLostBecauseASecondProcessSpeaks) {
  system.start_second(kGround);
  publish(system.second(kGround), line("of the second"));
  ASSERT_TRUE(run_until_heard("of the second"));
  publish(system[kGround], line("2"));
  ASSERT_TRUE(run_until_heard("2"));
  ASSERT_TRUE(system.run_until([&] { return is_named(); }));
  publish(system[kGround], line("3"));

  ASSERT_TRUE(run_until_heard("3"));
  EXPECT_THAT(lines(), ElementsAre("1", "of the second", "2", "3"));
}

// Who has just begun to listen knows the first by what it said, and no heartbeat of it yet.
TEST_F(WorldLaws, TheFirstIsTheNodeAlsoToWhoHearsTheSecondsHeartbeatBeforeOneOfIts) {
  system.start(kSim);
  ASSERT_TRUE(system.run_until([&] { return lines().size() == 1; }));
  system.start_second(kGround);
  ASSERT_TRUE(system.run_until([&] { return is_named(); }));
  publish(system.second(kGround), line("of the second"));
  publish(system[kGround], line("2"));

  ASSERT_TRUE(run_until_heard("2"));
  EXPECT_THAT(lines(), ElementsAre("1", "2"));
}

TEST_F(WorldLaws, TheLastValueIsThatOfTheFirst) {
  publish(system[kGround], entry(true));
  ASSERT_TRUE(system.run_until([&] { return readiness().size() == 1; }));
  system.start_second(kGround);
  publish(system.second(kGround), entry(false));
  ASSERT_TRUE(system.run_until([&] { return readiness().size() == 2; }));

  ASSERT_TRUE(system.run_until([&] { return is_named(); }));
  EXPECT_THAT(readiness(), ElementsAre(true, false, true));
}

TEST_F(WorldLaws, TheSecondIsTheNodeOnceTheFirstIsSilent) {
  system.start_second(kGround);
  ASSERT_TRUE(system.run_until([&] { return is_named(); }));
  publish(system.second(kGround), entry(true));
  run_for(Duration::milliseconds(100));
  ASSERT_THAT(readiness(), IsEmpty());
  system.kill(kGround);

  ASSERT_TRUE(system.run_until([&] { return readiness().size() == 1; }));
  publish(system.second(kGround), line("of the second"));
  EXPECT_TRUE(run_until_heard("of the second"));
}

// Who begins to listen while two run hears the later one. Once that is gone the other is the node.
TEST_F(WorldLaws, TheFirstIsHeardAgainByWhoHasHeardTheSecondAlone) {
  system.kill(kSim);
  system.start_second(kGround);
  run_for(Duration::milliseconds(500));
  system.start(kSim);
  publish(system.second(kGround), line("of the second"));
  ASSERT_TRUE(run_until_heard("of the second"));
  run_for(Duration::milliseconds(2'500));
  system.kill_second(kGround);

  ASSERT_TRUE(system.run_until([&] {
    publish(system[kGround], line("2"));
    publish(system[kGround], entry(true));
    return lines().back() == "2" && !readiness().empty();
  }));
  EXPECT_TRUE(readiness().back());
}

TEST_F(WorldLaws, ARestartIsHeardAtOnceAndNotTakenForASecondProcess) {
  system.kill(kGround);
  system.start(kGround);
  publish(system[kGround], line("2"));
  publish(system[kGround], entry(true));

  ASSERT_TRUE(run_until_heard("2"));
  ASSERT_TRUE(system.run_until([&] { return readiness().size() == 1; }));
  run_for(Duration::milliseconds(4'000));
  publish(system[kGround], line("3"));
  ASSERT_TRUE(run_until_heard("3"));
  EXPECT_THAT(lines(), ElementsAre("1", "2", "3"));
  EXPECT_THAT(system.reports<Dropped>(kSim), SizeIs(0));
}

}  // namespace
}  // namespace skein::blackboard::testing
