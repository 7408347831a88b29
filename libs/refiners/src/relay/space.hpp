// SPDX-License-Identifier: Apache-2.0
// Possible places of relays, and the margins of their links.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/relay.hpp"

namespace skein::refiners::relay {

using world::Vector3;
using world::Voxel;

/// The airspace and radio model of a query. The world must outlive it.
class Space {
 public:
  /// Builds the airspace; nothing if the time is up before.
  static std::optional<Space> in_time(const RelayQuery& query, const world::World& world,
                                      const Budget& budget);

  const world::AirspaceGrid& grid() const { return airspace_.grid(); }
  Vector3 centre(const Voxel& voxel) const { return airspace_.centre(voxel); }
  /// Whether the voxel is free and not above the vehicle's ceiling.
  bool is_open(const Voxel& voxel) const;

  double least_margin() const { return least_margin_; }
  /// Margin of a link with line of sight [dB].
  double margin(double distance) const { return radio_.margin(distance); }
  bool is_in_sight(const Vector3& a, const Vector3& b) const {
    return !radio_.needs_line_of_sight || terrain_.line_of_sight(a, b);
  }
  /// Length of a link at which its margin is the least permitted one [m].
  double longest_link() const;

 private:
  Space(const RelayQuery& query, const world::World& world, world::Airspace airspace);

  const world::Terrain& terrain_;
  const world::RadioModel& radio_;
  world::Airspace airspace_;
  double ceiling_, least_margin_;
};

/// Counts computed links against the budget, and polls its clock.
class Meter {
 public:
  explicit Meter(const Budget& budget) : budget_(budget) {}
  /// Counts one link; false if the budget is used up.
  bool link() {
    if (effort_.steps >= budget_.steps) over_ = true;
    if (over_) return false;
    ++effort_.steps;
    return work(64);
  }
  /// Counts other work, in units of some 50 ns; false once the time is up.
  bool work(std::uint32_t units = 1) {
    if ((done_ += units) >= kPatience) {
      done_ = 0;
      if (budget_.expired()) over_ = effort_.cut_short = true;
    }
    return !over_;
  }
  bool over() const { return over_; }
  const Effort& effort() const { return effort_; }

 private:
  static constexpr std::uint32_t kPatience = 4096;
  const Budget& budget_;
  Effort effort_;
  std::uint32_t done_ = 0;
  bool over_ = false;
};

struct Place {
  Vector3 position = Vector3::Zero();
  double margin = 0;  ///< of the weaker of its two links [dB]
};

/// The best open voxel for one relay between two places; nothing if none has the least margin to
/// both, or the budget is used up. Exact: voxels are tried by increasing distance, so the first
/// with line of sight to both is the best. Ground that hides a voxel also hides those below it, so
/// few voxels are tested.
std::optional<Place> best_between(const Space& space, const Vector3& a, const Vector3& b,
                                  Meter& meter);

struct Chain {
  std::vector<Vector3> positions;
  double margin = 0;   ///< [dB]
  double spacing = 0;  ///< as in Relay
};

/// The fewest relays, from 2 to `most`; see refine(RelayQuery).
std::optional<Chain> best_chain(const Space& space, const RelayQuery& query, Meter& meter);

}  // namespace skein::refiners::relay
