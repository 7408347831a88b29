// SPDX-License-Identifier: Apache-2.0
// Where relays may stand, and how well they hear.
#pragma once

#include <optional>
#include <vector>

#include "skein/refiners/budget.hpp"
#include "skein/refiners/relay.hpp"

namespace skein::refiners::relay {

using world::Vector3;
using world::Voxel;

/// The air of a query. The world must outlive it.
class Space {
 public:
  /// Nothing when the time is up before it is made.
  static std::optional<Space> in_time(const RelayQuery& query, const world::World& world,
                                      const Budget& budget);

  const world::AirspaceGrid& grid() const { return airspace_.grid(); }
  Vector3 centre(const Voxel& voxel) const { return airspace_.centre(voxel); }
  /// Free, and not above the ceiling.
  bool is_open(const Voxel& voxel) const;

  double least_margin() const { return least_margin_; }
  /// Of a link in sight [dB].
  double margin(double distance) const { return radio_.margin(distance); }
  bool is_in_sight(const Vector3& a, const Vector3& b) const {
    return !radio_.needs_line_of_sight || terrain_.line_of_sight(a, b);
  }
  /// The longest link that has the least margin [m].
  double longest_link() const;

 private:
  Space(const RelayQuery& query, const world::World& world, world::Airspace airspace);

  const world::Terrain& terrain_;
  const world::RadioModel& radio_;
  world::Airspace airspace_;
  double ceiling_, least_margin_;
};

/// Counts links, and asks the clock now and then.
class Meter {
 public:
  explicit Meter(const Budget& budget) : budget_(budget) {}
  /// One link computed; false when there is no budget for it.
  bool link() {
    if (effort_.steps >= budget_.steps) over_ = true;
    if (over_) return false;
    ++effort_.steps;
    return work(64);
  }
  /// Work without links, in units of some 50 ns; false once the time is up.
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

/// The best open voxel for one relay between two places, or nothing when none has the least margin
/// to both or the budget ran out first. Places nearer to both first, so the first that sees both is
/// the best: exact. What hides a voxel hides those below it too, so few are looked at.
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
