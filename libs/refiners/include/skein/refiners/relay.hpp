// SPDX-License-Identifier: Apache-2.0
// relay: positions of relays that connect two nodes by radio.
#pragma once

#include <vector>

#include "skein/refiners/refinement.hpp"
#include "skein/refiners/setting.hpp"
#include "skein/world/vehicle_model.hpp"

namespace skein::refiners {

struct RelayQuery {
  world::VehicleModel vehicle;  ///< of every relay
  world::Vector3 a = world::Vector3::Zero(), b = world::Vector3::Zero();
  std::size_t most = 1;     ///< relays, from 1 to 64
  double least_margin = 0;  ///< of every link [dB], >= 0
  double clearance = 20;    ///< least height over the ground [m], >= 0
  MissionTime at;           ///< volumes with a time window count from then on
};

struct Relay {
  std::vector<world::Vector3> positions;  ///< from a to b; empty: a direct link exists
  double margin = 0;                      ///< of the weakest link [dB]
  /// Distance between the candidate places [m]: the side of a voxel, or more for a chain in a large
  /// airspace.
  double spacing = 0;
};

/// The fewest relays, and among those the greatest margin of the weakest link, over the centres of
/// the free voxels of the airspace that are no higher over the ground than the vehicle's ceiling.
/// One relay: exact over all voxels. Two and more: exact over all voxels too, where there are at
/// most kMostRelayPlaces; else over every n-th of them along each axis, with the least n that
/// leaves no more, after which each relay is moved to the best voxel between its neighbours. In a
/// large airspace a shorter chain, or one through a narrow gap, may thus be missed: see
/// Relay::spacing. Refused: a or b in the ground (kBlocked); no such chain (kNoContact). Refined
/// cost: number of relays; its duration is zero. Steps of the budget: links computed.
Outcome<Relay> refine(const RelayQuery& query, const Setting& setting);

inline constexpr std::size_t kMostRelayPlaces = 8192;

}  // namespace skein::refiners
