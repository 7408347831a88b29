// SPDX-License-Identifier: Apache-2.0
// All that the updater keeps, not only its verdict, is what a check from scratch finds.
#include "controllability/dc_updater.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>

#include "any_stnu.hpp"
#include "stnu_builder.hpp"

namespace skein::temporal {
namespace {

using testing::any_arc;
using testing::any_network;
using testing::between;
using ::testing::IsEmpty;
using testing::StnuBuilder;

using Derived = std::vector<std::pair<NodeIndex, Ticks>>;

/// What is kept, in a form that does not depend on how it came about.
struct Picture {
  std::vector<std::vector<Ticks>> distances;  ///< of each link, of each node
  std::vector<Derived> derived;               ///< of each link, by node
  bool operator==(const Picture&) const = default;
};

/// A controllable network, the engine that decided it and the updater that changes it.
class Kept {
 public:
  explicit Kept(Stnu network) : network_(std::move(network)) {
    const auto decided = engine_.decide();
    if (decided && decided->controllable) updater_.emplace(engine_);
  }

  bool controllable() const { return updater_.has_value(); }
  const Stnu& network() const { return network_; }
  DcEngine& engine() { return engine_; }
  const DcUpdater& updater() const { return *updater_; }

  Ticks weight(std::uint32_t arc, LinkBound bound) {
    return engine_.graph().edge(engine_.graph().edge_of(arc, bound)).weight;
  }

  /// False iff the network would not be controllable.
  bool change(std::uint32_t arc, LinkBound bound, Ticks weight) {
    const std::uint32_t edge = engine_.graph().edge_of(arc, bound);
    const Ticks now = engine_.graph().edge(edge).weight;
    if (weight == now) return true;
    if (weight > now) {
      updater_->loosen(edge, weight);
    } else if (updater_->tighten(edge, weight) != DcUpdater::Outcome::kDone) {
      return false;
    }
    network_ = changed(arc, bound, weight);
    return true;
  }

  Stnu changed(std::uint32_t arc, LinkBound bound, Ticks weight) const {
    Stnu out = network_;
    if (bound == LinkBound::kMax) {
      out.arcs[arc].max = weight;
    } else {
      out.arcs[arc].min = weight == kInfinite ? kMinusInfinite : -weight;
    }
    return out;
  }

  Picture picture() {
    Picture out;
    const LoGraph& graph = engine_.graph();
    for (std::uint32_t link = 0; link < graph.link_count(); ++link) {
      std::vector<Ticks>& distances = out.distances.emplace_back();
      for (NodeIndex node = 0; node < graph.node_count(); ++node)
        distances.push_back(updater_->distance(link, node));
      Derived& derived = out.derived.emplace_back();
      for (const LoGraph::Edge& edge : graph.derived(link))
        derived.emplace_back(edge.from, edge.weight);
      std::sort(derived.begin(), derived.end());
    }
    return out;
  }

 private:
  Stnu network_;
  DcEngine engine_{network_, LoGraph::OpenBounds::kKeep};
  std::optional<DcUpdater> updater_;
};

bool satisfied(DcEngine& engine) {
  bool all = true;
  for (NodeIndex node = 0; node < engine.graph().node_count(); ++node) {
    for_each_edge_into(engine.graph(), node, kNone, [&](NodeIndex from, Ticks weight, EdgeRef) {
      all = all && engine.schedule().date(node) - engine.schedule().date(from) <= weight;
    });
  }
  return all;
}

/// The graph with the derived edges of all nodes that a search reached.
LoGraph with_all_edges(Kept& kept) {
  LoGraph graph = kept.engine().graph();
  for (std::uint32_t link = 0; link < graph.link_count(); ++link) {
    std::vector<LoGraph::Edge> edges;
    for (NodeIndex node = 0; node < graph.node_count(); ++node) {
      const Ticks distance = kept.updater().distance(link, node);
      if (distance == kInfinite || node == graph.link(link).activation) continue;
      edges.push_back({node, derived_weight(graph.link(link), distance)});
    }
    graph.set_derived(link, std::move(edges));
  }
  return graph;
}

LinkBound any_bound() { return between(0, 2) == 0 ? LinkBound::kMin : LinkBound::kMax; }

/// Near the present one, of any size that distances have, none at all, or the first again.
Ticks any_weight(Ticks now, Ticks first) {
  const int kind = between(0, 8);
  if (kind == 0) return kInfinite;
  if (kind == 1) return first;
  if (kind < 5 || now == kInfinite) return between<Ticks>(-20, 30);
  return now + between<Ticks>(-6, 7);
}

TEST(DcUpdater, ADerivedEdgeGoesWhenItsNodeComesBehindTheEnd) {
  Kept kept(
      StnuBuilder("z a c x").contingent("a", "c", 1, 10).arc("x", "c", kMinusInfinite, 5).build());
  ASSERT_EQ(kept.picture().derived[0], (Derived{{3, -1}}));

  ASSERT_TRUE(kept.change(0, LinkBound::kMax, -1));

  EXPECT_EQ(kept.updater().distance(0, 3), -1);
  EXPECT_THAT(kept.picture().derived[0], IsEmpty()) << "x -> c -> a says more";
}

TEST(DcUpdater, ADerivedEdgeComesBackWhenItsNodeDoes) {
  Kept kept(
      StnuBuilder("z a c x").contingent("a", "c", 1, 10).arc("x", "c", kMinusInfinite, -1).build());
  ASSERT_THAT(kept.picture().derived[0], IsEmpty());

  ASSERT_TRUE(kept.change(0, LinkBound::kMax, 5));

  EXPECT_EQ(kept.picture().derived[0], (Derived{{3, -1}}));
}

RC_GTEST_PROP(DcUpdater, KeepsAfterEveryChangeWhatACheckFromScratchFinds, ()) {
  Kept kept(any_network());
  RC_PRE(kept.controllable() && !kept.network().arcs.empty());
  const Stnu first = kept.network();
  Kept unchanged(first);

  for (int step = 0; step < 40; ++step) {
    const std::uint32_t arc = any_arc(first);
    const LinkBound bound = any_bound();
    const Ticks weight = any_weight(kept.weight(arc, bound), unchanged.weight(arc, bound));
    Kept asked(kept.changed(arc, bound, weight));
    const std::vector<Ticks> dates = kept.engine().schedule().dates();
    const Picture before = kept.picture();

    const bool done = kept.change(arc, bound, weight);

    RC_ASSERT(done == asked.controllable());
    RC_ASSERT(kept.picture() == (done ? asked.picture() : before));
    RC_ASSERT(done || kept.engine().schedule().dates() == dates);
    RC_ASSERT(satisfied(kept.engine()));
  }
}

RC_GTEST_PROP(DcUpdater, DerivedEdgesLeftOutChangeNoSearch, ()) {
  Kept kept(any_network());
  RC_PRE(kept.controllable() && !kept.network().arcs.empty());

  for (int step = 0; step < 10; ++step) {
    kept.change(any_arc(kept.network()), any_bound(), between<Ticks>(-20, 30));
  }

  const LoGraph graph = with_all_edges(kept);
  LinkSearch search(graph.node_count());
  for (std::uint32_t link = 0; link < graph.link_count(); ++link) {
    search.run(graph, kept.engine().schedule(), link, nullptr);
    for (NodeIndex node = 0; node < graph.node_count(); ++node) {
      const Ticks distance = search.reached(node) ? search.distance(node) : kInfinite;
      RC_ASSERT(distance == kept.updater().distance(link, node));
    }
  }
}

}  // namespace
}  // namespace skein::temporal
