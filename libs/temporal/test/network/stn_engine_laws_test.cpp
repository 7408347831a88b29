// SPDX-License-Identifier: Apache-2.0
// Laws of the engine on arbitrary networks, against all pairs of shortest paths.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {
namespace {

/// Of full size from the first example on, so that conflicts are as frequent as in the last.
template <class T>
T between(T low, T end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(low, end));
}

/// Bounds small enough for conflicts to be frequent; no two arcs alike.
Stn any_network() {
  Stn stn;
  const auto nodes = between<NodeIndex>(2, 7);
  for (NodeIndex node = 0; node < nodes; ++node) stn.nodes.push_back(std::to_string(node));
  stn.origin = between<NodeIndex>(0, nodes);
  const int arcs = between(1, 14);
  for (int i = 0; i < arcs; ++i) {
    const NodeIndex from = between<NodeIndex>(0, nodes);
    const NodeIndex to = (from + between<NodeIndex>(1, nodes)) % nodes;
    const bool taken = std::any_of(stn.arcs.begin(), stn.arcs.end(), [&](const Arc& arc) {
      return arc.from == from && arc.to == to;
    });
    if (taken) continue;
    const Ticks min = between<Ticks>(-9, 10);
    const int open = between(0, 6);
    stn.arcs.push_back({from, to, open == 1 ? kMinusInfinite : min,
                        open == 2 ? kInfinite : min + between<Ticks>(0, 7)});
  }
  return stn;
}

/// Shortest distances by Floyd–Warshall; kInfinite: none.
std::vector<std::vector<Ticks>> distances(const Stn& stn) {
  const std::size_t count = stn.nodes.size();
  std::vector<std::vector<Ticks>> d(count, std::vector<Ticks>(count, kInfinite));
  for (std::size_t i = 0; i < count; ++i) d[i][i] = 0;
  for (const Arc& arc : stn.arcs) {
    if (arc.max != kInfinite) d[arc.from][arc.to] = std::min(d[arc.from][arc.to], arc.max);
    if (arc.min != kMinusInfinite) d[arc.to][arc.from] = std::min(d[arc.to][arc.from], -arc.min);
  }
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        if (d[i][k] == kInfinite || d[k][j] == kInfinite) continue;
        d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
      }
    }
  }
  return d;
}

bool has_negative_cycle(const std::vector<std::vector<Ticks>>& d) {
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d[i][i] < 0) return true;
  }
  return false;
}

std::vector<std::pair<Ticks, Ticks>> windows(const StnEngine& engine) {
  std::vector<std::pair<Ticks, Ticks>> all;
  for (NodeIndex node = 0; node < engine.node_count(); ++node) {
    all.emplace_back(engine.earliest(node), engine.latest(node));
  }
  return all;
}

bool satisfied(const Stn& stn, const std::vector<Ticks>& dates) {
  return std::all_of(stn.arcs.begin(), stn.arcs.end(), [&](const Arc& arc) {
    const Ticks apart = dates[arc.to] - dates[arc.from];
    return apart >= arc.min && apart <= arc.max;
  });
}

RC_GTEST_PROP(StnEngineLaws, IsConsistentIffThereIsNoNegativeCycleAndDatesAreDistances, ()) {
  const Stn stn = any_network();
  const auto d = distances(stn);

  const StnEngine engine = StnEngine::make(stn).value();

  RC_CLASSIFY(engine.consistent(), "consistent");
  RC_ASSERT(engine.consistent() == !has_negative_cycle(d));
  RC_ASSERT(engine.conflict().empty() == engine.consistent());
  if (!engine.consistent()) return;
  for (NodeIndex node = 0; node < stn.nodes.size(); ++node) {
    RC_ASSERT(engine.latest(node) == d[stn.origin][node]);
    const Ticks back = d[node][stn.origin];
    RC_ASSERT(engine.earliest(node) == (back == kInfinite ? kMinusInfinite : -back));
  }
}

RC_GTEST_PROP(StnEngineLaws, TheEarliestDatesTogetherAreASolutionAndSoAreTheLatest, ()) {
  Stn stn = any_network();
  for (NodeIndex node = 0; node < stn.nodes.size(); ++node) {
    const bool tied = std::any_of(stn.arcs.begin(), stn.arcs.end(), [&](const Arc& arc) {
      return arc.from == stn.origin && arc.to == node;
    });
    if (node != stn.origin && !tied) stn.arcs.push_back({stn.origin, node, -40, 40});
  }
  const StnEngine engine = StnEngine::make(stn).value();
  RC_PRE(engine.consistent());
  std::vector<Ticks> earliest, latest;
  for (NodeIndex node = 0; node < stn.nodes.size(); ++node) {
    earliest.push_back(engine.earliest(node));
    latest.push_back(engine.latest(node));
  }
  RC_PRE(std::count(earliest.begin(), earliest.end(), kMinusInfinite) == 0);
  RC_PRE(std::count(latest.begin(), latest.end(), kInfinite) == 0);

  RC_ASSERT(satisfied(stn, earliest));
  RC_ASSERT(satisfied(stn, latest));
}

RC_GTEST_PROP(StnEngineLaws, TheOrderInWhichArcsComeDoesNotMatter, ()) {
  Stn stn = any_network();
  const StnEngine whole = StnEngine::make(stn).value();
  std::vector<std::size_t> order(stn.arcs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[between<std::size_t>(0, i)]);
  }

  StnEngine grown = StnEngine::make({stn.nodes, stn.origin, {}}).value();
  for (const std::size_t place : order) RC_ASSERT(grown.add_arc(stn.arcs[place]).has_value());

  RC_ASSERT(grown.consistent() == whole.consistent());
  if (whole.consistent()) RC_ASSERT(windows(grown) == windows(whole));
}

RC_GTEST_PROP(StnEngineLaws, AContractionNeverWidensAWindowNorMendsAConflict, ()) {
  const Stn stn = any_network();
  StnEngine engine = StnEngine::make(stn).value();
  const bool consistent = engine.consistent();
  const auto before = windows(engine);
  const auto arc = between<ArcId>(0, static_cast<ArcId>(stn.arcs.size()));
  const Ticks low = std::max<Ticks>(stn.arcs[arc].min, -20);
  const Ticks high = std::min<Ticks>(stn.arcs[arc].max, 20);
  const Ticks min = between<Ticks>(low, high + 1);

  RC_ASSERT(!engine.set_arc({arc, min, between<Ticks>(min, high + 1)}));

  RC_ASSERT(consistent || !engine.consistent());
  if (!engine.consistent()) return;
  const auto after = windows(engine);
  for (std::size_t node = 0; node < after.size(); ++node) {
    RC_ASSERT(after[node].first >= before[node].first);
    RC_ASSERT(after[node].second <= before[node].second);
  }
}

RC_GTEST_PROP(StnEngineLaws, ABoundPutBackGivesTheDatesBack, ()) {
  const Stn stn = any_network();
  StnEngine engine = StnEngine::make(stn).value();
  const bool consistent = engine.consistent();
  const auto before = windows(engine);
  const int changes = between(1, 6);

  for (int i = 0; i < changes; ++i) {
    const auto arc = between<ArcId>(0, static_cast<ArcId>(stn.arcs.size()));
    const Ticks min = between<Ticks>(-15, 15);
    RC_ASSERT(!engine.set_arc({arc, min, min + between<Ticks>(0, 5)}));
  }
  for (ArcId arc = 0; arc < stn.arcs.size(); ++arc) {
    RC_ASSERT(!engine.set_arc({arc, stn.arcs[arc].min, stn.arcs[arc].max}));
  }

  RC_ASSERT(engine.consistent() == consistent);
  if (consistent) RC_ASSERT(windows(engine) == before);
}

RC_GTEST_PROP(StnEngineLaws, ChangesAreExactlyTheDifferencesOfTheDates, ()) {
  const Stn stn = any_network();
  StnEngine engine = StnEngine::make(stn).value();
  const auto before = windows(engine);
  const auto arc = between<ArcId>(0, static_cast<ArcId>(stn.arcs.size()));
  const Ticks min = between<Ticks>(-15, 15);

  RC_ASSERT(!engine.set_arc({arc, min, min + between<Ticks>(0, 9)}));

  std::map<std::pair<NodeIndex, Bound>, Ticks> told, seen;
  for (const BoundChange& change : engine.changes()) {
    RC_ASSERT(told.emplace(std::pair(change.node, change.bound), change.value).second);
  }
  const auto after = windows(engine);
  for (NodeIndex node = 0; node < after.size(); ++node) {
    if (after[node].first != before[node].first) seen[{node, Bound::kLower}] = after[node].first;
    if (after[node].second != before[node].second) seen[{node, Bound::kUpper}] = after[node].second;
  }
  RC_ASSERT(told == seen);
}

RC_GTEST_PROP(StnEngineLaws, TurningTimeRoundExchangesEarliestAndLatest, ()) {
  const Stn stn = any_network();
  Stn mirrored = stn;
  for (Arc& arc : mirrored.arcs) arc = {arc.from, arc.to, -arc.max, -arc.min};

  const StnEngine engine = StnEngine::make(stn).value();
  const StnEngine mirror = StnEngine::make(mirrored).value();

  RC_ASSERT(mirror.consistent() == engine.consistent());
  if (!engine.consistent()) return;
  for (NodeIndex node = 0; node < stn.nodes.size(); ++node) {
    RC_ASSERT(mirror.earliest(node) == -engine.latest(node));
    RC_ASSERT(mirror.latest(node) == -engine.earliest(node));
  }
}

}  // namespace
}  // namespace skein::temporal
