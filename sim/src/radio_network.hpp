// SPDX-License-Identifier: Apache-2.0
// The radio between all pairs of nodes.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "skein/sim/messages.hpp"
#include "skein/sim/simulator_config.hpp"

namespace skein::sim {

/// Both directions of a pair are equal except for scripts of one direction. Geometry is evaluated
/// once per radio period, scripts at the first update after they begin or end. Memory and cost of
/// an update: the pairs in reach of each other.
class RadioNetwork {
 public:
  /// `nodes`: their names, in the order of the positions given to update.
  RadioNetwork(const SimulatorConfig& config, std::vector<std::string> nodes);

  /// Whether update() has anything to evaluate.
  bool due(MissionTime now) const { return now >= next_; }
  /// Adds a LinkChange for each change; the first time for each link, or where most are down for
  /// kEveryLink and each link that is up.
  void update(const std::vector<world::Vector3>& positions, const world::Terrain& terrain,
              MissionTime now, std::vector<Effect>& effects);

 private:
  using Ends = std::pair<std::size_t, std::size_t>;  ///< the smaller index first
  struct Pair {
    bool in_contact = false;                     ///< by geometry, without the cuts
    std::array<world::RadioLink, 2> links = {};  ///< from first to second, and back; as last told
  };
  /// Of a pair that is left out.
  static const Pair kBothDown;
  /// Which pairs are in contact by geometry.
  void look(const std::vector<world::Vector3>& positions, const world::Terrain& terrain);
  void tell_all(MissionTime now, std::vector<Effect>& effects) const;
  void tell(std::size_t from, std::size_t to, const world::RadioLink& is, MissionTime now,
            std::vector<Effect>& effects) const;
  /// The link from one node to the other of a pair in contact.
  world::RadioLink link(const Ends& ends, std::size_t from, std::size_t to, MissionTime now) const;
  MissionTime next_after(MissionTime now) const;

  world::RadioModel model_;
  std::vector<RadioCut> cuts_;
  std::vector<RadioScript> scripts_;
  Duration period_;
  std::vector<std::string> nodes_;
  std::set<Ends> scripted_;  ///< some script or cut is about this pair
  std::map<Ends, Pair> pairs_;
  MissionTime next_;
  MissionTime next_look_;
  bool first_ = true;
};

}  // namespace skein::sim
