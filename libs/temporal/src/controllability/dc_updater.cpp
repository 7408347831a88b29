// SPDX-License-Identifier: Apache-2.0
// Tightening by decreasing distances, loosening by searching again where a shortest path is gone.
#include "dc_updater.hpp"

#include <algorithm>

namespace skein::temporal {

DcUpdater::DcUpdater(DcEngine& engine)
    : engine_(engine),
      graph_(engine.graph()),
      schedule_(engine.schedule()),
      queue_(graph_.node_count()),
      distance_(graph_.link_count()),
      reached_(graph_.link_count()),
      lost_(graph_.link_count()),
      wanted_(graph_.link_count(), 0) {
  LinkSearch& search = engine_.search();
  for (std::uint32_t link = 0; link < graph_.link_count(); ++link) {
    search.run(graph_, schedule_, link, nullptr);
    distance_[link].assign(graph_.node_count(), kInfinite);
    for (const NodeIndex node : search.settled()) distance_[link][node] = search.distance(node);
  }
  relaxations_before_ = search.relaxations();
}

DcCounters DcUpdater::take_counters() {
  const std::uint64_t relaxations = engine_.search().relaxations();
  counters_.relaxations += relaxations - relaxations_before_;
  relaxations_before_ = relaxations;
  return std::exchange(counters_, {});
}

bool DcUpdater::passes(std::uint32_t link, NodeIndex node) const {
  return distance_[link][node] < graph_.link(link).spread();
}

void DcUpdater::want(std::uint32_t link) {
  if (wanted_[link] != 0) return;
  wanted_[link] = 1;
  agenda_.push_back(link);
}

std::uint32_t DcUpdater::take_latest() {
  const auto latest =
      std::max_element(agenda_.begin(), agenda_.end(), [this](std::uint32_t a, std::uint32_t b) {
        return schedule_.date(graph_.link(a).activation) <
               schedule_.date(graph_.link(b).activation);
      });
  const std::uint32_t link = *latest;
  *latest = agenda_.back();
  agenda_.pop_back();
  wanted_[link] = 0;
  return link;
}

// --- tightening ---

DcUpdater::Outcome DcUpdater::tighten(std::uint32_t edge, Ticks weight) {
  const Ticks former_weight = graph_.edge(edge).weight;
  const NodeIndex from = graph_.edge(edge).from;
  const NodeIndex to = graph_.edge_end(edge);
  std::vector<Ticks> dates = schedule_.dates();
  const BestCaseSchedule::Outcome best_case =
      schedule_.add_edges(graph_, to, {{from, weight, {EdgeRef::Kind::kBase, edge}}});
  if (best_case != BestCaseSchedule::Outcome::kDone) return break_off(best_case);
  graph_.set_weight(edge, weight);
  reach_through(from, to, weight);
  const Outcome outcome = carry_on();
  if (outcome != Outcome::kDone) take_back(edge, former_weight, std::move(dates));
  end_change();
  return outcome;
}

/// Tells every link that passes `to` that `from` is now this close to it.
void DcUpdater::reach_through(NodeIndex from, NodeIndex to, Ticks weight) {
  for (std::uint32_t link = 0; link < distance_.size(); ++link) {
    if (!passes(link, to)) continue;
    const Ticks candidate = distance_[link][to] + weight;
    if (candidate >= distance_[link][from]) continue;
    reached_[link].push_back({from, candidate});
    want(link);
  }
}

DcUpdater::Outcome DcUpdater::carry_on() {
  while (!agenda_.empty()) {
    const Outcome outcome = improve(take_latest());
    if (outcome != Outcome::kDone) return outcome;
  }
  return Outcome::kDone;
}

DcUpdater::Outcome DcUpdater::improve(std::uint32_t link) {
  const NodeIndex activation = graph_.link(link).activation;
  const std::size_t first_former = former_.size();
  come_closer(link);
  const std::vector<BestCaseSchedule::Seed> stronger = stronger_edges(link, first_former);
  if (stronger.empty() && !leaves_out_edges(link, first_former)) return Outcome::kDone;
  const BestCaseSchedule::Outcome outcome = schedule_.add_edges(graph_, activation, stronger);
  if (outcome != BestCaseSchedule::Outcome::kDone) return break_off(outcome);
  rebuild_derived(link);
  for (const BestCaseSchedule::Seed& seed : stronger)
    reach_through(seed.from, activation, seed.weight);
  return Outcome::kDone;
}

void DcUpdater::come_closer(std::uint32_t link) {
  ++counters_.searches;
  const NodeIndex end = graph_.link(link).end;
  for (const Reach& reach : reached_[link]) {
    queue_.lower(reach.node, reach.distance + schedule_.date(reach.node) - schedule_.date(end));
  }
  reached_[link].clear();
  drain(link);
}

/// Dijkstra's algorithm among the nodes that come closer.
void DcUpdater::drain(std::uint32_t link) {
  const NodeIndex end = graph_.link(link).end;
  std::vector<Ticks>& distance = distance_[link];
  while (!queue_.empty()) {
    const NodeIndex node = queue_.pop();
    const Ticks closer = queue_.key(node) - schedule_.date(node) + schedule_.date(end);
    if (closer >= distance[node]) continue;
    former_.push_back({link, node, distance[node]});
    distance[node] = closer;
    if (closer < graph_.link(link).spread()) pass(link, node);
  }
}

void DcUpdater::pass(std::uint32_t link, NodeIndex node) {
  const Ticks key = queue_.key(node);
  const Ticks distance = distance_[link][node];
  for_each_edge_into(graph_, node, link, [&](NodeIndex from, Ticks weight, EdgeRef /*edge*/) {
    ++counters_.relaxations;
    if (distance + weight >= distance_[link][from]) return;
    queue_.lower(from, key + (weight + schedule_.date(from) - schedule_.date(node)));
  });
}

/// Derived edges that the distances replaced since `first_former` make new or stronger.
std::vector<BestCaseSchedule::Seed> DcUpdater::stronger_edges(std::uint32_t link,
                                                              std::size_t first_former) const {
  const LoGraph::Link& facts = graph_.link(link);
  std::vector<BestCaseSchedule::Seed> seeds;
  for (std::size_t i = first_former; i < former_.size(); ++i) {
    const Former& former = former_[i];
    const Ticks now = distance_[link][former.node];
    const Ticks weight = derived_weight(facts, now);
    const bool closes = former.node == facts.activation && weight < 0;
    const bool derives =
        derives_edge(facts, former.node, now) &&
        (former.distance == kInfinite || weight < derived_weight(facts, former.distance));
    if (closes || derives) seeds.push_back({former.node, weight, {EdgeRef::Kind::kDerived, link}});
  }
  return seeds;
}

/// Whether nodes came so close that their derived edges are no longer kept. Such an edge has to go
/// at once: a loosening looks only for what the distances say is there.
bool DcUpdater::leaves_out_edges(std::uint32_t link, std::size_t first_former) const {
  const LoGraph::Link& facts = graph_.link(link);
  return std::any_of(former_.begin() + static_cast<std::ptrdiff_t>(first_former), former_.end(),
                     [&](const Former& former) {
                       return derives_edge(facts, former.node, former.distance) &&
                              !derives_edge(facts, former.node, distance_[link][former.node]);
                     });
}

void DcUpdater::rebuild_derived(std::uint32_t link) {
  const LoGraph::Link& facts = graph_.link(link);
  std::vector<LoGraph::Edge> edges;
  for (NodeIndex node = 0; node < graph_.node_count(); ++node) {
    const Ticks distance = distance_[link][node];
    if (derives_edge(facts, node, distance))
      edges.push_back({node, derived_weight(facts, distance)});
  }
  former_derived_.emplace_back(link, graph_.derived(link));
  graph_.set_derived(link, std::move(edges));
}

// The cycle is followed in the graph as it is now: valid for the schedule, without the edges at
// fault.
DcUpdater::Outcome DcUpdater::break_off(BestCaseSchedule::Outcome outcome) {
  if (outcome == BestCaseSchedule::Outcome::kOverflow) return Outcome::kOverflow;
  conflict_ = engine_.explain(schedule_.cycle());
  return Outcome::kBroken;
}

void DcUpdater::take_back(std::uint32_t edge, Ticks weight, std::vector<Ticks> dates) {
  graph_.set_weight(edge, weight);
  schedule_.restore(std::move(dates));
  for (auto former = former_.rbegin(); former != former_.rend(); ++former) {
    distance_[former->link][former->node] = former->distance;
  }
  for (auto former = former_derived_.rbegin(); former != former_derived_.rend(); ++former) {
    graph_.set_derived(former->first, std::move(former->second));
  }
  for (const std::uint32_t link : agenda_) {
    reached_[link].clear();
    wanted_[link] = 0;
  }
  agenda_.clear();
}

void DcUpdater::end_change() {
  former_.clear();
  former_derived_.clear();
}

// --- nodes and links ---

void DcUpdater::add_node() {
  engine_.add_node();
  queue_.grow();
  for (std::vector<Ticks>& distance : distance_) distance.push_back(kInfinite);
}

// First what it asks as a requirement, then nature's haste, then the search from its end, whose
// derived edges go to the others as those of any change.
DcUpdater::Outcome DcUpdater::add_link(std::uint32_t link) {
  const LoGraph::Link facts = graph_.link(link);
  if (link >= distance_.size()) {
    distance_.resize(link + 1);
    reached_.resize(link + 1);
    lost_.resize(link + 1);
    wanted_.resize(link + 1, 0);
  }
  distance_[link].assign(graph_.node_count(), kInfinite);
  const Outcome asked = tighten(facts.base, -facts.min);
  if (asked != Outcome::kDone) return asked;
  const BestCaseSchedule::Outcome best_case = schedule_.add_edges(
      graph_, facts.end, {{facts.activation, facts.min, {EdgeRef::Kind::kLower, link}}});
  if (best_case != BestCaseSchedule::Outcome::kDone) {
    return best_case == BestCaseSchedule::Outcome::kOverflow ? Outcome::kOverflow
                                                             : Outcome::kBroken;
  }
  graph_.activate(link);
  reach_through(facts.activation, facts.end, facts.min);
  reached_[link].push_back({facts.end, 0});
  want(link);
  const Outcome outcome = carry_on();
  if (outcome == Outcome::kDone) end_change();
  return outcome;
}

void DcUpdater::remove_link(std::uint32_t link) {
  const LoGraph::Link facts = graph_.link(link);
  std::fill(distance_[link].begin(), distance_[link].end(), kInfinite);
  const std::vector<LoGraph::Edge> derived = graph_.derived(link);
  graph_.set_derived(link, {});
  graph_.set_weight(facts.base, kInfinite);
  graph_.remove_link(link);
  for (const LoGraph::Edge& edge : derived) lose(edge.from, facts.activation, edge.weight);
  lose(facts.activation, facts.end, facts.min);
  lose(facts.end, facts.activation, -facts.min);
  work_out_losses();
}

// --- loosening ---

void DcUpdater::loosen(std::uint32_t edge, Ticks weight) {
  const Ticks former_weight = graph_.edge(edge).weight;
  graph_.set_weight(edge, weight);
  lose(graph_.edge(edge).from, graph_.edge_end(edge), former_weight);
  work_out_losses();
}

void DcUpdater::work_out_losses() {
  while (!agenda_.empty()) find_new_ways(take_latest());
  end_change();
}

/// Tells every link for which an edge that is gone or weaker was on a shortest path.
void DcUpdater::lose(NodeIndex from, NodeIndex to, Ticks weight) {
  for (std::uint32_t link = 0; link < distance_.size(); ++link) {
    if (!passes(link, to) || distance_[link][to] + weight != distance_[link][from]) continue;
    lost_[link].push_back(from);
    want(link);
  }
}

void DcUpdater::find_new_ways(std::uint32_t link) {
  ++counters_.searches;
  forget_all_behind(link);
  for (const Reach& forgotten : forgotten_) look_ahead(link, forgotten.node);
  look_at_derived(link);
  drain(link);
  pass_on_losses(link);
  forgotten_.clear();
}

void DcUpdater::forget(std::uint32_t link, NodeIndex node) {
  Ticks& distance = distance_[link][node];
  if (distance == kInfinite || node == graph_.link(link).end) return;
  forgotten_.push_back({node, distance});
  distance = kInfinite;
}

/// Forgets every node that has a shortest path through a node that lost one.
void DcUpdater::forget_all_behind(std::uint32_t link) {
  for (const NodeIndex node : lost_[link]) forget(link, node);
  lost_[link].clear();
  for (std::size_t i = 0; i < forgotten_.size(); ++i) {
    const Reach at = forgotten_[i];
    if (at.distance >= graph_.link(link).spread()) continue;
    for_each_edge_into(graph_, at.node, link, [&](NodeIndex from, Ticks weight, EdgeRef /*edge*/) {
      ++counters_.relaxations;
      if (at.distance + weight == distance_[link][from]) forget(link, from);
    });
  }
}

void DcUpdater::offer(std::uint32_t link, NodeIndex node, NodeIndex through, Ticks weight) {
  ++counters_.relaxations;
  if (weight == kInfinite || !passes(link, through)) return;
  queue_.lower(node, distance_[link][through] + weight + schedule_.date(node) -
                         schedule_.date(graph_.link(link).end));
}

/// The ways on from a forgotten node to nodes that were not, but for derived edges.
void DcUpdater::look_ahead(std::uint32_t link, NodeIndex node) {
  for (const std::uint32_t edge : graph_.base_out_of(node)) {
    offer(link, node, graph_.edge_end(edge), graph_.edge(edge).weight);
  }
  for (const std::uint32_t other : graph_.links_activated(node)) {
    if (other != link) offer(link, node, graph_.link(other).end, graph_.link(other).min);
  }
}

void DcUpdater::look_at_derived(std::uint32_t link) {
  for (std::uint32_t other = 0; other < graph_.link_count(); ++other) {
    const NodeIndex activation = graph_.link(other).activation;
    if (!passes(link, activation)) continue;
    for (const LoGraph::Edge& edge : graph_.derived(other)) {
      if (distance_[link][edge.from] == kInfinite) offer(link, edge.from, activation, edge.weight);
    }
  }
}

void DcUpdater::pass_on_losses(std::uint32_t link) {
  const LoGraph::Link& facts = graph_.link(link);
  bool rebuild = false;
  for (const Reach& former : forgotten_) {
    const Ticks now = distance_[link][former.node];
    if (now == former.distance) continue;
    const bool derived = derives_edge(facts, former.node, former.distance);
    rebuild = rebuild || derived || derives_edge(facts, former.node, now);
    if (!derived) continue;
    const Ticks weight = derived_weight(facts, former.distance);
    if (now == kInfinite || derived_weight(facts, now) > weight)
      lose(former.node, facts.activation, weight);
  }
  if (rebuild) rebuild_derived(link);
}

}  // namespace skein::temporal
