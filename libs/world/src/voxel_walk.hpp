// SPDX-License-Identifier: Apache-2.0
// Walks a straight segment through the voxels of a grid.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "skein/world/airspace.hpp"

namespace skein::world {

/// One axis of a walk, in voxels.
class WalkAxis {
 public:
  WalkAxis() = default;
  WalkAxis(double from, double to) : from_(snapped(from)), step_(snapped(to) - from_) {
    if (std::abs(step_) <= Airspace::kSnap) {
      stand_still();
    } else if (step_ > 0) {
      first_ = static_cast<std::int32_t>(std::floor(from_));
      last_ = static_cast<std::int32_t>(std::ceil(from_ + step_)) - 1;
    } else {
      first_ = static_cast<std::int32_t>(std::ceil(from_)) - 1;
      last_ = static_cast<std::int32_t>(std::floor(from_ + step_));
    }
    if (step_ != 0) per_voxel_ = 1 / step_;
  }

  /// True when the segment runs in a face: the voxels of either side are then first() and
  /// first() - 1.
  bool in_face() const { return in_face_; }
  std::int32_t first() const { return first_; }
  std::int32_t last() const { return last_; }
  int direction() const { return step_ > 0 ? 1 : -1; }
  /// The fraction of the segment that lies before the far side of a voxel.
  double leaves(std::int32_t voxel) const {
    if (voxel == last_) return std::numeric_limits<double>::infinity();
    return (static_cast<double>(voxel + (step_ > 0 ? 1 : 0)) - from_) * per_voxel_;
  }
  /// Length along the axis [voxels], for the tolerance of fractions.
  double extent() const { return std::abs(step_); }
  void take_side(std::int32_t voxel) { first_ = last_ = voxel; }

 private:
  static double snapped(double x) {
    const double nearest = std::round(x);
    return std::abs(x - nearest) <= Airspace::kSnap ? nearest : x;
  }
  void stand_still() {
    const double end = from_ + step_;
    const double face = from_ == std::floor(from_) ? from_ : end;
    in_face_ = face == std::floor(face);
    first_ = last_ = static_cast<std::int32_t>(std::floor(in_face_ ? face : from_));
    step_ = 0;
  }

  double from_ = 0, step_ = 0, per_voxel_ = 0;
  std::int32_t first_ = 0, last_ = 0;
  bool in_face_ = false;
};

/// A segment in a grid; see Airspace::is_free for what it passes.
class VoxelWalk {
 public:
  VoxelWalk(const AirspaceGrid& grid, const Vector3& from, const Vector3& to) : grid_(grid) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double a = (from[k] - grid.origin[k]) / grid.voxel;
      const double b = (to[k] - grid.origin[k]) / grid.voxel;
      inside_ = inside_ && near_grid(a, grid.size[i]) && near_grid(b, grid.size[i]);
      if (inside_) axes_[i] = WalkAxis(a, b);
    }
  }

  /// The choices of a side, for segments that run in faces or along edges: 1, 2, 4 or 8.
  unsigned sides() const {
    unsigned count = inside_ ? 1 : 0;
    for (const WalkAxis& axis : axes_) count *= axis.in_face() ? 2 : 1;
    return count;
  }

  /// Calls `pass(index, from, until)` with the index of each voxel passed and the fractions of the
  /// way in it, in order; equal fractions for those touched at an edge or a corner. Stops when
  /// `pass` says false, and at once when it leaves the grid. True when it went to the end.
  template <class Pass>
  bool along(unsigned side, const Pass& pass) const {
    std::array<WalkAxis, 3> axes = axes_;
    for (WalkAxis& axis : axes)
      if (axis.in_face()) {
        axis.take_side(axis.first() - static_cast<std::int32_t>(side & 1U));
        side >>= 1U;
      }
    if (!within(axes)) return false;
    return walk(axes, pass);
  }

 private:
  /// False for NaN too; so what follows can be converted to an index.
  static bool near_grid(double x, std::int32_t size) {
    return x > -1 && x < static_cast<double>(size) + 1;
  }
  bool within(const std::array<WalkAxis, 3>& axes) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::min(axes[i].first(), axes[i].last()) < 0 ||
          std::max(axes[i].first(), axes[i].last()) >= grid_.size[i])
        return false;
    return true;
  }

  template <class Pass>
  bool walk(const std::array<WalkAxis, 3>& axes, const Pass& pass) const {
    const auto row = static_cast<std::int64_t>(grid_.size[0]);
    const std::array<std::int64_t, 3> strides = {1, row, row * grid_.size[1]};
    Voxel at{};
    std::array<double, 3> leaves{};
    std::array<std::int64_t, 3> steps{};
    std::int64_t index = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = axes[i].first();
      leaves[i] = axes[i].leaves(at[i]);
      steps[i] = strides[i] * axes[i].direction();
      index += strides[i] * at[i];
    }
    for (double from = 0;;) {
      const double until = std::min({leaves[0], leaves[1], leaves[2]});
      if (!pass(static_cast<std::size_t>(index), from, std::min(until, 1.0))) return false;
      if (until > 1) return true;
      from = until;
      const unsigned crossed = crossed_at(axes, leaves, until);
      if ((crossed & (crossed - 1)) != 0 && !touch(index, steps, crossed, until, pass))
        return false;
      for (std::size_t i = 0; i < 3; ++i)
        if ((crossed >> i & 1U) != 0) {
          index += steps[i];
          at[i] += axes[i].direction();
          leaves[i] = axes[i].leaves(at[i]);
        }
    }
  }

  /// The axes whose next face is crossed there, as bits: more than one at an edge or a corner.
  static unsigned crossed_at(const std::array<WalkAxis, 3>& axes,
                             const std::array<double, 3>& leaves, double until) {
    unsigned crossed = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (leaves[i] == until || (leaves[i] - until) * axes[i].extent() <= Airspace::kSnap)
        crossed |= 1U << i;
    return crossed;
  }

  /// The voxels around an edge or a corner other than the one left and the one entered.
  template <class Pass>
  static bool touch(std::int64_t index, const std::array<std::int64_t, 3>& steps, unsigned crossed,
                    double at, const Pass& pass) {
    for (unsigned some = (crossed - 1) & crossed; some != 0; some = (some - 1) & crossed) {
      std::int64_t beside = index;
      for (std::size_t i = 0; i < 3; ++i)
        if ((some >> i & 1U) != 0) beside += steps[i];
      if (!pass(static_cast<std::size_t>(beside), at, at)) return false;
    }
    return true;
  }

  AirspaceGrid grid_;
  std::array<WalkAxis, 3> axes_{};
  bool inside_ = true;
};

}  // namespace skein::world
