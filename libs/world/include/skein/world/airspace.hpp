// SPDX-License-Identifier: Apache-2.0
// The airspace as voxels: free or blocked, with crossing costs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "skein/world/terrain.hpp"
#include "skein/world/volume.hpp"

namespace skein::world {

/// The shape of the voxels. Voxel (0, 0, 0) is the lowest in the south-west.
struct AirspaceGrid {
  Vector3 origin = Vector3::Zero();           ///< lowest corner [m], ENU
  double voxel = 10;                          ///< side of the cubes [m], > 0
  std::array<std::int32_t, 3> size{1, 1, 1};  ///< along east, north, up; each >= 1
  bool operator==(const AirspaceGrid&) const = default;

  std::size_t count() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]);
  }
  std::size_t index(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(x);
  }
};

/// Most voxels an airspace may have (512 MB of crossing costs), and most along one axis, so that a
/// wrong figure in a file cannot exhaust memory.
inline constexpr std::size_t kMostVoxels = std::size_t{1} << 29U;
inline constexpr std::int32_t kMostVoxelsAlong = 1 << 20;

/// The problems of this shape, in sentences; empty if an airspace can have it.
std::vector<std::string> problems_of(const AirspaceGrid& grid);

/// The specification of an airspace over a terrain.
struct AirspaceSpec {
  AirspaceGrid grid;
  double clearance = 0;    ///< least height of free air over the ground [m], >= 0
  double body_radius = 0;  ///< ground and volumes are grown by as much all around [m], >= 0
  /// Greatest height of the top of a voxel over the lowest ground below it [m].
  double ceiling = std::numeric_limits<double>::infinity();
  TimeWindow when;  ///< only volumes whose time window overlaps this one block voxels
};

/// Where a voxel stands in the grid: along east, north, up.
using Voxel = std::array<std::int32_t, 3>;

/// The voxel of a point, the upper one for a point on a face, but the last one on the border of the
/// grid; nothing outside the grid.
std::optional<Voxel> voxel_at(const AirspaceGrid& grid, const Vector3& point);

class WorkClock;

/// A voxel is free when the whole of it is: at least `clearance` over the highest ground below it
/// (exact for the bilinear surface of Terrain), and not touched by any volume. So no point in or on
/// a free voxel is in the ground or in a volume. Outside the grid nothing is free. One byte a
/// voxel. A value type; reading is const and safe from any thread.
/// Source: spec 4.1 (airspace), T IV.2.2.
class Airspace {
 public:
  /// Crossing costs are multiples of 1/16 from 1 to 15.9375; given costs are rounded to them.
  static constexpr double kCostStep = 1.0 / 16;
  static constexpr std::uint8_t kBlocked = 0;
  static constexpr std::uint8_t kPlain = 16;  ///< crossing cost 1
  /// Points that close to a face count as on it [voxels].
  static constexpr double kSnap = 1e-7;

  /// All free, at crossing cost 1. Precondition: problems_of(grid) is empty.
  explicit Airspace(const AirspaceGrid& grid);
  /// One byte a voxel, in the order of AirspaceGrid::index: 0 is blocked, else 16 × crossing cost,
  /// at least 16. Precondition: as many as the grid has, none from 1 to 15.
  Airspace(const AirspaceGrid& grid, std::vector<std::uint8_t> voxels);
  /// Over a terrain, without the volumes that do not hold in `spec.when`.
  /// Cost: O(columns + nodes of the terrain below + voxels).
  Airspace(const AirspaceSpec& spec, const Terrain& terrain, const std::vector<Volume>& volumes);
  /// The same with a time limit; nothing if the time is up before it is complete. The clock is
  /// asked about every 4 ms of work, so that shorter work is always completed. Empty: no limit.
  static std::optional<Airspace> in_time(const AirspaceSpec& spec, const Terrain& terrain,
                                         const std::vector<Volume>& volumes,
                                         const std::function<bool()>& time_is_up);
  /// A copy; nothing if the time is up before it is complete, as for in_time().
  std::optional<Airspace> copied(const std::function<bool()>& time_is_up) const;

  const AirspaceGrid& grid() const { return grid_; }
  const std::vector<std::uint8_t>& voxels() const { return voxels_; }
  bool is_free(std::int32_t x, std::int32_t y, std::int32_t z) const;
  bool is_free(const Voxel& voxel) const { return is_free(voxel[0], voxel[1], voxel[2]); }
  Vector3 centre(const Voxel& voxel) const;
  /// As world::voxel_at() for this grid.
  std::optional<Voxel> voxel_at(const Vector3& point) const {
    return world::voxel_at(grid_, point);
  }
  /// The first free voxel that contains the point, borders (faces, edges, corners) included.
  std::optional<Voxel> free_voxel_at(const Vector3& point) const;
  /// True in free voxels and on their faces.
  bool is_free(const Vector3& point) const { return free_voxel_at(point).has_value(); }

  /// True when the straight segment stays in free voxels and on their faces. It goes through no
  /// blocked voxel, nor between two that touch: where it crosses an edge or a corner of voxels, all
  /// those it might be said to pass there must be free. Where it runs along faces, the voxels of
  /// one same side must be free all along. It may begin and end on any face of a free voxel. Cost:
  /// O(voxels crossed).
  bool is_free(const Vector3& from, const Vector3& to) const;
  /// Integral of the crossing cost along the segment [m × cost], along faces on the cheaper side;
  /// nothing when it is not free. Cost: as is_free.
  std::optional<double> cost(const Vector3& from, const Vector3& to) const;

  /// Bounds of the crossing costs of the free voxels, in sixteenths.
  std::uint8_t least_cost() const { return least_cost_; }
  std::uint8_t greatest_cost() const { return greatest_cost_; }

  /// Blocks the voxels that a volume, grown by `margin` [m] all around, touches. Ignores its time
  /// window. False if the time was up before all were blocked, as for in_time().
  /// Precondition: finite corners.
  bool block(const Volume& volume, double margin = 0, const std::function<bool()>& time_is_up = {});
  /// Blocks the free voxels for which `keep` is false. False if the time was up before all were
  /// tested, as for in_time(). Cost: one call per free voxel.
  bool keep_where(const std::function<bool(const Voxel&)>& keep,
                  const std::function<bool()>& time_is_up = {});
  /// Sets the crossing cost, held within [1, 15.9375], of the free voxels that a volume touches.
  void set_cost(const Volume& volume, double crossing_cost);

 private:
  /// Over the ground within `margin` of a footprint; all in [m].
  struct Heights {
    double clearance, ceiling, margin;
  };

  /// With those voxels, or all free; fewer than the grid has when the clock is up before.
  Airspace(const AirspaceGrid& grid, const std::uint8_t* voxels, WorkClock& clock);
  bool stand_on(const Terrain& terrain, const Heights& heights, WorkClock& clock);

  AirspaceGrid grid_;
  std::vector<std::uint8_t> voxels_;
  std::uint8_t least_cost_ = kPlain, greatest_cost_ = kPlain;
};

}  // namespace skein::world
