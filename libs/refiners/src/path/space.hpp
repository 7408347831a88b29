// SPDX-License-Identifier: Apache-2.0
// Free airspace of one path query.
#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <vector>

#include "skein/refiners/path.hpp"
#include "skein/world/airspace.hpp"

namespace skein::refiners {

/// Builds the airspace of one query, at any resolution. Precondition: the query is valid
/// (path_checks.hpp). Query and world must outlive this object.
class PathSpace {
 public:
  using Outline = Eigen::AlignedBox2d;  ///< in the plane [m]

  /// For a flight of at most `flight`: volumes with a time window count only if it overlaps that
  /// time.
  PathSpace(const PathQuery& query, const world::World& world, Duration flight);

  /// Nothing if the time is up before; an airspace that takes less than some milliseconds is always
  /// built.
  std::optional<world::Airspace> airspace(const world::AirspaceGrid& grid,
                                          const Budget& budget) const;
  /// Whether each volume counts: those of the world, then the reserved ones.
  const std::vector<bool>& counted() const { return counted_; }
  /// Whether the segment is free of the ground and the volumes themselves, instead of the voxels
  /// they touch: at least 3 × margin over the ground, which keeps the margin from slopes of up to
  /// 70°. Always false if radio contact is required.
  bool is_free(const world::Vector3& from, const world::Vector3& to) const;
  /// The reason why a place is closed; `field` names it in the query.
  Refusal closed(const world::Vector3& place, const std::string& field) const;
  /// The same space without the requirement of radio contact.
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
  std::vector<Outline> outlines_;       // of these, grown by the margin
  std::vector<std::string> volume_names_;
  std::vector<world::Vector3> anchors_;  // empty: no contact asked for
  std::vector<bool> counted_;
};

/// Of the chords of the arcs that a vehicle which cannot hover flies [m].
inline constexpr double kChordTolerance = 0.5;

}  // namespace skein::refiners
