// SPDX-License-Identifier: Apache-2.0
// Plays nature and host against a dispatcher.
#include "skein/temporal/stnu_execution.hpp"

#include <algorithm>

#include "skein/foundation/contract.hpp"

namespace skein::temporal {

namespace {

/// Uniform in [low, high].
Ticks between(Ticks low, Ticks high, Random& random) {
  return low + static_cast<Ticks>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

class Play {
 public:
  Play(const DispatchableNetwork& network, const std::vector<Ticks>& durations, StartPolicy policy,
       Random& random)
      : network_(network),
        durations_(durations),
        policy_(policy),
        random_(random),
        dispatcher_(network, MissionTime()),
        chosen_(network.plan.nodes.size(), kInfinite) {}

  Execution run() {
    result_.events.push_back({network_.plan.origin, MissionTime(), false});
    keep(dispatcher_.handle(TimePassed{}, now_));
    // The host does not stop at a contingency that nature announced: it watches what goes on.
    while (!dispatcher_.stopped() && !dispatcher_.complete() && step()) {
    }
    finish();
    return std::move(result_);
  }

 private:
  bool step() {
    const auto natural = next_end();
    const auto choice = next_choice();
    const auto wake = dispatcher_.next_wakeup();
    if (natural && (!choice || natural->second <= choice->second) &&
        (!wake || natural->second <= *wake)) {
      return happen(Observed{natural->first}, natural->first, natural->second, true);
    }
    if (choice && (!wake || choice->second <= *wake)) {
      return happen(Executed{choice->first}, choice->first, choice->second, false);
    }
    if (!wake) return false;
    now_ = *wake;
    keep(dispatcher_.handle(TimePassed{}, now_));
    return true;
  }

  bool happen(const DispatchInput& input, NodeIndex node, MissionTime at, bool observed) {
    now_ = at;
    keep(dispatcher_.handle(input, now_));
    if (dispatcher_.date(node) != at) return false;
    result_.events.push_back({node, at, observed});
    return true;
  }

  std::optional<std::pair<NodeIndex, MissionTime>> next_end() const {
    std::optional<std::pair<NodeIndex, MissionTime>> next;
    for (std::size_t i = 0; i < durations_.size(); ++i) {
      const ContingentLink& link = network_.plan.contingent[i];
      if (link.min == link.max || dispatcher_.date(link.contingent)) continue;
      const auto activated = dispatcher_.date(link.activation);
      if (!activated) continue;
      const MissionTime at = *activated + Duration::nanoseconds(durations_[i]);
      if (!next || at < next->second) next = {link.contingent, at};
    }
    return next;
  }

  /// Of the nodes that may start, the one whose chosen date comes first.
  std::optional<std::pair<NodeIndex, MissionTime>> next_choice() {
    std::optional<std::pair<NodeIndex, MissionTime>> next;
    for (const NodeIndex node : dispatcher_.startable()) {
      const auto until = dispatcher_.window(node)->until;
      const MissionTime at = choose(node, until);
      if (!next || at < next->second) next = {node, at};
    }
    return next;
  }

  MissionTime choose(NodeIndex node, std::optional<MissionTime> until) {
    if (policy_ == StartPolicy::kEarliest || (!until && policy_ == StartPolicy::kLatest))
      return now_;
    if (policy_ == StartPolicy::kLatest) return *until;
    if (chosen_[node] == kInfinite) {
      constexpr Ticks kAtMost = 100 * kTicksPerSecond;
      const Ticks room = until ? (*until - now_).count() : kAtMost;
      chosen_[node] =
          (now_ + Duration::nanoseconds(between(0, std::max<Ticks>(room, 0), random_))).count();
    }
    const MissionTime at = std::max(MissionTime::nanoseconds(chosen_[node]), now_);
    return until ? std::min(at, *until) : at;
  }

  void keep(const std::vector<DispatchEffect>& effects) {
    for (const DispatchEffect& effect : effects) {
      if (const auto* contingency = std::get_if<Contingency>(&effect)) {
        result_.contingencies.push_back(*contingency);
      }
    }
  }

  void finish() {
    std::vector<std::optional<Ticks>> dates(network_.plan.nodes.size());
    for (NodeIndex node = 0; node < dates.size(); ++node) {
      if (const auto date = dispatcher_.date(node)) dates[node] = date->count();
    }
    result_.violated = find_violations(network_.plan, dates);
    result_.complete = dispatcher_.complete();
  }

  const DispatchableNetwork& network_;
  const std::vector<Ticks>& durations_;
  StartPolicy policy_;
  Random& random_;
  Dispatcher dispatcher_;
  std::vector<Ticks> chosen_;
  MissionTime now_;
  Execution result_;
};

bool within(Ticks distance, Ticks min, Ticks max) { return distance >= min && distance <= max; }

}  // namespace

std::vector<Ticks> draw_durations(const Stnu& network, Random& random) {
  std::vector<Ticks> durations;
  durations.reserve(network.contingent.size());
  for (const ContingentLink& link : network.contingent) {
    switch (random.below(3)) {
      case 0:
        durations.push_back(link.min);
        break;
      case 1:
        durations.push_back(link.max);
        break;
      default:
        durations.push_back(between(link.min, link.max, random));
    }
  }
  return durations;
}

Execution execute(const DispatchableNetwork& network, const std::vector<Ticks>& durations,
                  StartPolicy policy, Random& random) {
  SKEIN_EXPECTS(durations.size() == network.plan.contingent.size());
  return Play(network, durations, policy, random).run();
}

std::vector<LinkRef> find_violations(const Stnu& network,
                                     const std::vector<std::optional<Ticks>>& dates) {
  SKEIN_EXPECTS(dates.size() == network.nodes.size());
  std::vector<LinkRef> violated;
  for (std::uint32_t i = 0; i < network.arcs.size(); ++i) {
    const Arc& arc = network.arcs[i];
    if (!dates[arc.from] || !dates[arc.to]) continue;
    if (within(*dates[arc.to] - *dates[arc.from], arc.min, arc.max)) continue;
    violated.push_back({LinkKind::kRequirement, i});
  }
  for (std::uint32_t i = 0; i < network.contingent.size(); ++i) {
    const ContingentLink& link = network.contingent[i];
    if (!dates[link.activation] || !dates[link.contingent]) continue;
    if (within(*dates[link.contingent] - *dates[link.activation], link.min, link.max)) continue;
    violated.push_back({LinkKind::kContingent, i});
  }
  return violated;
}

}  // namespace skein::temporal
