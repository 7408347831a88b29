// SPDX-License-Identifier: Apache-2.0
// The radio between all pairs of nodes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "skein/sim/messages.hpp"
#include "skein/sim/simulator_config.hpp"

namespace skein::sim {

/// Both directions of a pair are equal except for scripts of one direction. Geometry is evaluated
/// once per radio period, scripts at the first update after they begin or end.
class RadioNetwork {
 public:
  /// `nodes`: their names, in the order of the positions given to update.
  RadioNetwork(const SimulatorConfig& config, std::vector<std::string> nodes);

  /// Whether update() has anything to evaluate.
  bool due(MissionTime now) const { return now >= next_; }
  /// Adds a LinkChange for each change (the first time: for each link).
  void update(const std::vector<world::Vector3>& positions, const world::Terrain& terrain,
              MissionTime now, std::vector<Effect>& effects);

 private:
  struct Pair {
    std::size_t a, b;
    bool in_contact = true;                      ///< by geometry, without the cuts
    std::array<world::RadioLink, 2> links = {};  ///< from a to b, from b to a
    bool scripted = false;                       ///< some script or cut is about this pair
  };
  /// The link from one node to the other.
  world::RadioLink link(const Pair& pair, std::size_t from, std::size_t to, MissionTime now) const;
  MissionTime next_after(MissionTime now) const;

  world::RadioModel model_;
  std::vector<RadioCut> cuts_;
  std::vector<RadioScript> scripts_;
  Duration period_;
  std::vector<std::string> nodes_;
  std::vector<Pair> pairs_;
  MissionTime next_;
  MissionTime next_look_;
  bool first_ = true;
};

}  // namespace skein::sim
