// SPDX-License-Identifier: Apache-2.0
// partition: an area shared out among several UAVs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

enum class ShareMode : std::uint8_t {
  kProportional,  ///< areas in proportion of speed × swath, as far as endurance allows: the seeds'
  kBalanced,      ///< areas such that all finish at about the same time
};

struct Member {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector2 start = world::Vector2::Zero();  ///< where its part is anchored
  double swath = 0;                               ///< [m], > 0
  double altitude = 0;                            ///< over the ground [m], > 0
  double speed = 0;                               ///< [m/s]; 0: cruise
  double busy = 0;              ///< until it is at its start and can set out [s], >= 0
  std::optional<double> share;  ///< asked for, > 0, relative to the others'; all or none have one
};

/// Seconds from when the member sets out from its start until it has swept the part, so high over
/// the ground, as it flies that; nothing: unknown.
using FlownSweep = std::function<std::optional<double>(const Member& member, double altitude,
                                                       const world::Polygon& part)>;

struct PartitionQuery {
  world::Polygon area;  ///< convex
  std::vector<Member> members;
  /// Members with shares have these areas in either mode.
  ShareMode mode = ShareMode::kProportional;
  MissionTime depart;  ///< volumes with a time window count from then on
  /// Sweeps (from the first lane to the last) that come closer to each other than this on the level
  /// are as far apart in height: those of some members are raised [m]; 0: they need not be.
  double apart = 10;
  /// Balanced shares are reckoned by coverage; then, where this is given, by what is flown, in some
  /// dozens of divisions beyond the steps of the budget (its time holds).
  FlownSweep flown;
};

struct Part {
  std::string uav;
  world::Polygon polygon;  ///< convex, counter-clockwise
  double share = 0;        ///< of the whole area, (0, 1]
  /// In or on the polygon: the start, if it is in the area and no convex division leaves it out;
  /// else the nearest point of the border of the area.
  world::Vector2 anchor = world::Vector2::Zero();
  double altitude = 0;  ///< of the lanes over the ground: the member's, or raised [m]
  Coverage coverage;
  DurationInterval duration;  ///< until it is swept: being busy, coming from the start, sweeping
};

struct Partition {
  std::vector<Part> parts;  ///< one per member, in their order
  double spread = 0;        ///< (latest - earliest) / latest expected finish
  bool apart = true;        ///< false: the time was up before all were as far apart as asked
};

/// Refined cost: the latest expected finish [s]; the duration is that of the last to finish. Steps
/// of the budget: sweeps planned; the first division is planned whatever they are. No member flies
/// on less than its reserve of energy: the others take what it cannot.
/// Refused: an area that is not convex, no members, shares for some only (kBadQuery); more area
/// than the energy of all members can sweep, no height below a ceiling that keeps a sweep apart
/// from its neighbours' (kBeyondVehicle); what refuses a coverage. Source: Hert and Lumelsky 1998
/// (anchored area partition), as used by Mazza and Ollero 2004.
Outcome<Partition> refine(const PartitionQuery& query, const Setting& setting);

/// The geometry alone: cuts a convex polygon in convex parts of these areas, relative to their sum,
/// each with its anchor on it or in it; an anchor outside counts as the nearest point of the
/// border. So does one inside that cannot have its place, as of two in the middle the one with the
/// lesser share cannot: no line leaves so little about the middle. As few as are found give way;
/// with all anchors on the border none has to. Cuts are straight, or fans of three rays where no
/// straight cut does; of the ways to cut few anchors, the one with the most compact parts is taken.
/// Areas are exact to rounding. Cost: O(n² (v + n) v) for n anchors and v corners, up to some
/// hundred times that where anchors inside do not fit.
/// Preconditions: check_polygon passes; convex; as many anchors as shares; finite; shares > 0.
std::vector<world::Polygon> divide(const world::Polygon& area,
                                   const std::vector<world::Vector2>& anchors,
                                   const std::vector<double>& shares);

}  // namespace skein::refiners
