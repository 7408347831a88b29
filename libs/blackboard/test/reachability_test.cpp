// SPDX-License-Identifier: Apache-2.0
// Reachability by our own heartbeats alone: links are cut by what carries the samples, in one
// direction or both, and nobody is told.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "skein/blackboard/blackboard.hpp"
#include "skein/blackboard/memory_transport.hpp"
#include "testing/memory_boards.hpp"

namespace skein::blackboard {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(200);
constexpr std::size_t kNodes = 3;

NodeNumber number(std::size_t node) { return NodeNumber(static_cast<std::uint32_t>(node + 1)); }
Node named(std::size_t node) { return {number(node), "n" + std::to_string(node)}; }
Duration periods(std::int64_t count) { return Duration::nanoseconds(kPeriod.count() * count); }

/// Nodes that all talk with each other, in steady time that passes from one wake-up to the next.
class Team {
 public:
  Team() {
    for (std::size_t node = 0; node < kNodes; ++node) {
      Config config;
      config.self = number(node);
      config.heartbeat_period = kPeriod;
      for (std::size_t other = 0; other < kNodes; ++other) {
        if (other == node) continue;
        for (const ChannelConfig& channel : radio_link(named(node), named(other)))
          config.channels.push_back(channel);
      }
      transports_.push_back(std::make_unique<MemoryTransport>(hub));
      boards_.push_back(std::make_unique<Blackboard>(
          std::move(*Blackboard::open(std::move(config), *transports_.back()))));
    }
    settle();
  }

  void run_until(Duration until) {
    while (true) {
      Duration next = until;
      for (const auto& board : boards_)
        if (const auto due = board->next_wakeup()) next = std::min(next, *due);
      now_ = std::max(now_, next);
      settle();
      if (now_ >= until) return;
    }
  }
  /// Whether `node` believes that it can hear `peer`.
  bool hears(std::size_t node, std::size_t peer) const {
    return boards_[node]->reachable(number(peer));
  }
  Duration now() const { return now_; }

  MemoryHub hub;

 private:
  // At one instant, until nobody has anything to do any more.
  void settle() {
    for (int round = 0; round < 6; ++round)
      for (const auto& board : boards_) board->step({MissionTime() + now_, now_});
  }

  Duration now_;
  std::vector<std::unique_ptr<MemoryTransport>> transports_;
  std::vector<std::unique_ptr<Blackboard>> boards_;
};

/// A directed link that changes from carrying to not and back.
struct Link {
  bool carries = true;
  Duration since;
};

TEST(Reachability, ACutThatNobodyTellsOfIsKnownWithinThreeHeartbeatsAndAReturnWithinTwo) {
  Team team;
  team.run_until(periods(3) + Duration::milliseconds(70));
  ASSERT_TRUE(team.hears(1, 0));

  team.hub.carry(number(0), number(1), false);
  const Duration cut = team.now();
  team.run_until(cut + periods(2) - Duration::milliseconds(80));
  EXPECT_TRUE(team.hears(1, 0)) << "two silent periods are no cut yet";
  team.run_until(cut + periods(3));
  EXPECT_FALSE(team.hears(1, 0));
  EXPECT_TRUE(team.hears(0, 1)) << "the other direction carries";
  EXPECT_TRUE(team.hears(2, 0)) << "and so do the links of the third";

  team.hub.carry(number(0), number(1), true);
  team.run_until(team.now() + periods(2));
  EXPECT_TRUE(team.hears(1, 0));
}

// Found by missions over mountains (--anything --minds --rough 104): amid a cut the link was there
// for a second, in which one heard the other, which so never lost it, and then did not greet.
TEST(Reachability, WhoHearsThatItIsNotHeardSaysSomethingAtOnce) {
  const Duration kSeldom = Duration::seconds(2);
  testing::MemoryBoards boards([](NodeNumber, Incoming&&) {});
  for (const std::size_t node : {0U, 1U}) {
    Config config;
    config.self = number(node);
    config.heartbeat_period = kSeldom;
    config.channels = radio_link(named(node), named(1 - node));
    boards.start(config);
  }
  const auto link = [&](double at, bool up) {
    boards.run_until(Duration::seconds(at));
    boards.set_condition(number(0), number(1), {.up = up, .latency = {}, .loss = 0});
  };
  link(10, false);
  link(14, true);
  link(15, false);
  boards.run_until(Duration::seconds(19));
  ASSERT_TRUE(boards[number(0)].reachable(number(1))) << "it heard it at 14 s";
  ASSERT_FALSE(boards[number(1)].reachable(number(0))) << "its greeting came too early";

  link(19, true);
  boards.settle();
  EXPECT_TRUE(boards[number(1)].reachable(number(0)));
}

// The third is there before three periods are over, whenever the two were lost.
TEST(Reachability, TwoHeartbeatsThatAreLostInARowAreNoCut) {
  for (int phase = 0; phase < 20; ++phase) {
    Team team;
    team.run_until(periods(3) + Duration::milliseconds(10 * phase));
    team.hub.carry(number(0), number(1), false);
    const Duration until = team.now() + Duration::milliseconds(360);
    const Duration judged = until + periods(2);
    while (team.now() < judged) {
      if (team.now() >= until) team.hub.carry(number(0), number(1), true);
      team.run_until(team.now() + Duration::milliseconds(10));
      ASSERT_TRUE(team.hears(1, 0)) << "cut at a phase of " << 10 * phase << " ms";
    }
  }
}

RC_GTEST_PROP(Reachability, FollowsEveryScheduleOfSilentCuts, ()) {
  using Change = std::tuple<std::uint8_t, std::uint8_t, std::uint16_t>;
  const auto changes = *rc::gen::container<std::vector<Change>>(rc::gen::tuple(
      rc::gen::inRange<std::uint8_t>(0, kNodes), rc::gen::inRange<std::uint8_t>(1, kNodes),
      rc::gen::inRange<std::uint16_t>(1, 1500)));
  Team team;
  std::map<std::pair<std::size_t, std::size_t>, Link> links;
  std::size_t judged = 0;
  const auto judge = [&](Duration at) {
    for (std::size_t from = 0; from < kNodes; ++from) {
      for (std::size_t to = 0; to < kNodes; ++to) {
        if (from == to) continue;
        const Link& link = links[{from, to}];
        if (at - link.since < periods(link.carries ? 2 : 3)) continue;
        RC_ASSERT(team.hears(to, from) == link.carries);
        ++judged;
      }
    }
  };
  for (const auto& [from, step, wait] : changes) {
    const std::size_t to = (from + std::size_t{step}) % kNodes;
    const Duration until = team.now() + Duration::milliseconds(wait);
    while (team.now() < until) {
      team.run_until(std::min(until, team.now() + Duration::milliseconds(50)));
      judge(team.now());
    }
    Link& link = links[{from, to}];
    link = {!link.carries, team.now()};
    team.hub.carry(number(from), number(to), link.carries);
  }
  team.run_until(team.now() + periods(3));
  judge(team.now());
  RC_ASSERT(judged > 0U);
}

}  // namespace
}  // namespace skein::blackboard
