// SPDX-License-Identifier: Apache-2.0
// Distances and paths from the end of one block to the beginning of another.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/field.hpp"
#include "skein/refiners/dubins.hpp"

namespace skein::refiners {

/// Block b flown forwards is 2 b, backwards 2 b + 1.
using Visit = std::uint32_t;

/// Turns of a vehicle that cannot hover may leave the zone by this many turn radii (but never enter
/// a closed volume), which is about what the widest turn onto the neighbouring track needs.
inline constexpr double kTurningRoom = 3;

/// Links are straight, or shortest curves of bounded curvature for a vehicle that cannot hover;
/// where such a link is closed, the path leads over other blocks. Symmetrical: both directions have
/// the same length. Thread rule: one thread (it caches).
class PatrolLinks {
 public:
  /// `radius`: least turn radius [m]; 0: hovers. `tolerance`: of the chords of curves [m].
  /// The blocks and the space must outlive this object.
  PatrolLinks(const std::vector<PatrolBlock>& blocks, const PatrolSpace& space, double radius,
              double tolerance);

  /// Computes the direct links that detours use, so that later calls are quick. False: the time was
  /// up before; then no other method may be called.
  bool prepare(Deadline& deadline);
  /// Distance from the end of one visit to the beginning of the other [m]; infinite: no path.
  double cost(Visit from, Visit to) const {
    const float known = known_[from * visits_ + to];
    return known == known ? static_cast<double>(known) : find_cost(from, to);
  }
  /// Whether the second visit can be reached from the first and the first from the second, by
  /// direct links or over other blocks. Any sequence of visits that are pairwise so linked can be
  /// flown.
  bool leads_there_and_back(Visit from, Visit to) const;
  /// Appends the points strictly between the end of `from` and the beginning of `to`. Precondition:
  /// cost() is finite.
  void append_way(Visit from, Visit to, std::vector<world::Vector2>& way) const;
  /// The same from a place outside the blocks; `heading` binds only a vehicle that cannot hover.
  double cost_from(const world::Vector2& start, double heading, Visit to) const;
  void append_way_from(const world::Vector2& start, double heading, Visit to,
                       std::vector<world::Vector2>& way) const;
  /// A circle in open space through a point and back to it, of a radius from `least` to `most` [m].
  /// Empty: there is none. For a hovering vehicle.
  std::vector<world::Vector2> small_round(const world::Vector2& at, double most,
                                          double least) const;
  /// Adds the track of the visit itself.
  void append_track(Visit visit, std::vector<world::Vector2>& way) const;

  const world::Vector2& entry(Visit visit) const;
  const world::Vector2& exit(Visit visit) const { return entry(visit ^ 1U); }
  double length(Visit visit) const { return blocks_[visit / 2].length; }
  double heading(Visit visit) const;

 private:
  /// Shortest distances from one visit to all, over other blocks.
  struct Detours {
    std::vector<float> cost;
    std::vector<Visit> before;  ///< the visit that leads there
  };

  double find_cost(Visit from, Visit to) const;
  double direct(Visit from, Visit to) const;
  double direct_cost(Visit from, Visit to) const;
  DubinsCurve shortest(const world::Vector2& from, double heading, Visit to) const;
  std::vector<world::Vector2> link(Visit from, Visit to) const;
  bool is_point_again(Visit from, Visit to) const;
  std::vector<world::Vector2> round_over(Visit visit) const;
  bool is_open(const std::vector<world::Vector2>& curve, bool may_start_outside) const;
  const Detours& detours(Visit from) const;
  void append_direct(Visit from, Visit to, std::vector<world::Vector2>& way) const;
  std::vector<Visit> nearest(Visit from, Deadline& deadline) const;
  const std::vector<Visit>& neighbours(Visit from) const { return near_[from]; }

  const std::vector<PatrolBlock>& blocks_;
  const PatrolSpace& space_;
  double radius_, tolerance_;
  bool plain_;  ///< every link is straight
  std::size_t visits_;
  mutable std::vector<float> known_;      ///< cost; NaN: not asked yet
  mutable std::vector<float> direct_;     ///< without detours; NaN: not asked yet
  mutable std::vector<Detours> detours_;  ///< empty: not asked yet
  std::vector<std::vector<Visit>> near_;  ///< by direct open links; empty: not prepared, or plain
};

}  // namespace skein::refiners
