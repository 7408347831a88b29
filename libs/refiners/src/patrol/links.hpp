// SPDX-License-Identifier: Apache-2.0
// How far it is from the end of one block to the beginning of another, and the way there.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol/field.hpp"
#include "skein/refiners/dubins.hpp"

namespace skein::refiners {

/// Block b flown forwards is 2 b, backwards 2 b + 1.
using Visit = std::uint32_t;

/// Turns of a vehicle that cannot hover may leave the zone by as many turn radii, never what is
/// closed: the widest turn back onto a track beside the last takes about as much.
inline constexpr double kTurningRoom = 3;

/// Links are straight, or shortest curves of bounded curvature for a vehicle that cannot hover;
/// where that is closed, they lead over other blocks. Reversible: there and back are as far.
/// Prepared once. Thread rule: one thread (it remembers).
class PatrolLinks {
 public:
  /// `radius`: least turn radius [m]; 0: hovers. `tolerance`: of the chords of curves [m].
  /// The blocks and the space must outlive it.
  PatrolLinks(const std::vector<PatrolBlock>& blocks, const PatrolSpace& space, double radius,
              double tolerance);

  /// Looks for what detours lead over, so that no question takes long afterwards; false when the
  /// time is up before: then nothing more may be asked.
  bool prepare(Deadline& deadline);
  /// From the end of one visit to the beginning of the other [m]; infinite: there is no way.
  double cost(Visit from, Visit to) const {
    const float known = known_[from * visits_ + to];
    return known == known ? static_cast<double>(known) : find_cost(from, to);
  }
  /// True when every sequence of visits among those that are so linked can be flown: from one to
  /// the other, and from there back, by direct links or over other blocks.
  bool leads_there_and_back(Visit from, Visit to) const;
  /// Adds the points strictly between the end of one and the beginning of the other. Precondition:
  /// there is a way (cost is finite).
  void append_way(Visit from, Visit to, std::vector<world::Vector2>& way) const;
  /// From a place outside the blocks, with a heading there, if the vehicle minds.
  double cost_from(const world::Vector2& start, double heading, Visit to) const;
  void append_way_from(const world::Vector2& start, double heading, Visit to,
                       std::vector<world::Vector2>& way) const;
  /// A circle through a point, that stays open, of a radius from `least` to `most` [m]; from that
  /// point to it again. Empty: there is none. For a vehicle that hovers.
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
  bool plain_;  ///< every link is the straight one
  std::size_t visits_;
  mutable std::vector<float> known_;      ///< cost; NaN: not asked yet
  mutable std::vector<float> direct_;     ///< without detours; NaN: not asked yet
  mutable std::vector<Detours> detours_;  ///< empty: not asked yet
  std::vector<std::vector<Visit>> near_;  ///< by direct open links; empty: not prepared, or plain
};

}  // namespace skein::refiners
