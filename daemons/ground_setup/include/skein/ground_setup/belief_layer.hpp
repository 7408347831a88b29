// SPDX-License-Identifier: Apache-2.0
// The belief map of the searched ground, for the operators' page.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/blackboard/wire.hpp"
#include "skein/ground_station/belief_map.hpp"
#include "skein/scenario/scenario.hpp"

namespace skein::ground_setup {

/// A BeliefMap over the grid of page_world(), published row by row in the format of the page. For
/// display only; the ground station does not use it. Thread rule: one thread.
class BeliefLayer {
 public:
  explicit BeliefLayer(const scenario::Scenario& scenario);
  BeliefLayer(const BeliefLayer&) = delete;
  BeliefLayer& operator=(const BeliefLayer&) = delete;

  /// New values by key, which replace earlier values of the same key: {"belief": {"row": R,
  /// "cells": TEXT}} with a character for each column: '.' where no sensor has looked, else from
  /// '0' (least belief) to '9'; below '4' the belief is below the prior.
  std::vector<std::pair<std::string, std::string>> see(const wire::Sample& sample);

 private:
  std::string row(std::size_t row) const;

  std::set<std::string> uavs_;  ///< whose looks count: names of others would fill the memory
  double prior_;
  world::Terrain terrain_;
  ground_station::BeliefMap map_;
};

}  // namespace skein::ground_setup
