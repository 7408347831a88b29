// SPDX-License-Identifier: Apache-2.0
// The order in which contingent links are worked out, and the explanation of failure.
#include "dc_engine.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace skein::temporal {

namespace {

tl::unexpected<StnuError> overflow() {
  return tl::unexpected<StnuError>({StnuFault::kOverflow, std::nullopt});
}

/// Follows derived edges to what they stand on, each once, without recursion.
class Explanation {
 public:
  Explanation(const LoGraph& graph, const BestCaseSchedule& schedule, LinkSearch& search)
      : graph_(graph), schedule_(schedule), search_(search) {}

  std::vector<ConflictTerm> of(const std::vector<PathStep>& cycle) {
    push(cycle);
    while (!steps_.empty()) {
      const PathStep step = steps_.back();
      steps_.pop_back();
      switch (step.edge.kind) {
        case EdgeRef::Kind::kBase:
          name(graph_.term(step.edge.index));
          break;
        case EdgeRef::Kind::kLower:
          name_link(step.edge.index, LinkBound::kMin);
          break;
        case EdgeRef::Kind::kDerived:
          follow(step.edge.index, step.from);
          break;
      }
    }
    return std::move(terms_);
  }

 private:
  void push(const std::vector<PathStep>& path) {
    steps_.insert(steps_.end(), path.rbegin(), path.rend());
  }

  void name(const ConflictTerm& term) {
    if (named_.insert(term).second) terms_.push_back(term);
  }
  void name_link(std::uint32_t link, LinkBound bound) {
    name({{LinkKind::kContingent, graph_.link(link).given}, bound});
  }

  void follow(std::uint32_t link, NodeIndex from) {
    if (!followed_.insert({link, from}).second) return;
    const auto [place, fresh] = tables_.try_emplace(link);
    if (fresh) {
      search_.run(graph_, schedule_, link, nullptr);
      place->second = search_.snapshot();
    }
    const LoGraph::Link& facts = graph_.link(link);
    name_link(link, LinkBound::kMax);
    if (place->second.distance[from] < facts.spread()) name_link(link, LinkBound::kMin);
    push(place->second.path_from(from, facts.end));
  }

  const LoGraph& graph_;
  const BestCaseSchedule& schedule_;
  LinkSearch& search_;
  std::vector<PathStep> steps_;
  std::vector<ConflictTerm> terms_;
  std::set<ConflictTerm> named_;
  std::set<std::pair<std::uint32_t, NodeIndex>> followed_;
  std::map<std::uint32_t, LinkSearch::Table> tables_;
};

}  // namespace

DcEngine::DcEngine(const Stnu& network, LoGraph::OpenBounds open)
    : graph_(network, open),
      schedule_(graph_.node_count()),
      search_(graph_.node_count()),
      ready_(graph_.link_count(), 0),
      under_way_(graph_.link_count(), 0) {}

void DcEngine::add_node() {
  graph_.add_node();
  schedule_.add_node();
  search_.add_node();
}

Result<DcResult, StnuError> DcEngine::decide() {
  const BestCaseSchedule::Outcome best_case = schedule_.solve(graph_, false);
  if (best_case != BestCaseSchedule::Outcome::kDone) return judge_best_case(best_case);
  return verdict(resolve_all());
}

// The best case is one of nature's choices: when it has no schedule, the network is not
// controllable, and it may be consistent all the same.
Result<DcResult, StnuError> DcEngine::judge_best_case(BestCaseSchedule::Outcome outcome) {
  if (outcome == BestCaseSchedule::Outcome::kOverflow) return overflow();
  const std::vector<PathStep> cycle = schedule_.cycle();
  auto inconsistency = find_inconsistency(Start::kNothing);
  if (!inconsistency) return tl::unexpected(inconsistency.error());
  DcResult result;
  result.consistent = !inconsistency->has_value();
  result.conflict = result.consistent ? explain(cycle) : std::move(**inconsistency);
  return result;
}

Result<std::optional<std::vector<ConflictTerm>>, StnuError> DcEngine::find_inconsistency(
    Start start) const {
  BestCaseSchedule obeyed(graph_.node_count());
  if (start == Start::kSchedule) obeyed.restore(schedule_.dates());
  switch (obeyed.solve(graph_, true)) {
    case BestCaseSchedule::Outcome::kDone:
      return std::nullopt;
    case BestCaseSchedule::Outcome::kOverflow:
      if (start == Start::kSchedule) return find_inconsistency(Start::kNothing);
      return overflow();
    case BestCaseSchedule::Outcome::kCycle:
      break;
  }
  // A lower-case edge stands for the longest duration here.
  std::vector<ConflictTerm> terms;
  for (const PathStep& step : obeyed.cycle()) {
    const ConflictTerm term =
        step.edge.kind == EdgeRef::Kind::kBase
            ? graph_.term(step.edge.index)
            : ConflictTerm{{LinkKind::kContingent, graph_.link(step.edge.index).given},
                           LinkBound::kMax};
    if (std::find(terms.begin(), terms.end(), term) == terms.end()) terms.push_back(term);
  }
  return terms;
}

Result<DcResult, StnuError> DcEngine::verdict(Outcome outcome) {
  if (outcome == Outcome::kOverflow) return overflow();
  DcResult result;
  result.consistent = true;
  result.controllable = outcome == Outcome::kDone;
  if (!result.controllable) result.conflict = explain(cycle_);
  counters_.relaxations = search_.relaxations();
  result.counters = counters_;
  return result;
}

std::vector<ConflictTerm> DcEngine::explain(const std::vector<PathStep>& cycle) {
  return Explanation(graph_, schedule_, search_).of(cycle);
}

// A link needs links that start later; taking the latest first, few searches have to wait.
std::vector<std::uint32_t> DcEngine::latest_first() const {
  std::vector<std::uint32_t> order(graph_.link_count());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return schedule_.date(graph_.link(a).activation) > schedule_.date(graph_.link(b).activation);
  });
  return order;
}

DcEngine::Outcome DcEngine::resolve_all() {
  for (const std::uint32_t link : latest_first()) {
    const Outcome outcome = resolve(link);
    if (outcome != Outcome::kDone) return outcome;
  }
  return Outcome::kDone;
}

// A search that has to wait is begun again afterwards. Each link is waited for at most once, so
// there are fewer than 2k searches.
DcEngine::Outcome DcEngine::resolve(std::uint32_t first) {
  if (ready_[first] != 0) return Outcome::kDone;
  stack_.assign(1, first);
  under_way_[first] = 1;
  while (!stack_.empty()) {
    const Outcome outcome = resolve_top();
    if (outcome != Outcome::kDone) return outcome;
  }
  return Outcome::kDone;
}

DcEngine::Outcome DcEngine::resolve_top() {
  const std::uint32_t link = stack_.back();
  ++counters_.searches;
  const std::uint32_t needed = search_.run(graph_, schedule_, link, &ready_);
  if (needed == kNone) {
    stack_.pop_back();
    return commit(link);
  }
  if (under_way_[needed] != 0) {
    blame_needs(needed);
    return Outcome::kBroken;
  }
  under_way_[needed] = 1;
  stack_.push_back(needed);
  return Outcome::kDone;
}

// Each link on the stack from `needed` on needs the next, the last one `needed` again: their
// derived edges lead from activation to activation, all negative.
void DcEngine::blame_needs(std::uint32_t needed) {
  const auto first = std::find(stack_.begin(), stack_.end(), needed);
  cycle_.clear();
  NodeIndex from = graph_.link(needed).activation;
  for (auto link = stack_.end(); link != first;) {
    --link;
    const NodeIndex to = graph_.link(*link).activation;
    cycle_.push_back({from, to, {EdgeRef::Kind::kDerived, *link}});
    from = to;
  }
}

DcEngine::Outcome DcEngine::commit(std::uint32_t link) {
  const LoGraph::Link& facts = graph_.link(link);
  const EdgeRef ref{EdgeRef::Kind::kDerived, link};
  std::vector<LoGraph::Edge> edges = search_.derived_edges(facts);
  std::vector<BestCaseSchedule::Seed> seeds;
  for (const LoGraph::Edge& edge : edges) seeds.push_back({edge.from, edge.weight, ref});
  if (search_.reached(facts.activation)) {
    seeds.push_back(
        {facts.activation, derived_weight(facts, search_.distance(facts.activation)), ref});
  }
  counters_.derived_edges += edges.size();
  const BestCaseSchedule::Outcome outcome = schedule_.add_edges(graph_, facts.activation, seeds);
  switch (outcome) {
    case BestCaseSchedule::Outcome::kDone:
      break;
    case BestCaseSchedule::Outcome::kCycle:
      cycle_ = schedule_.cycle();
      return Outcome::kBroken;
    case BestCaseSchedule::Outcome::kOverflow:
      return Outcome::kOverflow;
  }
  graph_.set_derived(link, std::move(edges));
  ready_[link] = 1;
  under_way_[link] = 0;
  return Outcome::kDone;
}

}  // namespace skein::temporal
