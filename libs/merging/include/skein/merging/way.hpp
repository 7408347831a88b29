// SPDX-License-Identifier: Apache-2.0
// A flight path as a sequence of reserved volumes, which are released one by one.
#pragma once

#include <cstddef>
#include <vector>

#include "skein/merging/margins.hpp"
#include "skein/merging/volume.hpp"

namespace skein::merging {

/// The volume of a vehicle that holds at `place`.
Volume stay_at(const world::Vector3& place, const Margins& margins);
/// The volume over `place` between two heights [m]: for a takeoff or a landing.
Volume column(const world::Vector2& place, double low, double high, const Margins& margins);

/// A flight through points, at the last of which the vehicle holds. A value.
class Way {
 public:
  Way() = default;
  /// Precondition: at least two points, the first one where the flight begins. Long legs are cut
  /// into pieces, and get additional way-points where wind would carry the vehicle too far off.
  /// `from_rest`: the vehicle holds at the first point, so the first leg is left narrowly; else it
  /// arrives there in flight.
  Way(const std::vector<world::Vector3>& points, const Margins& margins, bool from_rest = true);

  /// The beginnings of the pieces, and the end of the flight.
  const std::vector<world::Vector3>& points() const { return points_; }
  /// What the vehicle is told to fly; the first is where it begins.
  const std::vector<world::Vector3>& way_points() const { return way_points_; }
  /// One per piece, and the holding place at the end; what several pieces lead through, as rounds
  /// over one zone do, once, as of the last of them. Reserved as a whole.
  const Volumes& volumes() const { return volumes_; }
  /// Notes the vehicle's position. True: it has left further pieces.
  bool passed(const world::Vector3& position);
  /// The volumes still needed: of the piece being flown, of the one before it (the vehicle may be
  /// blown back) and of all after it. A vehicle that cannot hover keeps twice the width of its way
  /// behind it, since it turns back to way-points that it missed.
  Volumes left() const;
  /// The length [m] from the beginning of the piece being flown to the end.
  double length_left() const;
  /// True: no piece has been given back yet.
  bool is_whole() const { return first_left() == 0; }

 private:
  void note_rounds();
  std::size_t first_left() const;

  std::vector<world::Vector3> points_, way_points_;
  Volumes pieces_;           ///< one per piece, and the holding place
  std::vector<bool> again_;  ///< by piece: a later one has the same air
  Volumes volumes_;
  bool hovers_ = true;
  double near_ = 0;
  std::size_t piece_ = 0;  ///< being flown
};

}  // namespace skein::merging
