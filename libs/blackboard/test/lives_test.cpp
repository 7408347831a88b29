// SPDX-License-Identifier: Apache-2.0
// A node that has no memory and no clock: its peers know which life of it this is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "testing/memory_boards.hpp"
#include "testing/samples.hpp"

namespace skein::blackboard {
namespace {

using testing::degree;
using ::testing::ElementsAre;
using testing::task_event;

const Node kGround{NodeNumber(1), "ground"};
const Node kUav{NodeNumber(2), "uav"};
const Node kPartner{NodeNumber(3), "partner"};
constexpr Duration kPeriod = Duration::milliseconds(200);

/// Three nodes of which the UAV is started again and again with any incarnation.
class Lives {
 public:
  Lives() {
    start(kGround, 1);
    start(kPartner, 1);
  }

  void start(const Node& node, std::uint64_t incarnation, bool guesses = false) {
    Config config;
    config.self = node.number;
    config.incarnation = incarnation;
    config.guesses_incarnation = guesses;
    config.heartbeat_period = kPeriod;
    for (const Node& other : {kGround, kUav, kPartner}) {
      if (other.number == node.number) continue;
      const bool of_ground = node.number == kGround.number || other.number == kGround.number;
      const Node& uav = node.number == kGround.number ? other : node;
      for (const auto& channel : of_ground ? station_link(kGround, uav) : radio_link(node, other))
        config.channels.push_back(channel);
    }
    config.channels.push_back(world_channel());
    config.world_reads = {wire::Slot::kDirectoryEntry};
    incoming_[node.number].clear();
    boards_.start(config);
  }
  void kill(const Node& node) { boards_.kill(node.number); }
  Blackboard& operator[](const Node& node) { return boards_[node.number]; }
  Now now() const { return boards_.now(); }
  void run_for(Duration span) { boards_.run_until(boards_.time() + span); }
  void send(const Node& from, const Node& to, wire::Sample sample) {
    ASSERT_TRUE((*this)[from].send(std::move(sample), to.number, now()).has_value());
  }
  void inject(const std::string& partition, const wire::Sample& sample) {
    boards_.hub().inject(partition, sample);
  }
  template <class T>
  std::vector<T> all(const Node& node) const {
    std::vector<T> found;
    for (const Incoming& one : incoming_.at(node.number))
      if (const auto* it = std::get_if<T>(&one)) found.push_back(*it);
    return found;
  }
  std::vector<std::uint64_t> events(const Node& node) const {
    std::vector<std::uint64_t> ids;
    for (const Received& one : all<Received>(node))
      if (const auto* event = std::get_if<wire::TaskEvent>(&one.sample)) ids.push_back(event->id);
    return ids;
  }

 private:
  std::map<NodeNumber, std::vector<Incoming>> incoming_;  ///< of its present life
  testing::MemoryBoards boards_{[this](NodeNumber node, Incoming&& incoming) {
    incoming_[node].push_back(std::move(incoming));
  }};
};

constexpr Duration kLong = Duration::milliseconds(2'000);

TEST(Lives, ANodeWhoseClockStoodBackIsTheNextLifeToAPeerThatKnewALaterOne) {
  Lives lives;
  lives.start(kUav, 1'000);
  lives.run_for(kLong);
  lives.kill(kUav);
  lives.run_for(kLong);

  lives.start(kUav, 7, true);
  lives.send(kUav, kGround, degree(4));
  lives.send(kUav, kGround, task_event(1));
  lives.run_for(kLong);

  EXPECT_TRUE(lives[kGround].reachable(kUav.number));
  EXPECT_TRUE(lives[kUav].reachable(kGround.number));
  EXPECT_THAT(lives.events(kGround), ElementsAre(1));
  const auto received = lives.all<Received>(kGround);
  EXPECT_TRUE(std::ranges::any_of(received, [](const Received& one) {
    return std::holds_alternative<wire::AutonomyDegree>(one.sample);
  })) << "states are said again too";
  EXPECT_EQ(lives[kUav].unacknowledged(kGround.number), 0U);
  const auto told = lives.all<TakenForOlder>(kUav);
  ASSERT_EQ(told.size(), 2U) << "ground and partner";
  EXPECT_TRUE(told[0].is_next);
  EXPECT_EQ(told[0].heard, 1'000U);
  EXPECT_TRUE(lives.all<Reachability>(kGround).back().reachable);
}

TEST(Lives, ItsWordsToTheWorldCountToo) {
  Lives lives;
  lives.start(kUav, 1'000);
  wire::DirectoryEntry entry;
  entry.name = "uav";
  ASSERT_TRUE(lives[kUav].publish(entry, lives.now()));
  lives.run_for(kLong);
  lives.kill(kUav);
  lives.run_for(kLong);

  lives.start(kUav, 7, true);
  entry.ready = true;
  ASSERT_TRUE(lives[kUav].publish(entry, lives.now()));
  lives.run_for(kLong);

  const auto received = lives.all<Received>(kGround);
  EXPECT_TRUE(std::ranges::any_of(received, [](const Received& one) {
    const auto* it = std::get_if<wire::DirectoryEntry>(&one.sample);
    return it != nullptr && it->ready;
  }));
}

// The partner never met the former life: to it nothing changes, and nothing is handled twice.
TEST(Lives, ToAPeerThatKnewNoLaterLifeNothingChanges) {
  Lives lives;
  lives.kill(kPartner);
  lives.start(kUav, 1'000);
  lives.run_for(kLong);
  lives.kill(kUav);
  lives.kill(kGround);
  lives.start(kPartner, 1);
  lives.start(kUav, 7, true);
  lives.run_for(kLong);
  lives.send(kUav, kPartner, task_event(1));
  lives.run_for(kLong);
  ASSERT_THAT(lives.events(kPartner), ElementsAre(1));

  lives.start(kGround, 2);
  lives.run_for(kLong);
  lives.send(kUav, kPartner, task_event(2));
  lives.run_for(kLong);

  EXPECT_THAT(lives.events(kPartner), ElementsAre(1, 2));
  for (const Reachability& one : lives.all<Reachability>(kPartner)) EXPECT_FALSE(one.restarted);
}

TEST(Lives, WithoutLeaveToGuessANodeSaysThatItIsTakenForOlderAndIsHeardAsWhatItIs) {
  Lives lives;
  lives.start(kUav, 1'000);
  lives.run_for(kLong);
  lives.kill(kUav);
  lives.run_for(kLong);

  lives.start(kUav, 7);
  lives.send(kUav, kGround, degree(4));
  lives.send(kUav, kGround, task_event(1));
  lives.run_for(kLong);

  EXPECT_TRUE(lives[kGround].reachable(kUav.number));
  EXPECT_THAT(lives.events(kGround), ElementsAre(1));
  const auto told = lives.all<TakenForOlder>(kUav);
  ASSERT_EQ(told.size(), 2U) << "once for each peer";
  EXPECT_FALSE(told[0].is_next);
}

// Two that run at once under one name: the second is heard, the first says so and does not climb.
TEST(Lives, OneThatWasHeardDoesNotClimbOverARival) {
  Lives lives;
  lives.start(kUav, 7, true);
  lives.run_for(kLong);
  ASSERT_TRUE(lives[kGround].reachable(kUav.number));

  wire::Heartbeat rival;
  rival.header.origin = kUav.number.value();
  rival.header.destination = kGround.number.value();
  rival.header.incarnation = 50;
  rival.header.sequence_number = 1;
  lives.inject("radio/uav>ground", rival);
  lives.run_for(kLong);

  const auto told = lives.all<TakenForOlder>(kUav);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_FALSE(told[0].is_next);
  EXPECT_EQ(told[0].heard, 50U);
}

// Whatever numbers the clocks of its lives give (in nanoseconds, so never the same nor next to each
// other), each life is heard by everybody who is in reach, and what it sends is handled once and in
// order.
RC_GTEST_PROP(Lives, EachLifeIsHeardWhateverItsClockSays, ()) {
  const auto clocks = *rc::gen::nonEmpty(
      rc::gen::unique<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>()));
  const bool guesses = *rc::gen::arbitrary<bool>();
  Lives lives;
  std::uint64_t id = 0;
  std::vector<std::uint64_t> sent;
  for (const std::uint8_t clock : clocks) {
    lives.start(kUav, 1'000 * (1U + clock), guesses);
    lives.run_for(kLong);
    for (const Node& peer : {kGround, kPartner}) RC_ASSERT(lives[peer].reachable(kUav.number));
    for (int i = 0; i < 3; ++i) {
      sent.push_back(++id);
      lives.send(kUav, kGround, task_event(id));
      lives.send(kUav, kPartner, task_event(id));
    }
    lives.run_for(kLong);
    lives.kill(kUav);
    lives.run_for(kLong);
  }
  RC_ASSERT(lives.events(kGround) == sent);
  RC_ASSERT(lives.events(kPartner) == sent);
}

}  // namespace
}  // namespace skein::blackboard
