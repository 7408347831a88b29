// SPDX-License-Identifier: Apache-2.0
#include "skein/mastn_experiment/experiment_cells.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace skein::temporal {

namespace {

using Rows = std::vector<const ExperimentRow*>;

// Of a count per perturbation, over networks.
Spread per_perturbation(const Rows& rows,
                        const std::function<std::uint64_t(const ExperimentRow&)>& count) {
  std::vector<double> values;
  for (const ExperimentRow* row : rows) {
    values.push_back(static_cast<double>(count(*row)) /
                     static_cast<double>(std::max<std::uint64_t>(1, row->perturbations)));
  }
  return spread_of(values);
}

// Of a count over perturbations between consistent states, over the networks that have some.
Spread per_calm(const Rows& rows, const std::function<std::uint64_t(const ExperimentRow&)>& count) {
  std::vector<double> values;
  for (const ExperimentRow* row : rows) {
    if (row->calm == 0) continue;
    values.push_back(static_cast<double>(count(*row)) / static_cast<double>(row->calm));
  }
  return spread_of(values);
}

// Of a number of checks against those of a single agent, over networks.
Spread against_single(const Rows& rows,
                      const std::function<std::uint64_t(const ExperimentRow&)>& checks) {
  std::vector<double> values;
  for (const ExperimentRow* row : rows) {
    values.push_back(static_cast<double>(checks(*row)) /
                     static_cast<double>(std::max<std::uint64_t>(1, row->single_checks)));
  }
  return spread_of(values);
}

CellFigures figures_of(const Rows& rows, Algorithm algorithm) {
  const auto traffic = [algorithm](const ExperimentRow& row) -> const Traffic& {
    return row.of(algorithm).traffic;
  };
  CellFigures figures;
  figures.data = per_perturbation(rows, [&](const auto& row) { return traffic(row).data(); });
  figures.calm = per_calm(rows, [&](const auto& row) { return row.of(algorithm).calm_data; });
  figures.consistency =
      per_perturbation(rows, [&](const auto& row) { return traffic(row).consistency; });
  figures.packs =
      algorithm == Algorithm::kDipM
          ? per_perturbation(rows, [&](const auto& row) { return traffic(row).macro_packs; })
          : figures.data;
  figures.macro_arcs =
      per_perturbation(rows, [&](const auto& row) { return traffic(row).macro_arcs; });
  figures.computation =
      against_single(rows, [&](const auto& row) { return row.of(algorithm).checks; });
  figures.eliminations =
      against_single(rows, [&](const auto& row) { return row.of(algorithm).eliminations; });
  for (const ExperimentRow* row : rows) {
    figures.most_data =
        std::max(figures.most_data, static_cast<double>(row->of(algorithm).most_data));
    for (std::size_t turn = 0; turn < kTurns; ++turn) {
      const Traffic& most = row->of(algorithm).most[turn];
      if (most.data() > figures.most[turn].data()) figures.most[turn] = most;
    }
  }
  return figures;
}

ExperimentCell cell_of(const Rows& rows) {
  ExperimentCell cell;
  cell.mode = rows.front()->mode;
  cell.shape = rows.front()->shape;
  cell.networks = rows.size();
  const auto count = static_cast<double>(rows.size());
  for (const ExperimentRow* row : rows) {
    cell.frontier += row->frontier / count;
    for (std::size_t turn = 0; turn < kTurns; ++turn) cell.turns[turn] += row->turns[turn];
    cell.greatest_boundary =
        std::max(cell.greatest_boundary, static_cast<double>(row->greatest_boundary));
  }
  cell.inconsistent = per_perturbation(rows, [](const auto& row) { return row.inconsistent; }).mean;
  cell.single_checks = per_perturbation(rows, [](const auto& row) { return row.single_checks; });
  cell.full_checks = per_perturbation(rows, [](const auto& row) { return row.full_checks; });
  for (const Algorithm algorithm : kAllAlgorithms) {
    cell.algorithms[static_cast<std::size_t>(algorithm)] = figures_of(rows, algorithm);
  }
  return cell;
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto count = static_cast<double>(values.size());
  Spread spread;
  for (const double value : values) spread.mean += value / count;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  if (values.size() > 1) spread.deviation = std::sqrt(squares / (count - 1));
  return spread;
}

double ExperimentCell::saving() const {
  return single_checks.mean > 0 ? full_checks.mean / single_checks.mean : 0;
}

std::vector<ExperimentCell> cells_of(const std::vector<ExperimentRow>& rows) {
  std::vector<Rows> groups;
  for (const ExperimentRow& row : rows) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&row](const Rows& one) {
      return one.front()->mode == row.mode && one.front()->shape == row.shape;
    });
    if (group == groups.end()) {
      groups.push_back({&row});
    } else {
      group->push_back(&row);
    }
  }
  std::vector<ExperimentCell> cells;
  std::transform(groups.begin(), groups.end(), std::back_inserter(cells), cell_of);
  return cells;
}

const ExperimentCell* find_cell(const std::vector<ExperimentCell>& cells, std::uint32_t agents,
                                std::uint32_t external) {
  const auto found = std::find_if(cells.begin(), cells.end(), [=](const ExperimentCell& cell) {
    return cell.mode == ScenarioMode::kKept && cell.shape.agents == agents &&
           cell.shape.external == external;
  });
  return found == cells.end() ? nullptr : &*found;
}

}  // namespace skein::temporal
