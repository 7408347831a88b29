// SPDX-License-Identifier: Apache-2.0
// Networks under names: what they say is what one built from scratch says.
#include "skein/temporal/live_network.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "random_stnu.hpp"
#include "skein/temporal/live_stn.hpp"

namespace skein::temporal {
namespace {

using testing::draw;

NodeName node(std::uint64_t key) { return {0, key}; }
LinkName link(std::uint64_t key) { return {0, key, 0, 0}; }

TEST(LiveNetwork, ATaskIsKnownByItsNames) {
  LiveNetwork network;
  network.add_node(node(1));
  network.add_node(node(2));

  network.set_link(link(7), {node(1), node(2), 2, 5, true});
  network.set_link(link(8), {node(1), node(2), kMinusInfinite, 4, false});
  const LiveVerdict broken = network.settle();
  network.remove_link(link(8));

  EXPECT_TRUE(broken.consistent);
  EXPECT_FALSE(broken.controllable);
  EXPECT_EQ(broken.conflict.size(), 2U);
  for (const NamedTerm& term : broken.conflict) EXPECT_GE(term.link.key, 7U);
  EXPECT_TRUE(network.settle().controllable);
}

TEST(LiveNetwork, ANodeThatComesAgainIsOfAnotherEpoch) {
  LiveNetwork network;
  network.add_node(node(1));
  network.add_node({4, 1});
  const auto former = network.epoch(node(1));
  const auto of_another_agent = network.epoch({4, 1});

  network.remove_node(node(1));
  const auto gone = network.epoch(node(1));
  network.add_node(node(1));

  EXPECT_FALSE(gone.has_value());
  EXPECT_GT(network.epoch(node(1)), former);
  EXPECT_EQ((network.epoch({4, 1})), of_another_agent);
}

TEST(LiveNetwork, TheLinksOfANodeGoWithIt) {
  LiveNetwork network;
  network.add_node(node(1));
  network.add_node(node(2));
  network.set_link(link(1), {LiveNetwork::kOrigin, node(1), 10, kInfinite, false});
  network.set_link(link(2), {node(1), node(2), 10, kInfinite, false});
  network.set_link(link(3), {LiveNetwork::kOrigin, node(2), kMinusInfinite, 5, false});
  const bool before = network.settle().consistent;

  network.remove_node(node(1));

  EXPECT_FALSE(before);
  EXPECT_TRUE(network.settle().controllable);
  EXPECT_EQ(network.link_count(), 1U);
}

TEST(LiveNetwork, SaysWhatWaitsForWhom) {
  LiveNetwork network;
  for (const std::uint64_t key : {1U, 2U, 3U}) network.add_node(node(key));
  network.set_link(link(1), {node(1), node(2), 10, 100, true});
  network.set_link(link(2), {node(3), node(2), kMinusInfinite, 20, false});

  ASSERT_TRUE(network.settle().controllable);

  const std::vector<NamedWait> waits = network.waits();
  ASSERT_EQ(waits.size(), 1U);
  EXPECT_EQ(waits.front().node, network.index(node(3)));
  EXPECT_EQ(waits.front().link, link(1));
  EXPECT_EQ(waits.front().delay, 80);
}

// The end comes up to 6 after its activation, and at most 7 after another node: that must not come
// more than 1 before the activation.
TEST(LiveNetwork, SaysWhatFollowsWhateverNatureDoes) {
  LiveNetwork network;
  for (const std::uint64_t key : {1U, 2U, 3U}) network.add_node(node(key));
  network.set_link(link(1), {node(1), node(2), 4, 6, true});
  network.set_link(link(2), {node(3), node(2), kMinusInfinite, 7, false});

  ASSERT_TRUE(network.settle().controllable);

  EXPECT_TRUE(network.waits().empty());
  const DistanceEdge expected{*network.index(node(3)), *network.index(node(1)), 1};
  EXPECT_EQ(network.implied(), std::vector<DistanceEdge>{expected});
}

/// Nodes and links under names, changed at random.
class Names {
 public:
  explicit Names(std::uint64_t seed) : random_(seed) {}

  void change(LiveNetwork& network, LiveStn& dates) {
    const std::uint64_t key = 1 + random_.below(6);
    if (!network.index(node(key))) {
      network.add_node(node(key));
    } else if (random_.chance(0.1)) {
      return drop(network, dates, key);
    }
    const std::uint64_t other = random_.below(7);
    const NodeName from = other == 0 ? LiveNetwork::kOrigin : node(other);
    if (other == key || !network.index(from)) return;
    const LinkName name = link(random_.below(14));
    remove(network, dates, name);
    if (random_.chance(0.25)) return;
    LiveLink wanted{from, node(key), draw(-9, 9, random_), 0, false};
    wanted.max = wanted.min + draw(0, 15, random_);
    if (random_.chance(0.3)) wanted.min = kMinusInfinite;
    if (random_.chance(0.3) && wanted.min != kMinusInfinite) wanted.max = kInfinite;
    const bool ends = std::any_of(links_.begin(), links_.end(), [&](const auto& one) {
      return one.second.contingent && one.second.to == wanted.to;
    });
    wanted.contingent = wanted.min > 0 && wanted.max != kInfinite && !ends;
    links_[name] = wanted;
    dates.set(name.key,
              {*network.index(wanted.from), *network.index(wanted.to), wanted.min, wanted.max});
    network.set_link(name, wanted);
  }

 private:
  void remove(LiveNetwork& network, LiveStn& dates, const LinkName& name) {
    network.remove_link(name);
    dates.erase(name.key);
    links_.erase(name);
  }
  void drop(LiveNetwork& network, LiveStn& dates, std::uint64_t key) {
    const auto links = links_;
    for (const auto& [name, one] : links) {
      if (one.from == node(key) || one.to == node(key)) remove(network, dates, name);
    }
    network.remove_node(node(key));
  }

  Random random_;
  std::map<LinkName, LiveLink> links_;
};

RC_GTEST_PROP(LiveNetwork, AgreesWithItsNetworkFromScratchAfterAnyChanges, (std::uint64_t seed)) {
  Random random(seed);
  Names names(seed);
  LiveNetwork network;
  LiveStn dates;

  for (int step = 0; step < 80; ++step) {
    for (std::uint64_t i = 0; i <= random.below(3); ++i) names.change(network, dates);
    const LiveVerdict& verdict = network.settle();
    dates.settle();

    const Stnu plain = network.network();
    const auto scratch = check_dynamic_controllability(plain);
    RC_ASSERT(verdict.controllable == scratch->controllable);
    RC_ASSERT(verdict.consistent == scratch->consistent);
    RC_ASSERT(dates.consistent() == scratch->consistent);
  }
}

TEST(LiveNetwork, MostSmallChangesAreSettledWhereTheyAre) {
  LiveNetwork network;
  LiveStn dates;
  Names names(3);
  for (int step = 0; step < 500; ++step) {
    names.change(network, dates);
    network.settle();
  }
  EXPECT_GT(network.settled_locally(), 50U);
}

TEST(LiveStn, OfLinksBetweenTheSameNodesTheStrongestCounts) {
  LiveStn network;
  network.set(1, {0, 1, 5, 20});
  network.set(2, {0, 1, 8, kInfinite});
  network.settle();
  EXPECT_EQ(network.earliest(1), 8);

  network.erase(2);
  network.set(3, {1, 0, -12, kInfinite});
  network.settle();

  EXPECT_EQ(network.earliest(1), 5);
  EXPECT_EQ(network.latest(1), 12);
}

TEST(LiveStn, LinksThatContradictEachOtherAreInconsistentUntilOneGoes) {
  LiveStn network;
  network.set(1, {0, 1, 5, kInfinite});
  network.set(2, {0, 1, kMinusInfinite, 4});
  network.settle();
  const bool before = network.consistent();

  network.erase(1);
  network.settle();

  EXPECT_FALSE(before);
  EXPECT_TRUE(network.consistent());
  EXPECT_EQ(network.latest(1), 4);
}

TEST(LiveStn, DatesOutOfRangeAreNoSolutionUntilTheyGo) {
  LiveStn network;
  network.set(1, {0, 1, kLargest, kInfinite});
  network.set(2, {1, 2, kLargest, kInfinite});
  network.settle();
  const bool before = network.consistent();

  network.set(2, {1, 2, -1, kInfinite});
  network.settle();

  EXPECT_FALSE(before);
  EXPECT_TRUE(network.consistent());
  EXPECT_EQ(network.earliest(2), kLargest - 1);
}

}  // namespace
}  // namespace skein::temporal
