// SPDX-License-Identifier: Apache-2.0
#include "rebuilt_dates.hpp"

#include <algorithm>
#include <utility>

#include "skein/temporal/dispatchable_network.hpp"
#include "skein/temporal/stn_engine.hpp"

namespace skein::supervisor {

namespace {

using temporal::Arc;
using temporal::kInfinite;
using temporal::kMinusInfinite;
using temporal::NodeIndex;
using temporal::StnEngine;
using temporal::Ticks;

enum class Durations : std::uint8_t { kFree, kLeast, kGreatest };

Arc arc_of(const temporal::ContingentLink& link, Durations durations) {
  Arc arc{link.activation, link.contingent, link.min, link.max};
  if (durations == Durations::kLeast) arc.max = arc.min;
  if (durations == Durations::kGreatest) arc.min = arc.max;
  return arc;
}

// Links between the same nodes become one arc; none when they contradict each other.
std::optional<std::vector<Arc>> merged(std::vector<Arc> arcs) {
  std::sort(arcs.begin(), arcs.end(), [](const Arc& a, const Arc& b) {
    return std::pair(a.from, a.to) < std::pair(b.from, b.to);
  });
  std::vector<Arc> result;
  for (const Arc& arc : arcs) {
    if (result.empty() || result.back().from != arc.from || result.back().to != arc.to) {
      result.push_back(arc);
      continue;
    }
    result.back().min = std::max(result.back().min, arc.min);
    result.back().max = std::min(result.back().max, arc.max);
    if (result.back().min > result.back().max) return std::nullopt;
  }
  return result;
}

std::optional<StnEngine> engine_of(const RebuiltNetwork& plan, std::vector<Arc> arcs) {
  auto all = merged(std::move(arcs));
  if (!all) return std::nullopt;
  auto engine = StnEngine::make({plan.stnu.nodes, plan.stnu.origin, std::move(*all)});
  if (!engine || !engine->consistent()) return std::nullopt;
  return std::move(*engine);
}

std::optional<StnEngine> engine_of(const RebuiltNetwork& plan, Durations durations) {
  std::vector<Arc> arcs = plan.stnu.arcs;
  for (const auto& link : plan.stnu.contingent) arcs.push_back(arc_of(link, durations));
  return engine_of(plan, std::move(arcs));
}

std::vector<Ticks> earliest_of(const StnEngine& engine) {
  std::vector<Ticks> dates;
  for (NodeIndex node = 0; node < engine.node_count(); ++node)
    dates.push_back(engine.earliest(node));
  return dates;
}

std::vector<Ticks> latest_of(const StnEngine& engine) {
  std::vector<Ticks> dates;
  for (NodeIndex node = 0; node < engine.node_count(); ++node) dates.push_back(engine.latest(node));
  return dates;
}

// Lower bounds alone, with the executive's waits for instants.
std::vector<Arc> lower_bounds(const RebuiltNetwork& plan, const NodeDates* allowed) {
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < plan.stnu.arcs.size(); ++i) {
    const Arc& arc = plan.stnu.arcs[i];
    if (arc.min != kMinusInfinite) arcs.push_back({arc.from, arc.to, arc.min, kInfinite});
    const Rule& cause = plan.arcs[i];
    const bool held = cause.kind == RuleKind::kStartAfter || cause.kind == RuleKind::kEndAfter;
    if (!held || allowed == nullptr) continue;
    const NodeIndex start = plan.nodes.at(cause.task).start;
    arcs.push_back({0, start, allowed->earliest[start], kInfinite});
  }
  return arcs;
}

std::optional<StnEngine> course(const RebuiltNetwork& plan, std::vector<Arc> arcs,
                                Durations durations) {
  for (const auto& link : plan.stnu.contingent) {
    Arc arc = arc_of(link, durations);
    arc.max = kInfinite;
    arcs.push_back(arc);
  }
  return engine_of(plan, std::move(arcs));
}

// What follows an end that nothing bounds is not bounded either.
void spread_endless(const RebuiltNetwork& plan, const std::vector<Arc>& arcs,
                    std::vector<Ticks>& latest) {
  std::vector<std::vector<NodeIndex>> after(latest.size());
  for (const Arc& arc : arcs) after[arc.from].push_back(arc.to);
  for (const auto& link : plan.stnu.contingent) after[link.activation].push_back(link.contingent);
  std::vector<NodeIndex> open = plan.endless;
  for (const NodeIndex node : open) latest[node] = kInfinite;
  while (!open.empty()) {
    const NodeIndex node = open.back();
    open.pop_back();
    for (const NodeIndex next : after[node]) {
      if (std::exchange(latest[next], kInfinite) != kInfinite) open.push_back(next);
    }
  }
}

}  // namespace

std::optional<NodeDates> dates_by_choice(const RebuiltNetwork& plan) {
  const auto engine = engine_of(plan, Durations::kFree);
  if (!engine) return std::nullopt;
  return NodeDates{earliest_of(*engine), latest_of(*engine)};
}

std::vector<Arc> implied_by(const temporal::Stnu& network) {
  std::vector<Arc> arcs;
  const auto dispatchable = temporal::make_dispatchable(network);
  if (!dispatchable) return arcs;
  for (const temporal::DistanceEdge& edge : dispatchable->edges)
    arcs.push_back({edge.from, edge.to, kMinusInfinite, edge.weight});
  for (const temporal::WaitEdge& wait : dispatchable->waits) {
    const temporal::ContingentLink& link = network.contingent[wait.link];
    arcs.push_back({link.activation, wait.node, link.min, kInfinite});
  }
  return arcs;
}

std::optional<NodeDates> dates_in_every_course(const RebuiltNetwork& plan) {
  std::vector<Arc> arcs = plan.stnu.arcs;
  for (const auto& link : plan.stnu.contingent) arcs.push_back(arc_of(link, Durations::kLeast));
  for (const Arc& arc : implied_by(plan.stnu)) arcs.push_back(arc);
  const auto fast = engine_of(plan, std::move(arcs));
  const auto slow = engine_of(plan, Durations::kGreatest);
  if (!fast || !slow) return std::nullopt;
  return NodeDates{earliest_of(*fast), latest_of(*slow)};
}

std::optional<NodeDates> foresee(const RebuiltNetwork& plan, const NodeDates* allowed) {
  const std::vector<Arc> arcs = lower_bounds(plan, allowed);
  const auto fast = course(plan, arcs, Durations::kLeast);
  const auto slow = course(plan, arcs, Durations::kGreatest);
  if (!fast || !slow) return std::nullopt;
  NodeDates dates{earliest_of(*fast), earliest_of(*slow)};
  spread_endless(plan, arcs, dates.latest);
  return dates;
}

}  // namespace skein::supervisor
