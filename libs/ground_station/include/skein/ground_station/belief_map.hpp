// SPDX-License-Identifier: Apache-2.0
// Belief in fire per cell of a grid, from what sensors saw and did not see.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"
#include "skein/ground_station/perception_processing.hpp"
#include "skein/world/grid.hpp"
#include "skein/world/perception.hpp"
#include "skein/world/terrain.hpp"

namespace skein::ground_station {

/// Belief in a fire for each cell of a grid, by the rule of PerceptionProcessing applied to the
/// cell's middle: it starts at the prior, each look of a device adds evidence, whether it detects
/// something or not, and the sum of each device's evidence is kept within its limit. A detection
/// counts for all cells within its gate. Fires are not told apart, moved or forgotten: the map is a
/// display of what was searched.
///
/// Looks of one device closer in time than the decorrelation time count once, wherever they look.
/// Deterministic. Thread rule: one thread. Memory: 4 byte for each device and cell. Cost of a look:
/// O(cells within its range + cells in view × cells of terrain on the way).
/// Source: T VI.1.1 (the algorithm is ours, the seeds give none).
class BeliefMap {
 public:
  /// Precondition: problems_of(config) is empty. The terrain must outlive this.
  BeliefMap(PpsConfig config, const world::Terrain& terrain, const world::Grid& grid);

  /// Adds a look. Returns the rows of the grid in which cells changed, counted from the south.
  std::vector<std::size_t> handle(const world::Perception& look);

  /// Probability of a fire in the cell, in (0, 1); absent: no look has given evidence on it.
  std::optional<double> belief(std::size_t cell) const;
  const world::Grid& grid() const { return grid_; }

 private:
  struct Device {
    std::vector<float> evidence;  ///< by cell: natural log-odds, within ±limit
    std::optional<MissionTime> last;
  };
  struct Cell {
    float log_odds = 0;
    bool looked_at = false;
  };

  std::optional<double> said(const world::Perception& look, const world::SensorEvidence& evidence,
                             std::size_t cell) const;
  void add(Device& device, std::size_t cell, double ratio, double limit);

  PpsConfig config_;
  const world::Terrain& terrain_;
  world::Grid grid_;
  std::vector<Cell> cells_;
  std::map<std::string, Device> devices_;  ///< by "uav/device"
};

}  // namespace skein::ground_station
