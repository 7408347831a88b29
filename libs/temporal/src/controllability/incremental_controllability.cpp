// SPDX-License-Identifier: Apache-2.0
// Which edges the network kept differs in from the network asked for, and when nothing needs doing.
#include "skein/temporal/incremental_controllability.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "dc_updater.hpp"

namespace skein::temporal {

namespace {

Ticks edge_weight(const Arc& arc, LinkBound bound) {
  if (bound == LinkBound::kMax) return arc.max;
  return arc.min == kMinusInfinite ? kInfinite : -arc.min;
}

constexpr std::array<LinkBound, 2> kBounds = {LinkBound::kMin, LinkBound::kMax};

}  // namespace

/// `engine_` holds a controllable network: the one asked for, but for the edges in `unsettled_`.
/// There is none until the network has been controllable once.
class IncrementalDc::State {
 public:
  explicit State(Stnu network) : network_(std::move(network)) {}

  std::optional<StnuError> start_over() {
    updater_.reset();
    unsettled_.clear();
    engine_ = std::make_unique<DcEngine>(network_, LoGraph::OpenBounds::kKeep);
    auto decided = engine_->decide();
    if (!decided) {
      engine_.reset();
      return decided.error();
    }
    result_ = std::move(*decided);
    if (!result_.controllable) engine_.reset();
    return std::nullopt;
  }

  Result<DcResult, StnuError> change_arc(std::uint32_t index, Arc changed) {
    const Arc former = network_.arcs[index];
    network_.arcs[index] = changed;
    note(index);
    if (conflict_stands(index, former)) {
      result_.counters = {};
      return result_;
    }
    const auto error = engine_ ? settle() : start_over();
    if (!error) return result_;
    network_.arcs[index] = former;
    if (engine_) note(index);
    return tl::unexpected(*error);
  }

  NodeIndex add_node(std::string name) {
    network_.nodes.push_back(std::move(name));
    if (engine_) updater().add_node();
    return static_cast<NodeIndex>(network_.nodes.size() - 1);
  }

  /// An open arc between these nodes.
  std::uint32_t place_arc(NodeIndex from, NodeIndex to) {
    const Arc open{from, to, kMinusInfinite, kInfinite};
    if (free_arcs_.empty()) {
      network_.arcs.push_back(open);
      if (engine_) graph_to_change().add_arc(from, to);
      return static_cast<std::uint32_t>(network_.arcs.size() - 1);
    }
    const std::uint32_t arc = free_arcs_.back();
    free_arcs_.pop_back();
    network_.arcs[arc] = open;
    if (engine_) graph_to_change().move_arc(arc, from, to);
    return arc;
  }

  Result<DcResult, StnuError> add_arc(const Arc& arc) {
    placed_ = place_arc(arc.from, arc.to);
    auto result = change_arc(placed_, arc);
    if (!result) free_arc(placed_);
    return result;
  }
  std::uint32_t placed() const { return placed_; }

  /// Of an open arc; what is kept of it goes too.
  void free_arc(std::uint32_t arc) {
    free_arcs_.push_back(arc);
    if (!engine_) return;
    for (const LinkBound bound : kBounds) {
      const std::uint32_t edge = engine_->graph().edge_of(arc, bound);
      if (engine_->graph().edge(edge).weight != kInfinite) updater().loosen(edge, kInfinite);
      unsettled_.erase(edge);
    }
  }

  Result<DcResult, StnuError> add_contingent(const ContingentLink& link) {
    network_.contingent.push_back(link);
    const auto last = static_cast<std::uint32_t>(network_.contingent.size() - 1);
    const auto error = can_take(link) && takes_up(link, last) ? settle() : start_over();
    if (!error) return result_;
    network_.contingent.pop_back();
    start_over();
    return tl::unexpected(*error);
  }

  /// In its place.
  Result<DcResult, StnuError> change_contingent(std::uint32_t index, const ContingentLink& link) {
    const ContingentLink former = network_.contingent[index];
    const bool local = can_take(former) && can_take(link);
    if (local) updater().remove_link(engine_->graph().link_of(index));
    network_.contingent[index] = link;
    const auto error = local && takes_up(link, index) ? settle() : start_over();
    if (!error) return result_;
    network_.contingent[index] = former;
    start_over();
    return tl::unexpected(*error);
  }

  Result<DcResult, StnuError> remove_contingent(std::uint32_t index) {
    const ContingentLink gone = network_.contingent[index];
    const bool local = can_take(gone);
    if (local) updater().remove_link(engine_->graph().link_of(index));
    network_.contingent[index] = network_.contingent.back();
    network_.contingent.pop_back();
    const auto error = local ? settle() : start_over();
    if (error) return tl::unexpected(*error);
    return result_;
  }

  std::vector<WaitEdge> waits() {
    std::vector<WaitEdge> result;
    for_each_derived([&](std::uint32_t given, std::uint32_t link, const LoGraph::Edge& edge) {
      const Ticks delay = network_.contingent[given].max - updater().distance(link, edge.from);
      if (delay > 0) result.push_back({edge.from, given, delay});
    });
    return result;
  }

  std::vector<DistanceEdge> implied() const {
    std::vector<DistanceEdge> result;
    for_each_derived([&](std::uint32_t given, std::uint32_t, const LoGraph::Edge& edge) {
      result.push_back({edge.from, network_.contingent[given].activation, edge.weight});
    });
    return result;
  }

  const Stnu& network() const { return network_; }
  const DcResult& result() const { return result_; }

 private:
  /// Made when it is first needed: who asks only once does not pay for it.
  DcUpdater& updater() {
    if (!updater_) updater_.emplace(*engine_);
    return *updater_;
  }

  /// The updater looks at the graph as it was decided, so it comes first.
  LoGraph& graph_to_change() {
    updater();
    return engine_->graph();
  }

  /// Calls visit(position of the link, its number in the graph, edge); nothing unless controllable.
  template <class Visit>
  void for_each_derived(Visit&& visit) const {
    if (!engine_ || !result_.controllable || !derives_any()) return;
    const LoGraph& graph = engine_->graph();
    for (std::uint32_t given = 0; given < network_.contingent.size(); ++given) {
      const std::uint32_t link = graph.link_of(given);
      if (link == kNone) continue;
      for (const LoGraph::Edge& edge : graph.derived(link)) visit(given, link, edge);
    }
  }

  bool derives_any() const {
    const LoGraph& graph = engine_->graph();
    for (std::uint32_t link = 0; link < graph.link_count(); ++link) {
      if (!graph.derived(link).empty()) return true;
    }
    return false;
  }

  /// Links with min = max are no links for the engine, which numbers those it has.
  bool can_take(const ContingentLink& link) const {
    const auto fixed = [](const ContingentLink& one) { return one.min == one.max; };
    return engine_ && !fixed(link) &&
           std::none_of(network_.contingent.begin(), network_.contingent.end(), fixed);
  }

  bool takes_up(const ContingentLink& link, std::uint32_t position) {
    LoGraph& graph = graph_to_change();
    const std::uint32_t added = graph.add_link(link);
    graph.exchange(graph.link(added).given, position);
    return updater().add_link(added) == DcUpdater::Outcome::kDone;
  }

  void note(std::uint32_t arc) {
    if (!engine_) return;
    for (const LinkBound bound : kBounds) {
      const std::uint32_t edge = engine_->graph().edge_of(arc, bound);
      if (engine_->graph().edge(edge).weight == edge_weight(network_.arcs[arc], bound)) {
        unsettled_.erase(edge);
      } else {
        unsettled_.insert(edge);
      }
    }
  }

  Ticks asked_weight(std::uint32_t edge) const {
    const ConflictTerm& term = engine_->graph().term(edge);
    return edge_weight(network_.arcs[term.link.index], term.bound);
  }

  /// The conflict stands while none of its bounds is loosened; a bound that is tightened may make a
  /// network that was consistent inconsistent, which has to be looked at.
  bool conflict_stands(std::uint32_t arc, const Arc& former) const {
    if (result_.controllable) return false;
    for (const LinkBound bound : kBounds) {
      const Ticks before = edge_weight(former, bound);
      const Ticks after = edge_weight(network_.arcs[arc], bound);
      if (after < before && result_.consistent) return false;
      const ConflictTerm term{{LinkKind::kRequirement, arc}, bound};
      const auto& conflict = result_.conflict;
      if (after > before && std::find(conflict.begin(), conflict.end(), term) != conflict.end())
        return false;
    }
    return true;
  }

  std::optional<StnuError> settle() {
    for (const std::uint32_t edge :
         std::vector<std::uint32_t>(unsettled_.begin(), unsettled_.end())) {
      if (asked_weight(edge) <= engine_->graph().edge(edge).weight) continue;
      updater().loosen(edge, asked_weight(edge));
      unsettled_.erase(edge);
    }
    while (!unsettled_.empty()) {
      const std::uint32_t edge = *unsettled_.begin();
      switch (updater().tighten(edge, asked_weight(edge))) {
        case DcUpdater::Outcome::kDone:
          unsettled_.erase(edge);
          break;
        case DcUpdater::Outcome::kBroken:
          return judge_failure();
        case DcUpdater::Outcome::kOverflow:
          // The dates kept only ever grow; from scratch they are as small as can be.
          return start_over();
      }
    }
    result_ = {true, true, {}, updater().take_counters()};
    return std::nullopt;
  }

  std::optional<StnuError> judge_failure() {
    LoGraph& graph = engine_->graph();
    std::vector<std::pair<std::uint32_t, Ticks>> kept;
    for (const std::uint32_t edge : unsettled_) {
      kept.emplace_back(edge, graph.edge(edge).weight);
      graph.set_weight(edge, asked_weight(edge));
    }
    auto inconsistency = engine_->find_inconsistency(DcEngine::Start::kSchedule);
    for (const auto& [edge, weight] : kept) graph.set_weight(edge, weight);
    if (!inconsistency) return inconsistency.error();
    const bool consistent = !inconsistency->has_value();
    result_ = {consistent, false, consistent ? updater().conflict() : std::move(**inconsistency),
               updater().take_counters()};
    return std::nullopt;
  }

  Stnu network_;
  DcResult result_;
  std::unique_ptr<DcEngine> engine_;
  std::optional<DcUpdater> updater_;
  std::set<std::uint32_t> unsettled_;
  std::vector<std::uint32_t> free_arcs_;
  std::uint32_t placed_ = 0;
};

IncrementalDc::IncrementalDc(std::unique_ptr<State> state) : state_(std::move(state)) {}
IncrementalDc::IncrementalDc(IncrementalDc&&) noexcept = default;
IncrementalDc& IncrementalDc::operator=(IncrementalDc&&) noexcept = default;
IncrementalDc::~IncrementalDc() = default;

Result<IncrementalDc, StnuError> IncrementalDc::create(Stnu network) {
  if (const auto fault = find_fault(network)) return tl::unexpected(*fault);
  auto state = std::make_unique<State>(std::move(network));
  if (const auto error = state->start_over()) return tl::unexpected(*error);
  return IncrementalDc(std::move(state));
}

Result<DcResult, StnuError> IncrementalDc::change_arc(std::uint32_t arc, Ticks min, Ticks max) {
  const LinkRef ref{LinkKind::kRequirement, arc};
  const Stnu& now = state_->network();
  if (arc >= now.arcs.size()) return tl::unexpected<StnuError>({StnuFault::kUnknownLink, ref});
  const Arc changed{now.arcs[arc].from, now.arcs[arc].to, min, max};
  if (const auto fault = find_fault(changed, now.nodes.size()))
    return tl::unexpected<StnuError>({*fault, ref});
  return state_->change_arc(arc, changed);
}

Result<DcResult, StnuError> IncrementalDc::change_contingent(std::uint32_t link, Ticks min,
                                                             Ticks max) {
  const LinkRef ref{LinkKind::kContingent, link};
  const std::vector<ContingentLink>& links = state_->network().contingent;
  if (link >= links.size()) return tl::unexpected<StnuError>({StnuFault::kUnknownLink, ref});
  const ContingentLink former = links[link];
  const ContingentLink changed{former.activation, former.contingent, min, max};
  if (const auto fault = find_fault(changed, state_->network().nodes.size()))
    return tl::unexpected<StnuError>({*fault, ref});
  return state_->change_contingent(link, changed);
}

NodeIndex IncrementalDc::add_node(std::string name) { return state_->add_node(std::move(name)); }

Result<DcResult, StnuError> IncrementalDc::add_arc(const Arc& arc) {
  const auto next = static_cast<std::uint32_t>(state_->network().arcs.size());
  if (const auto fault = find_fault(arc, state_->network().nodes.size()))
    return tl::unexpected<StnuError>({*fault, LinkRef{LinkKind::kRequirement, next}});
  return state_->add_arc(arc);
}

std::uint32_t IncrementalDc::placed() const { return state_->placed(); }

Result<DcResult, StnuError> IncrementalDc::remove_arc(std::uint32_t arc) {
  auto result = change_arc(arc, kMinusInfinite, kInfinite);
  if (result) state_->free_arc(arc);
  return result;
}

Result<DcResult, StnuError> IncrementalDc::add_contingent(const ContingentLink& link) {
  const Stnu& now = state_->network();
  const LinkRef ref{LinkKind::kContingent, static_cast<std::uint32_t>(now.contingent.size())};
  if (const auto fault = find_fault(link, now.nodes.size()))
    return tl::unexpected<StnuError>({*fault, ref});
  const bool shared =
      std::any_of(now.contingent.begin(), now.contingent.end(),
                  [&](const ContingentLink& one) { return one.contingent == link.contingent; });
  if (shared) return tl::unexpected<StnuError>({StnuFault::kSharedContingentEnd, ref});
  return state_->add_contingent(link);
}

Result<DcResult, StnuError> IncrementalDc::remove_contingent(std::uint32_t link) {
  if (link >= state_->network().contingent.size()) {
    return tl::unexpected<StnuError>(
        {StnuFault::kUnknownLink, LinkRef{LinkKind::kContingent, link}});
  }
  return state_->remove_contingent(link);
}

std::vector<WaitEdge> IncrementalDc::waits() const { return state_->waits(); }
std::vector<DistanceEdge> IncrementalDc::implied() const { return state_->implied(); }

const Stnu& IncrementalDc::network() const { return state_->network(); }
const DcResult& IncrementalDc::result() const { return state_->result(); }

}  // namespace skein::temporal
