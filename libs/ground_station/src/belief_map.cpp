// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/belief_map.hpp"

#include <algorithm>
#include <cmath>

#include "device_name.hpp"
#include "evidence.hpp"
#include "skein/foundation/contract.hpp"

namespace skein::ground_station {

namespace {

using world::Vector2;
using world::Vector3;

/// Columns and rows, the last ones left out.
struct Window {
  std::size_t west = 0, east = 0, south = 0, north = 0;
};

std::size_t clamped(double index, std::size_t most) {
  return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(most)));
}

/// How far from a detection what was detected may be [m].
double gate_of(const world::Detection& detection, const PpsConfig& config) {
  const double spread = std::max(detection.spread, config.least_spread);
  return std::max(config.gate * spread, config.least_separation);
}

// What lies within range of the look or within the gate of a detection.
Window window_of(const world::Perception& look, const PpsConfig& config, const world::Grid& grid) {
  Vector2 least = look.viewpoint.head<2>().array() - look.range;
  Vector2 most = look.viewpoint.head<2>().array() + look.range;
  for (const world::Detection& one : look.detections) {
    const double gate = gate_of(one, config);
    least = least.cwiseMin(Vector2(one.position.head<2>().array() - gate));
    most = most.cwiseMax(Vector2(one.position.head<2>().array() + gate));
  }
  return {clamped(std::floor((least.x() - grid.west) / grid.cell), grid.columns),
          clamped(std::ceil((most.x() - grid.west) / grid.cell), grid.columns),
          clamped(std::floor((least.y() - grid.south) / grid.cell), grid.rows),
          clamped(std::ceil((most.y() - grid.south) / grid.cell), grid.rows)};
}

}  // namespace

BeliefMap::BeliefMap(PpsConfig config, const world::Terrain& terrain, const world::Grid& grid)
    : config_(std::move(config)), terrain_(terrain), grid_(grid), cells_(grid.size()) {
  SKEIN_EXPECTS(problems_of(config_).empty());
}

std::vector<std::size_t> BeliefMap::handle(const world::Perception& heard) {
  world::Perception look = heard;
  std::erase_if(look.detections, [&](const world::Detection& one) {
    return !is_sane(one) || one.confidence < config_.least_confidence;
  });
  const world::SensorEvidence* evidence = evidence_of(config_, look);
  if (evidence == nullptr || !is_sane(look)) return {};
  Device& device = devices_[device_of(look)];
  if (device.last && look.at - *device.last < apart(config_)) return {};
  device.last = look.at;
  device.evidence.resize(cells_.size());
  std::vector<std::size_t> rows;
  const Window window = window_of(look, config_, grid_);
  for (std::size_t row = window.south; row < window.north; ++row) {
    bool changed = false;
    for (std::size_t column = window.west; column < window.east; ++column) {
      const std::size_t cell = grid_.index(column, row);
      const auto ratio = said(look, *evidence, cell);
      if (ratio) add(device, cell, *ratio, evidence->limit);
      changed = changed || ratio;
    }
    if (changed) rows.push_back(row);
  }
  return rows;
}

std::optional<double> BeliefMap::belief(std::size_t cell) const {
  if (!cells_.at(cell).looked_at) return std::nullopt;
  return sigmoid(logit(config_.prior) + cells_[cell].log_odds);
}

// Of several detections that may come from the cell the one that speaks for fire most counts.
std::optional<double> BeliefMap::said(const world::Perception& look,
                                      const world::SensorEvidence& evidence,
                                      std::size_t cell) const {
  const Vector2 middle = grid_.centre(cell);
  std::optional<double> most;
  for (const world::Detection& one : look.detections) {
    if ((one.position.head<2>() - middle).norm() > gate_of(one, config_)) continue;
    most = std::max(most.value_or(-INFINITY), log_ratio(evidence, &one));
  }
  if (most) return most;
  const Vector3 ground(middle.x(), middle.y(), terrain_.elevation(middle.x(), middle.y()));
  if (!surely_in_view(look, ground, 0, terrain_)) return std::nullopt;
  return log_ratio(evidence, nullptr);
}

void BeliefMap::add(Device& device, std::size_t cell, double ratio, double limit) {
  const double before = device.evidence[cell];
  const double after = std::clamp(before + ratio, -limit, limit);
  device.evidence[cell] = static_cast<float>(after);
  cells_[cell].log_odds += static_cast<float>(after - before);
  cells_[cell].looked_at = true;
}

}  // namespace skein::ground_station
