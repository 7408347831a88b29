// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/mastn_experiment.hpp"

#include <algorithm>
#include <cstdio>

#include "macro_boundary.hpp"
#include "skein/foundation/contract.hpp"
#include "skein/temporal/stn_engine.hpp"

namespace skein::temporal {

namespace {

// Any perturbation of the experiment is quiet long before.
constexpr std::size_t kMostMessages = 10'000'000;

Stn as_single(const Mastn& mastn) { return {mastn.nodes, 0, mastn.arcs}; }

StnEngine engine_of(const Stn& network) {
  Result<StnEngine, StnRefusal> engine = StnEngine::make(network);
  SKEIN_EXPECTS(engine.has_value());
  return std::move(*engine);
}

/// What is right after each step, and what a single agent does for it.
struct Reference {
  struct Point {
    bool consistent;
    std::vector<Ticks> earliest;
    std::vector<Ticks> latest;
  };
  std::vector<Point> points;
  std::uint64_t checks = 0;
  std::uint64_t full_checks = 0;
};

Reference play_single(const Mastn& mastn, const std::vector<Step>& steps) {
  Reference reference;
  Stn network = as_single(mastn);
  StnEngine engine = engine_of(network);
  const std::uint64_t at_start = engine.checks();
  for (const Step& step : steps) {
    network.arcs[step.arc].min = step.min;
    network.arcs[step.arc].max = step.max;
    SKEIN_ENSURES(!engine.set_arc({step.arc, step.min, step.max}));
    reference.full_checks += engine_of(network).checks();
    Reference::Point point{engine.consistent(), {}, {}};
    for (NodeIndex node = 0; node < engine.node_count(); ++node) {
      point.earliest.push_back(engine.earliest(node));
      point.latest.push_back(engine.latest(node));
    }
    reference.points.push_back(std::move(point));
  }
  reference.checks = engine.checks() - at_start;
  return reference;
}

constexpr std::size_t index_of(Turn turn) { return static_cast<std::size_t>(turn); }

// Whether the network is consistent before and after a step; at first it is.
bool is_calm(const Reference& reference, std::size_t step) {
  return reference.points[step].consistent && (step == 0 || reference.points[step - 1].consistent);
}

Turn turn_of(const Mastn& mastn, const Step& change, const Reference& reference, std::size_t step) {
  if (step > 0 && !reference.points[step - 1].consistent) return Turn::kBroken;
  if (!reference.points[step].consistent) return Turn::kBreak;
  const auto& arc = mastn.arcs[change.arc];
  const bool inside = change.min >= arc.min && change.max <= arc.max;
  return inside ? Turn::kContraction : Turn::kRelaxation;
}

bool is_right(const MastnSimulation& simulation, const Reference::Point& point) {
  if (simulation.consistent() != point.consistent) return false;
  for (NodeIndex node = 1; point.consistent && node < point.earliest.size(); ++node) {
    if (simulation.earliest(node) != point.earliest[node]) return false;
    if (simulation.latest(node) != point.latest[node]) return false;
  }
  return true;
}

// What no perturbation may send more of: notes 4.1, and 4.2 for the packs.
bool is_within_bound(Algorithm algorithm, const Traffic& sent, std::uint64_t macro_bound) {
  switch (algorithm) {
    case Algorithm::kCip:
      return sent.disturbances == 1;
    case Algorithm::kDipG:
      return sent.data() == 1 && sent.disturbances == 1;
    case Algorithm::kDipL:
      return true;
    case Algorithm::kDipM:
      return sent.macro_bounds <= macro_bound && sent.macro_packs <= 1;
  }
  return false;
}

AlgorithmFigures play(Algorithm algorithm, const Mastn& mastn, const std::vector<Step>& steps,
                      const Reference& reference) {
  Result<MastnSimulation, AgentRefusal> made = MastnSimulation::make(algorithm, mastn);
  SKEIN_EXPECTS(made.has_value());
  MastnSimulation& simulation = *made;
  AlgorithmFigures figures;
  SKEIN_ENSURES(simulation.settle(kMostMessages));
  const MacroBoundary boundary(mastn);
  const std::uint64_t checks = simulation.checks();
  const std::uint64_t eliminations = simulation.elimination_checks();
  const Traffic at_start = simulation.traffic();
  for (std::size_t step = 0; step < steps.size(); ++step) {
    const Traffic before = simulation.traffic();
    const ArcUpdate change{steps[step].arc, steps[step].min, steps[step].max};
    SKEIN_ENSURES(!simulation.disturb({&change, 1}));
    SKEIN_ENSURES(simulation.settle(kMostMessages));
    const Traffic sent = simulation.traffic() - before;
    figures.most_data = std::max(figures.most_data, sent.data());
    Traffic& most = figures.most[index_of(turn_of(mastn, steps[step], reference, step))];
    if (sent.data() > most.data()) most = sent;
    figures.calm_data += is_calm(reference, step) ? sent.data() : 0U;
    figures.wrong += is_right(simulation, reference.points[step]) ? 0U : 1U;
    const std::uint64_t bound = boundary.ordered_pairs(change.arc);
    figures.excess += is_within_bound(algorithm, sent, bound) ? 0U : 1U;
  }
  figures.traffic = simulation.traffic() - at_start;
  figures.checks = simulation.checks() - checks;
  figures.eliminations = simulation.elimination_checks() - eliminations;
  return figures;
}

std::string csv_line(const ExperimentRow& row, Algorithm algorithm) {
  const AlgorithmFigures& figures = row.of(algorithm);
  const Traffic& sent = figures.traffic;
  std::array<char, 32> frontier{};
  std::snprintf(frontier.data(), frontier.size(), "%.4f", row.frontier);
  std::string line = to_text(row.mode);
  for (const std::uint64_t value :
       {std::uint64_t{row.shape.agents}, std::uint64_t{row.shape.nodes},
        std::uint64_t{row.shape.local}, std::uint64_t{row.shape.external}, row.seed}) {
    line += "," + std::to_string(value);
  }
  line += "," + std::string(frontier.data()) + "," + to_text(algorithm);
  for (const std::uint64_t value :
       {row.perturbations, row.inconsistent, sent.data(), sent.disturbances, sent.node_updates,
        sent.updates, sent.relaxations, sent.macro_packs, sent.macro_arcs, sent.macro_bounds,
        sent.consistency, figures.most_data, figures.checks, figures.eliminations,
        row.single_checks, row.full_checks, figures.wrong, row.calm, figures.calm_data}) {
    line += "," + std::to_string(value);
  }
  for (const Traffic& most : figures.most) line += "," + std::to_string(most.data());
  return line + "\n";
}

}  // namespace

ExperimentRow measure(const MastnShape& shape, ScenarioMode mode, std::uint64_t seed,
                      double relaxations) {
  const Mastn mastn = generate_mastn(shape, seed);
  ScenarioOptions options;
  options.mode = mode;
  options.relaxations = relaxations;
  const std::vector<Step> steps = make_scenario(mastn, chain_arcs(shape), options, seed);
  const Reference reference = play_single(mastn, steps);
  ExperimentRow row;
  row.mode = mode;
  row.shape = shape;
  row.seed = seed;
  row.frontier = frontier_ratio(mastn);
  row.perturbations = steps.size();
  for (const Reference::Point& point : reference.points)
    row.inconsistent += point.consistent ? 0U : 1U;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    row.calm += is_calm(reference, step) ? 1U : 0U;
    ++row.turns[index_of(turn_of(mastn, steps[step], reference, step))];
  }
  row.single_checks = reference.checks;
  row.full_checks = reference.full_checks;
  row.greatest_boundary = MacroBoundary(mastn).greatest();
  for (const Algorithm algorithm : kAllAlgorithms) {
    row.algorithms[static_cast<std::size_t>(algorithm)] = play(algorithm, mastn, steps, reference);
  }
  return row;
}

std::vector<ExperimentRow> run_experiment(
    const ExperimentPlan& plan, const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::size_t total =
      plan.modes.size() * plan.agents.size() * plan.external.size() * plan.networks;
  std::vector<ExperimentRow> rows;
  for (const ScenarioMode mode : plan.modes) {
    for (const std::uint32_t agents : plan.agents) {
      for (const std::uint32_t external : plan.external) {
        for (std::uint32_t network = 0; network < plan.networks; ++network) {
          const MastnShape shape{agents, plan.nodes, plan.local, external};
          rows.push_back(measure(shape, mode, plan.seed + network, plan.relaxations));
          progress(rows.size(), total);
        }
      }
    }
  }
  return rows;
}

std::string to_text(ScenarioMode mode) { return mode == ScenarioMode::kKept ? "K" : "F"; }

std::string to_csv(const std::vector<ExperimentRow>& rows) {
  std::string text =
      "mode,agents,nodes,local,external,seed,frontier,algorithm,perturbations,inconsistent,data,"
      "disturbances,node_updates,updates,relaxations,macro_packs,macro_arcs,macro_bounds,"
      "consistency,most_data,checks,eliminations,single_checks,full_checks,wrong,"
      "calm,calm_data,most_contraction,most_relaxation,most_break,most_broken\n";
  for (const ExperimentRow& row : rows) {
    for (const Algorithm algorithm : kAllAlgorithms) text += csv_line(row, algorithm);
  }
  return text;
}

}  // namespace skein::temporal
