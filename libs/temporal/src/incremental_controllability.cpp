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
    if (result_.controllable) {
      updater_.emplace(*engine_);
    } else {
      engine_.reset();
    }
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
    const auto error = updater_ ? settle() : start_over();
    if (!error) return result_;
    network_.arcs[index] = former;
    if (updater_) note(index);
    return tl::unexpected(*error);
  }

  const Stnu& network() const { return network_; }
  const DcResult& result() const { return result_; }

 private:
  void note(std::uint32_t arc) {
    if (!updater_) return;
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
      updater_->loosen(edge, asked_weight(edge));
      unsettled_.erase(edge);
    }
    while (!unsettled_.empty()) {
      const std::uint32_t edge = *unsettled_.begin();
      switch (updater_->tighten(edge, asked_weight(edge))) {
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
    result_ = {true, true, {}, updater_->take_counters()};
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
    result_ = {consistent, false, consistent ? updater_->conflict() : std::move(**inconsistency),
               updater_->take_counters()};
    return std::nullopt;
  }

  Stnu network_;
  DcResult result_;
  std::unique_ptr<DcEngine> engine_;
  std::optional<DcUpdater> updater_;
  std::set<std::uint32_t> unsettled_;
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
  if (link >= state_->network().contingent.size()) {
    return tl::unexpected<StnuError>({StnuFault::kUnknownLink, ref});
  }
  Stnu changed = state_->network();
  changed.contingent[link].min = min;
  changed.contingent[link].max = max;
  auto fresh = create(std::move(changed));
  if (!fresh) return tl::unexpected(fresh.error());
  *this = std::move(*fresh);
  return state_->result();
}

const Stnu& IncrementalDc::network() const { return state_->network(); }
const DcResult& IncrementalDc::result() const { return state_->result(); }

}  // namespace skein::temporal
