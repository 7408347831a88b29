// SPDX-License-Identifier: Apache-2.0
// Dubins curves with turns added, until they are as long as a climb needs.
#pragma once

#include <vector>

#include "skein/refiners/dubins.hpp"

namespace skein::refiners {

using LevelWay = std::vector<world::Vector2>;

/// Length [m].
double length_of(const LevelWay& way);
/// Neighbours closer than `same` [m] are one, since the direction between them is mostly rounding.
/// Both ends stay; any point left out was on the curve, so what remains is sampled from it too.
LevelWay without_doubles(const LevelWay& way, double same);

/// What is added to a Dubins curve.
struct AddedTurn {
  double place = 0;         ///< where, in parts of the curve, [0, 1]
  bool left = true;         ///< which way round
  bool at_the_end = false;  ///< the part of a circle is flown before the place, not after it
};

/// Turns the shortest curve between two poses so that, sampled with `tolerance`, it is at least
/// `least` long [m]: whole circles, and of a further one no more than it takes; from there the
/// shortest curve leads on. Hardly longer than `least`, but where no part of a circle gives that
/// length: up to a circle longer. As the shortest curve where that is as long already.
/// Cost: at most some 50 Dubins curves, and one sampling. Source: the cases of Dubins airplanes
/// (Owen, Beard and McLain 2015), of which those of middle and great height are one here.
LevelWay lengthened(const Pose& from, const Pose& to, double radius, const AddedTurn& turn,
                    double least, double tolerance);

}  // namespace skein::refiners
