// SPDX-License-Identifier: Apache-2.0
// Tests of the macro-STN and its elimination, the random ones against Floyd–Warshall, and of jobs.
#include "multi_agent/macro_network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "multi_agent/relax_jobs.hpp"
#include "skein/foundation/random.hpp"
#include "testing/post_office.hpp"

namespace skein::temporal::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Greatest lower bounds of differences over all paths, by Floyd–Warshall; nothing when there is a
/// positive cycle.
std::optional<std::vector<std::vector<Ticks>>> all_pairs(std::size_t nodes,
                                                         const std::vector<Arc>& arcs) {
  std::vector<std::vector<Ticks>> d(nodes, std::vector<Ticks>(nodes, kMinusInfinite));
  for (std::size_t i = 0; i < nodes; ++i) d[i][i] = 0;
  for (const Arc& arc : arcs) {
    d[arc.from][arc.to] = std::max(d[arc.from][arc.to], arc.min);
    if (arc.max != kInfinite) d[arc.to][arc.from] = std::max(d[arc.to][arc.from], -arc.max);
  }
  for (std::size_t k = 0; k < nodes; ++k) {
    for (std::size_t i = 0; i < nodes; ++i) {
      for (std::size_t j = 0; j < nodes; ++j) {
        if (d[i][k] == kMinusInfinite || d[k][j] == kMinusInfinite) continue;
        d[i][j] = std::max(d[i][j], d[i][k] + d[k][j]);
      }
    }
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    if (d[i][i] > 0) return std::nullopt;
  }
  return d;
}

/// Agent 0 owns nodes 1 to n, of which the first `frontier` have external arcs to agent 1's node.
struct RandomLocal {
  Mastn network;
  std::vector<Arc> own;
  std::vector<NodeIndex> frontier{0};
};

Arc random_arc(Random& random, NodeIndex from, NodeIndex to) {
  const auto middle = static_cast<Ticks>(random.below(20)) - 5;
  Arc arc{from, to, middle - static_cast<Ticks>(random.below(25)),
          middle + static_cast<Ticks>(random.below(25))};
  if (random.chance(0.2)) arc.min = kMinusInfinite;
  if (random.chance(0.2)) arc.max = kInfinite;
  return arc;
}

RandomLocal random_local(Random& random) {
  RandomLocal local;
  const auto nodes = static_cast<NodeIndex>(3 + random.below(7));
  local.network.agents = {"A", "B"};
  local.network.nodes.resize(nodes + 2);
  local.network.owner.assign(nodes + 2, 0);
  local.network.owner[nodes + 1] = 1;
  std::set<std::pair<NodeIndex, NodeIndex>> given;
  for (NodeIndex i = 0; i < 2 * nodes; ++i) {
    const auto from = static_cast<NodeIndex>(random.below(nodes + 1));
    const auto to = static_cast<NodeIndex>(random.below(nodes + 1));
    if (from == to || !given.emplace(from, to).second) continue;
    local.own.push_back(random_arc(random, from, to));
  }
  local.network.arcs = local.own;
  for (NodeIndex node = 1; node <= std::max<NodeIndex>(1, nodes / 3); ++node) {
    local.frontier.push_back(node);
    local.network.arcs.push_back({node, nodes + 1});
  }
  return local;
}

/// What an observer of the macro-STN believes.
class Observer {
 public:
  void hear(const MacroUpdates& updates) {
    for (const MacroConstraint& c : updates.constraints) known_[{c.from, c.to}] = c.min;
    consistent_ = updates.consistent;
  }
  std::vector<Arc> arcs() const {
    std::vector<Arc> arcs;
    for (const auto& [ends, min] : known_) arcs.push_back({ends.first, ends.second, min});
    return arcs;
  }
  bool consistent() const { return consistent_; }

 private:
  std::map<std::pair<NodeIndex, NodeIndex>, Ticks> known_;
  bool consistent_ = true;
};

void compare(const RandomLocal& local, const Observer& observer) {
  const std::size_t nodes = local.network.nodes.size();
  const auto truth = all_pairs(nodes, local.own);
  const auto seen = all_pairs(nodes, observer.arcs());
  ASSERT_EQ(truth.has_value(), seen.has_value() && observer.consistent());
  if (!truth) return;
  for (const NodeIndex from : local.frontier) {
    for (const NodeIndex to : local.frontier) ASSERT_EQ((*truth)[from][to], (*seen)[from][to]);
  }
}

TEST(MacroNetwork, ImpliesBetweenFrontierNodesExactlyWhatTheWholeNetworkImplies) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    RandomLocal local = random_local(random);
    MacroNetwork macro(local.network, 0);
    Observer observer;
    for (int step = 0; step < 15; ++step) {
      if (const auto updates = macro.update()) observer.hear(*updates);
      compare(local, observer);
      if (HasFatalFailure()) return;
      const auto i = static_cast<std::uint32_t>(random.below(local.own.size()));
      local.own[i] = random_arc(random, local.own[i].from, local.own[i].to);
      macro.set_arc(i, local.own[i].min, local.own[i].max);
    }
  }
}

TEST(MacroNetwork, PublishesAgainEverythingThatALateListenerNeeds) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    RandomLocal local = random_local(random);
    MacroNetwork macro(local.network, 0);
    macro.update();
    for (int step = 0; step < 5; ++step) {
      const auto i = static_cast<std::uint32_t>(random.below(local.own.size()));
      local.own[i] = random_arc(random, local.own[i].from, local.own[i].to);
      macro.set_arc(i, local.own[i].min, local.own[i].max);
      macro.update();
    }
    Observer late;
    late.hear(macro.published());
    compare(local, late);
    if (HasFatalFailure()) return;
  }
}

TEST(MacroNetwork, HasNothingToSayWhenNothingChanged) {
  MacroNetwork macro(two_agents(), 0);
  EXPECT_TRUE(macro.update().has_value());

  EXPECT_EQ(macro.update(), std::nullopt);
}

TEST(RelaxJobs, CloseWhenTheLastAnswerIsIn) {
  RelaxJobs jobs;
  const RelaxJobs::Wait first{1, Bound::kLower, 2};
  const RelaxJobs::Wait second{1, Bound::kLower, 3};
  const JobId job = jobs.next();
  jobs.open(RelaxJobs::Origin{4, {9, Bound::kLower, 7}}, {first, second});

  EXPECT_EQ(jobs.close(job, first), std::nullopt);
  EXPECT_FALSE(jobs.none_open());
  const auto origin = jobs.close(job, second);

  ASSERT_TRUE(origin.has_value());
  EXPECT_EQ(origin->agent, 4U);
  EXPECT_EQ(origin->request, (Relax{9, Bound::kLower, 7}));
  EXPECT_TRUE(jobs.none_open());
}

TEST(RelaxJobs, IgnoreAnAnswerThatComesTwice) {
  RelaxJobs jobs;
  const RelaxJobs::Wait wait{1, Bound::kLower, 2};
  jobs.open(std::nullopt, {wait});
  jobs.close(1, wait);

  EXPECT_EQ(jobs.close(1, wait), std::nullopt);
  EXPECT_TRUE(jobs.ever_opened(1));
  EXPECT_FALSE(jobs.ever_opened(2));
}

TEST(RelaxJobs, AskAgainInANewSessionAndOweNoAnswer) {
  RelaxJobs jobs;
  const RelaxJobs::Wait wait{1, Bound::kLower, 2};
  jobs.open(RelaxJobs::Origin{2, {9, Bound::kLower, 7}}, {wait});

  EXPECT_THAT(jobs.begin_session(2), ::testing::ElementsAre(Relax{1, Bound::kLower, 1}));

  EXPECT_EQ(jobs.close(1, wait), std::nullopt);
  EXPECT_TRUE(jobs.none_open());
}

}  // namespace
}  // namespace skein::temporal::testing
