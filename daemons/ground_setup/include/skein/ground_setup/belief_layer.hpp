// SPDX-License-Identifier: Apache-2.0
// What was searched and what is believed of it, for the map of the operators' page.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/ground_station/belief_map.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ground_setup {

/// A BeliefMap over the grid of page_world(), told row by row as the page reads it. It is reckoned
/// beside the ground station and decides nothing. Thread rule: one thread.
class BeliefLayer {
 public:
  explicit BeliefLayer(const scenario::Scenario& scenario);
  BeliefLayer(const BeliefLayer&) = delete;
  BeliefLayer& operator=(const BeliefLayer&) = delete;

  /// By key, what is to be shown instead of what was shown under that key: {"belief": {"row": R,
  /// "cells": TEXT}} with a character for each column, '.' where nobody has looked, from '0' (least
  /// belief) to '9'; below '4' it is below the prior.
  std::vector<std::pair<std::string, std::string>> see(const wire::Sample& sample);

 private:
  std::string row(std::size_t row) const;

  std::set<std::string> uavs_;  ///< whose looks count: names of others would fill the memory
  double prior_;
  world::Terrain terrain_;
  ground_station::BeliefMap map_;
};

}  // namespace skein::ground_setup
