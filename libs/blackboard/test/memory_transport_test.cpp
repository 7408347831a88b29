// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/memory_transport.hpp"
#include "skein/blackboard/link_instance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <vector>

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Pairs = std::vector<Pair>;

constexpr std::uint32_t kSimulator = 1;

wire::Sample state_of_link(const Pair& pair) {
  wire::LinkState state;
  state.header.origin = kSimulator;
  state.header.instance = link_instance(NodeNumber(pair.first), NodeNumber(pair.second));
  std::tie(state.from, state.to) = pair;
  return state;
}

/// Nodes that have the world in common.
class NodesOfAWorld {
 public:
  MemoryTransport& join(std::uint32_t number, const char* partition = "world") {
    ChannelConfig world = world_channel();
    world.partition = partition;
    auto node = std::make_unique<MemoryTransport>(hub_);
    EXPECT_TRUE(
        node->open({NodeNumber(number), {world}, {wire::Slot::kClock, wire::Slot::kLinkState}}));
    return *nodes_.insert_or_assign(number, std::move(node)).first->second;
  }
  void die(std::uint32_t number) { nodes_.erase(number); }
  void tell(const Pair& pair) { nodes_.at(kSimulator)->write(0, state_of_link(pair)); }
  /// What the node was told of links since the last question.
  Pairs heard(std::uint32_t number) {
    Pairs pairs;
    for (const Arrival& arrival : nodes_.at(number)->take()) {
      const auto& sample = std::get<wire::Sample>(arrival.content);
      if (const auto* link = std::get_if<wire::LinkState>(&sample))
        pairs.emplace_back(link->from, link->to);
    }
    return pairs;
  }

 private:
  MemoryHub hub_;
  std::map<std::uint32_t, std::unique_ptr<MemoryTransport>> nodes_;
};

class LinkStatesOfTheWorld : public ::testing::Test {
 protected:
  void SetUp() override { world.join(kSimulator); }
  NodesOfAWorld world;
};

TEST_F(LinkStatesOfTheWorld, ReachTheTwoTheyAreAbout) {
  for (const std::uint32_t node : {2, 3, 4}) world.join(node);

  world.tell({2, 3});

  EXPECT_THAT(world.heard(2), ElementsAre(Pair(2, 3)));
  EXPECT_THAT(world.heard(3), ElementsAre(Pair(2, 3)));
  EXPECT_THAT(world.heard(4), IsEmpty());
}

TEST_F(LinkStatesOfTheWorld, AllReachWhoListensByAPattern) {
  world.join(9, "*");

  world.tell({2, 3});
  world.tell({4, 2});

  EXPECT_THAT(world.heard(9), ElementsAre(Pair(2, 3), Pair(4, 2)));
}

TEST_F(LinkStatesOfTheWorld, WhoComesLateGetsTheLastOfEachThatIsAboutIt) {
  for (const Pair& pair : Pairs{{3, 2}, {2, 3}, {2, 4}, {3, 4}, {2, 3}}) world.tell(pair);

  world.join(3);
  world.join(9, "*");

  EXPECT_THAT(world.heard(3), ElementsAre(Pair(2, 3), Pair(3, 2), Pair(3, 4)));
  EXPECT_THAT(world.heard(9), ElementsAre(Pair(2, 3), Pair(2, 4), Pair(3, 2), Pair(3, 4)));
}

TEST_F(LinkStatesOfTheWorld, AClockReachesEverybodyAllTheSame) {
  MemoryTransport& other = world.join(5);

  world.join(kSimulator).write(0, wire::Clock{});

  EXPECT_EQ(other.take().size(), 1U);
}

TEST_F(LinkStatesOfTheWorld, TheNextLifeOfANodeGetsThemAndTheLastOneIsForgotten) {
  world.join(2);
  world.tell({2, 3});
  world.die(2);
  world.tell({2, 4});

  world.join(2);

  EXPECT_THAT(world.heard(2), ElementsAre(Pair(2, 3), Pair(2, 4)));
}

// The rule, said of each node by itself: what is about it, in the order in which it was told to who
// was there, the last of each to who was not.
RC_GTEST_PROP(LinkStates, AreThoseThatARuleOfEachNodeSays, ()) {
  NodesOfAWorld world;
  world.join(kSimulator);
  std::map<std::uint32_t, Pairs> expected;
  std::map<Pair, bool> told;
  const auto node = rc::gen::inRange<std::uint32_t>(2, 7);
  const auto steps = *rc::gen::container<std::vector<std::pair<bool, Pair>>>(
      rc::gen::pair(rc::gen::arbitrary<bool>(), rc::gen::pair(node, node)));
  for (const auto& [joins, pair] : steps) {
    const std::uint32_t one = pair.first;
    if (joins) {
      world.die(one);
      world.join(one);
      expected[one].clear();
      for (const auto& [kept, yes] : told)
        if (kept.first == one || kept.second == one) expected[one].push_back(kept);
    } else if (pair.first != pair.second) {
      world.tell(pair);
      told[pair] = true;
      for (auto& [there, pairs] : expected)
        if (there == pair.first || there == pair.second) pairs.push_back(pair);
    }
  }
  for (const auto& [there, pairs] : expected) RC_ASSERT(world.heard(there) == pairs);
}

}  // namespace
}  // namespace skein::blackboard
