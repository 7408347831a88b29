// SPDX-License-Identifier: Apache-2.0
// What of the air one path query may use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Builds the airspace of one query, at any resolution. The query must be in order
/// (path_checks.hpp) and outlive it, as the world must.
class PathSpace {
 public:
  /// For a flight that takes no longer than `flight`: of the volumes with a time window only those
  /// that the vehicle can meet, however fast it comes and however late it leaves.
  PathSpace(const PathQuery& query, const world::World& world, Duration flight);

  /// Nothing when the time is up before; what takes less than some milliseconds is always made.
  std::optional<world::Airspace> airspace(const world::AirspaceGrid& grid,
                                          const Budget& budget) const;
  /// Which of the world's volumes and the reserved ones count, in this order.
  const std::vector<bool>& counted() const { return counted_; }
  /// True when the ground and the volumes themselves, not the voxels they touch, leave the segment
  /// free: 3 × margin over the ground at least, which keeps as much from slopes of up to 70°. Never
  /// where radio contact is asked for.
  bool is_free(const world::Vector3& from, const world::Vector3& to) const;
  /// Why the place of that field is closed.
  Refusal closed(const world::Vector3& place, const std::string& field) const;
  /// Without the radio contact asked for.
  PathSpace without_contact() const;

  /// How far from a blocked voxel's contents the vehicle stays on all sides [m]: its body, and what
  /// the chords of its turns leave out.
  double margin() const;

 private:
  bool can_be_met(const world::Volume& volume, Duration flight) const;
  bool within_limits(const world::Vector3& at) const;
  std::optional<std::string> blame(const world::Vector3& place) const;

  const PathQuery& query_;
  const world::World& world_;
  std::vector<world::Volume> volumes_;  // that count
  std::vector<std::string> volume_names_;
  std::vector<world::Vector3> anchors_;  // empty: no contact asked for
  std::vector<bool> counted_;
};

/// Of the chords of the arcs that a vehicle which cannot hover flies [m].
inline constexpr double kChordTolerance = 0.5;

}  // namespace skein::refiners
