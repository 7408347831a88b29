// SPDX-License-Identifier: Apache-2.0
#include "testing/differential.hpp"

#include <algorithm>
#include <map>

#include "skein/foundation/random.hpp"
#include "skein/temporal_lab/mastn_generator.hpp"
#include "skein/temporal_lab/reference_solution.hpp"

namespace skein::temporal::testing {

namespace {

constexpr Ticks kSecond = kTicksPerSecond;
// Far above what any correct run needs: what never becomes quiet is stopped here.
constexpr std::size_t kMostMessages = 50'000;

Ticks seconds_between(Random& random, Ticks min, Ticks max) {
  return (min + static_cast<Ticks>(random.below(static_cast<std::uint64_t>(max - min + 1)))) *
         kSecond;
}

std::uint32_t between(Random& random, std::uint32_t min, std::uint32_t max) {
  return min + static_cast<std::uint32_t>(random.below(max - min + 1));
}

class Author {
 public:
  explicit Author(std::uint64_t seed) : seed_(seed), random_(seed, "mastn/differential") {}

  DifferentialScenario run() {
    const MastnShape shape{between(random_, 2, 5), between(random_, 2, 8), between(random_, 0, 4),
                           between(random_, 1, 4)};
    scenario_.network = generate_mastn(shape, random_.bits());
    arcs_ = scenario_.network.arcs;
    for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc) {
      if (!is_external(scenario_.network, arcs_[arc])) local_.push_back(arc);
    }
    relaxations_ = random_.uniform(0.15, 0.55);
    if (random_.chance(0.5)) scenario_.transport.longest_delay = seconds_between(random_, 1, 20);
    scenario_.transport.seed = random_.bits();
    scenario_.transport.in_order = random_.chance(0.5);
    cuts_ = random_.chance(0.33);
    careful_ = random_.chance(0.7);
    random_.chance(0.5) ? add_steps_of_experiment() : add_steps_of_any_kind();
    scenario_.actions.push_back({Action::Kind::kCompare, 0, {}, 0});
    return std::move(scenario_);
  }

 private:
  void add_steps_of_experiment() {
    ScenarioOptions options;
    options.mode = random_.chance(0.5) ? ScenarioMode::kKept : ScenarioMode::kFree;
    options.relaxations = relaxations_;
    std::vector<ArcUpdate> batch;
    for (const Step& step : make_scenario(scenario_.network, local_, options, seed_)) {
      batch.push_back({step.arc, step.min, step.max});
      if (random_.chance(0.3)) continue;
      add_disturbance(std::move(batch));
      batch.clear();
    }
  }

  void add_steps_of_any_kind() {
    const std::uint32_t steps = between(random_, 5, 40);
    for (std::uint32_t step = 0; step < steps; ++step) {
      std::map<std::uint32_t, ArcUpdate> batch;  // an arc at most once
      do {
        const std::uint32_t index = local_[random_.below(local_.size())];
        change(index);
        batch[index] = {index, arcs_[index].min, arcs_[index].max};
      } while (random_.chance(0.3));
      std::vector<ArcUpdate> changes;
      for (const auto& [index, change] : batch) changes.push_back(change);
      add_disturbance(std::move(changes));
    }
  }

  void relax(std::uint32_t index) {
    Arc& arc = arcs_[index];
    const std::uint64_t kind = random_.below(12);
    const bool bounded = arc.min != kMinusInfinite && arc.max != kInfinite;
    if (kind < 5 && bounded) {  // fixed outside
      const Ticks by = seconds_between(random_, 1, 10);
      arc.min = arc.max = random_.chance(0.5) ? arc.min - by : arc.max + by;
      return;
    }
    if (kind < 9 && arc.min != kMinusInfinite) arc.min -= seconds_between(random_, 0, 10);
    if (kind > 6 && arc.max != kInfinite) arc.max += seconds_between(random_, 0, 10);
    if (kind == 10 && random_.chance(0.5)) arc.max = kInfinite;
    if (kind == 11 && random_.chance(0.5)) arc.min = kMinusInfinite;
  }

  // A careful author keeps the network consistent where he can, and puts arcs back where he cannot.
  void change(std::uint32_t index) {
    const bool consistent = solve_reference(scenario_.network.nodes.size(), arcs_).consistent;
    if (careful_ && !consistent && random_.chance(0.7)) {
      arcs_[index] = scenario_.network.arcs[index];
    } else if (random_.chance(relaxations_)) {
      relax(index);
    } else {
      contract(index, careful_ && consistent);
    }
  }

  // Into its interval, and into what the whole network allows if `allowed_only`; a bound that had
  // vanished comes back near where it was at first.
  void contract(std::uint32_t index, bool allowed_only) {
    Arc& arc = arcs_[index];
    const Arc& first = scenario_.network.arcs[index];
    if (arc.min == kMinusInfinite) arc.min = std::min(first.min, arc.max);
    if (arc.max == kInfinite) arc.max = std::max(first.max, arc.min);
    ReferenceWindow allowed{arc.min, arc.max};
    const std::size_t nodes = scenario_.network.nodes.size();
    if (allowed_only && solve_reference(nodes, arcs_).consistent) {
      allowed = implied_interval(nodes, arcs_, arc.from, arc.to);
    }
    arc.min = allowed.min + seconds_between(random_, 0, (allowed.max - allowed.min) / kSecond);
    arc.max = random_.chance(0.6)
                  ? arc.min
                  : arc.min + seconds_between(random_, 0, (allowed.max - arc.min) / kSecond);
  }

  void add_disturbance(std::vector<ArcUpdate> changes) {
    if (random_.chance(0.7)) {
      scenario_.actions.push_back({Action::Kind::kWait, seconds_between(random_, 0, 8), {}, 0});
    }
    if (cuts_ && random_.chance(0.15)) add_link_action(Action::Kind::kCut);
    if (cuts_ && random_.chance(0.15)) add_link_action(Action::Kind::kHeal);
    scenario_.actions.push_back({Action::Kind::kDisturb, 0, std::move(changes), 0});
    if (random_.chance(0.15)) scenario_.actions.push_back({Action::Kind::kCompare, 0, {}, 0});
  }

  void add_link_action(Action::Kind kind) {
    scenario_.actions.push_back({kind, 0, {}, random_.bits()});
  }

  std::uint64_t seed_;
  Random random_;
  DifferentialScenario scenario_;
  std::vector<Arc> arcs_;             // as the steps so far have left them
  std::vector<std::uint32_t> local_;  // those that may change
  double relaxations_ = 0;
  bool cuts_ = false;
  bool careful_ = false;
};

class Player {
 public:
  Player(const DifferentialScenario& scenario, MastnSimulation& simulation)
      : network_(scenario.network), simulation_(simulation) {}

  DifferentialOutcome run(const std::vector<Action>& actions) {
    for (const Action& action : actions) {
      outcome_.mismatch = perform(action);
      if (outcome_.mismatch) break;
    }
    outcome_.traffic = simulation_.traffic();
    return outcome_;
  }

 private:
  std::optional<std::string> perform(const Action& action) {
    const auto links = simulation_.links();
    const auto& [one, other] = links[action.link % links.size()];
    switch (action.kind) {
      case Action::Kind::kWait:
        return wait(action.wait);
      case Action::Kind::kDisturb:
        return disturb(action.changes);
      case Action::Kind::kCut:
        simulation_.cut(one, other);
        break;
      case Action::Kind::kHeal:
        simulation_.heal(one, other);
        break;
      case Action::Kind::kCompare:
        return compare();
    }
    return refused();
  }

  std::optional<std::string> wait(Ticks duration) {
    const MissionTime end = simulation_.now() + Duration::nanoseconds(duration);
    return simulation_.run_until(end, kMostMessages) ? std::nullopt : stopped();
  }

  std::optional<std::string> disturb(const std::vector<ArcUpdate>& changes) {
    for (const ArcUpdate& change : changes) {
      network_.arcs[change.arc].min = change.min;
      network_.arcs[change.arc].max = change.max;
    }
    ++outcome_.perturbations;
    if (const std::optional<AgentRefusal> refusal = simulation_.disturb(changes)) {
      return "disturbance refused: " + to_text(refusal->error);
    }
    return std::nullopt;
  }

  std::optional<std::string> compare() {
    simulation_.heal_all();
    if (!simulation_.settle(kMostMessages)) return stopped();
    if (simulation_.blocked_agents() > 0) return "blocked though nothing is under way";
    const ReferenceSolution expected = solve_reference(network_);
    ++outcome_.comparisons;
    outcome_.inconsistent += expected.consistent ? 0U : 1U;
    const std::optional<bool> verdict = simulation_.consistent();
    if (!verdict) return "agents do not agree on the verdict";
    if (*verdict != expected.consistent) {
      return expected.consistent ? "consistent, but they say not"
                                 : "inconsistent, but they say not";
    }
    return expected.consistent ? compare_dates(expected) : std::nullopt;
  }

  std::optional<std::string> compare_dates(const ReferenceSolution& expected) const {
    for (NodeIndex node = 1; node < network_.nodes.size(); ++node) {
      const ReferenceWindow found{simulation_.earliest(node), simulation_.latest(node)};
      const ReferenceWindow& right = expected.windows[node];
      if (found == right) continue;
      return network_.nodes[node] + ": [" + std::to_string(found.min) + ", " +
             std::to_string(found.max) + "] instead of [" + std::to_string(right.min) + ", " +
             std::to_string(right.max) + "]";
    }
    return std::nullopt;
  }

  std::optional<std::string> refused() const {
    if (!simulation_.refusal()) return std::nullopt;
    return "message refused: " + to_text(simulation_.refusal()->error);
  }

  std::optional<std::string> stopped() const {
    return refused().value_or("not quiet after " + std::to_string(kMostMessages) + " messages");
  }

  Mastn network_;  // as disturbed
  MastnSimulation& simulation_;
  DifferentialOutcome outcome_;
};

bool bears_any_order(Algorithm algorithm) {
  return algorithm == Algorithm::kDipG || algorithm == Algorithm::kDipM;
}

}  // namespace

DifferentialScenario make_differential_scenario(std::uint64_t seed) { return Author(seed).run(); }

DifferentialOutcome play(const DifferentialScenario& scenario, Algorithm algorithm,
                         const DifferentialOptions& options) {
  TransportOptions transport = scenario.transport;
  transport.in_order = !options.out_of_order && (!bears_any_order(algorithm) || transport.in_order);
  transport.renumbers = options.out_of_order;
  Result<MastnSimulation, AgentRefusal> simulation =
      MastnSimulation::make(algorithm, scenario.network, transport, options.maker);
  if (!simulation) {
    DifferentialOutcome refused;
    refused.mismatch = "network refused: " + to_text(simulation.error().error);
    return refused;
  }
  return Player(scenario, *simulation).run(scenario.actions);
}

}  // namespace skein::temporal::testing
