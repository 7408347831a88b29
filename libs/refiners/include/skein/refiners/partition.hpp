// SPDX-License-Identifier: Apache-2.0
// partition: an area divided among several UAVs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/coverage.hpp"

namespace skein::refiners {

enum class ShareMode : std::uint8_t {
  kProportional,  ///< areas in proportion to speed × swath, within endurance: the rule of the seeds
  kBalanced,      ///< areas such that all finish at about the same time
};

struct Member {
  std::string uav;
  world::VehicleModel vehicle;
  world::Vector2 start = world::Vector2::Zero();  ///< anchor of its part
  double swath = 0;                               ///< [m], > 0
  double altitude = 0;                            ///< over the ground [m], > 0
  double speed = 0;                               ///< [m/s]; 0: cruise
  double busy = 0;              ///< time until the member is at its start and free [s], >= 0
  std::optional<double> share;  ///< wanted share, > 0, relative to the others; for all or none
};

/// Duration [s] of a member's real flight from its start to the end of the sweep of `part`, at
/// `altitude` over the ground; nothing: unknown.
using FlownSweep = std::function<std::optional<double>(const Member& member, double altitude,
                                                       const world::Polygon& part)>;

struct PartitionQuery {
  world::Polygon area;  ///< convex
  std::vector<Member> members;
  /// Ignored if the members have wanted shares.
  ShareMode mode = ShareMode::kProportional;
  MissionTime depart;  ///< volumes with a time window count from then on
  /// Least separation of sweeps, first lane to last [m]: sweeps that come closer horizontally are
  /// separated in height by as much, by raising some of them; 0: no separation.
  double apart = 10;
  /// If given, shares that were balanced by the durations of coverage are refined by those of real
  /// flight, in some dozens of divisions beyond the steps of the budget (within its time).
  FlownSweep flown;
};

struct Part {
  std::string uav;
  world::Polygon polygon;  ///< convex, counter-clockwise
  double share = 0;        ///< of the whole area, (0, 1]
  /// A point of the polygon: the member's start if that is in the area and a convex division with
  /// it exists; else the nearest point of the area's border.
  world::Vector2 anchor = world::Vector2::Zero();
  double altitude = 0;  ///< of the lanes over the ground: the member's, possibly raised [m]
  Coverage coverage;
  DurationInterval duration;  ///< until the part is swept: busy time, flight from start, sweep
};

struct Partition {
  std::vector<Part> parts;  ///< one per member, in their order
  double spread = 0;        ///< (latest - earliest) / latest expected finish
  bool apart = true;        ///< false: the time was up before all sweeps were separated
};

/// Refined cost: the latest expected finish [s]; the duration is that of the last member to finish.
/// Steps of the budget: sweeps planned; the first division is planned in any case. No member uses
/// its energy reserve: the others take the area that it cannot sweep.
/// Refused: an area that is not convex, no members, shares for some only (kBadQuery); more area
/// than the energy of all members can sweep, no height below a ceiling that separates a sweep from
/// its neighbours (kBeyondVehicle); refusals of coverage. Source: Hert and Lumelsky 1998 (anchored
/// area partition), as used by Mazza and Ollero 2004.
Outcome<Partition> refine(const PartitionQuery& query, const Setting& setting);

/// The geometric part: cuts a convex polygon into convex parts with areas in proportion to the
/// shares, each containing its anchor. An anchor outside is replaced by the nearest point of the
/// border; so is one inside for which no convex division exists (of two anchors in the middle that
/// with the smaller share: no straight cut leaves so little around the middle). As few anchors as
/// found are replaced; none if all are on the border. Cuts are straight, or fans of three rays if
/// no straight cut exists; for few anchors the division with the most compact parts is chosen.
/// Areas are exact to rounding. Cost: O(n² (v + n) v) for n anchors and v corners, up to some
/// hundred times that where anchors inside do not fit.
/// Preconditions: check_polygon passes; convex; as many anchors as shares; finite; shares > 0.
std::vector<world::Polygon> divide(const world::Polygon& area,
                                   const std::vector<world::Vector2>& anchors,
                                   const std::vector<double>& shares);

}  // namespace skein::refiners
