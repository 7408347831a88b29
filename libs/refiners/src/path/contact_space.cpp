// SPDX-License-Identifier: Apache-2.0
#include "path/contact_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/deadline.hpp"
#include "skein/world/horizon.hpp"

namespace skein::refiners {
namespace {

using world::Airspace;
using world::AirspaceGrid;
using world::Vector2;
using world::Vector3;

constexpr double kNowhere = std::numeric_limits<double>::infinity();
/// About what a horizon takes, a corner of the ground that is looked at, and a column of voxels
/// that is beyond reach [ns].
constexpr std::uint32_t kHorizon = 10'000, kCorner = 100, kFar = 20;

double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The lines between which the ground is bilinear, its borders among them.
std::vector<double> lines_of(double low, double high, double cell) {
  std::vector<double> lines;
  for (double i = 0; low + i * cell < high; ++i) lines.push_back(low + i * cell);
  lines.push_back(high);
  return lines;
}

/// For one anchor: from which height on the whole of a column of voxels sees it. The sights from an
/// anchor to the points of a level rectangle that come lowest over any place end on its border; and
/// over the triangle from the anchor to one edge, the ground less the plane is bilinear in each
/// cell, so greatest on the triangle's sides or at corners of cells within it.
class SightLevels {
 public:
  /// Not whole once the deadline has passed. It must outlive the constructor only.
  SightLevels(const AirspaceGrid& grid, const world::World& world, const Vector3& anchor,
              Deadline& deadline)
      : grid_(grid),
        terrain_(world.terrain),
        anchor_(anchor),
        reach_(world.radio.reach()),
        deadline_(&deadline) {
    const world::Terrain& terrain = world.terrain;
    const world::TerrainSpec& spec = terrain.spec();
    xs_ = lines_of(spec.west, spec.east, spec.cell);
    ys_ = lines_of(spec.south, spec.north, spec.cell);
    trace_corners();
    trace_columns();
  }

  /// [m, ENU z]; infinite beyond reach.
  double of(const world::Voxel& voxel) const {
    return levels_[static_cast<std::size_t>(voxel[1]) * static_cast<std::size_t>(grid_.size[0]) +
                   static_cast<std::size_t>(voxel[0])];
  }

 private:
  Vector2 corner(std::int32_t x, std::int32_t y) const {
    return grid_.origin.head<2>() + grid_.voxel * Vector2(x, y);
  }
  double corner_level(std::int32_t x, std::int32_t y) const {
    return corners_[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.size[0] + 1) +
                    static_cast<std::size_t>(x)];
  }

  void trace_corners() {
    corners_.reserve((static_cast<std::size_t>(grid_.size[0]) + 1) *
                     (static_cast<std::size_t>(grid_.size[1]) + 1));
    for (std::int32_t y = 0; y <= grid_.size[1]; ++y)
      for (std::int32_t x = 0; x <= grid_.size[0]; ++x) {
        const Vector2 at = corner(x, y);
        const bool is_far = (at - anchor_.head<2>()).norm() > reach_;
        if (deadline_->passed_after(is_far ? kFar : kHorizon)) return;
        corners_.push_back(is_far ? kNowhere : level_over(at));
      }
  }

  /// From which height on one place within reach sees the anchor.
  double level_over(const Vector2& place) const {
    const Vector2 offset = place - anchor_.head<2>();
    const double distance = offset.norm();
    if (distance == 0) return -kNowhere;
    const world::HorizonProfile profile(terrain_, anchor_, std::atan2(offset.y(), offset.x()),
                                        distance);
    return anchor_.z() + profile.slope_until(distance) * distance;
  }

  void trace_columns() {
    levels_.reserve(static_cast<std::size_t>(grid_.size[0]) *
                    static_cast<std::size_t>(grid_.size[1]));
    for (std::int32_t y = 0; y < grid_.size[1]; ++y)
      for (std::int32_t x = 0; x < grid_.size[0]; ++x) {
        if (deadline_->passed_after(kFar)) return;
        levels_.push_back(level_of_column(x, y));
      }
  }

  double level_of_column(std::int32_t x, std::int32_t y) const {
    double level = std::max({corner_level(x, y), corner_level(x + 1, y), corner_level(x, y + 1),
                             corner_level(x + 1, y + 1)});
    if (level == kNowhere) return level;
    const Vector2 south_west = corner(x, y), south_east = corner(x + 1, y);
    const Vector2 north_west = corner(x, y + 1), north_east = corner(x + 1, y + 1);
    level = std::max(level, level_over(south_west, south_east));
    level = std::max(level, level_over(south_east, north_east));
    level = std::max(level, level_over(north_east, north_west));
    return std::max(level, level_over(north_west, south_west));
  }

  /// From which height on an edge sees over the corners of cells in the triangle to the anchor.
  double level_over(const Vector2& a, const Vector2& b) const {
    const Vector2 eye = anchor_.head<2>();
    const double area = cross(a - eye, b - eye);
    double level = -kNowhere;
    if (area == 0) return level;
    const double low = std::min({a.y(), b.y(), eye.y()}), high = std::max({a.y(), b.y(), eye.y()});
    for (auto y = std::lower_bound(ys_.begin(), ys_.end(), low); y != ys_.end() && *y <= high;
         ++y) {
      const auto [west, east] = across({eye, a, b}, *y);
      for (auto x = std::lower_bound(xs_.begin(), xs_.end(), west); x != xs_.end() && *x <= east;
           ++x) {
        if (deadline_->passed_after(kCorner)) return level;
        const Vector2 offset = Vector2(*x, *y) - eye;
        // What part of the way from the anchor to the edge lies before it.
        const double part = cross(offset, b - a) / cross(a - eye, b - a);
        if (part <= 0) continue;
        const double rise = terrain_.elevation(*x, *y) - anchor_.z();
        level = std::max(level, anchor_.z() + rise / part);
      }
    }
    return level;
  }

  /// The part of a level line that lies in a triangle.
  static std::pair<double, double> across(const std::array<Vector2, 3>& triangle, double y) {
    std::pair<double, double> span = {kNowhere, -kNowhere};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector2 &a = triangle[i], &b = triangle[(i + 1) % 3];
      if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y) continue;
      const double from =
          a.y() == b.y() ? a.x() : a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y());
      const double until = a.y() == b.y() ? b.x() : from;
      span = {std::min({span.first, from, until}), std::max({span.second, from, until})};
    }
    return span;
  }

  const AirspaceGrid& grid_;
  const world::Terrain& terrain_;
  Vector3 anchor_;
  double reach_;
  Deadline* deadline_;
  std::vector<double> xs_, ys_, corners_, levels_;
};

/// From a point to the farthest point of a voxel [m].
double farthest(const Airspace& airspace, const world::Voxel& voxel, const Vector3& from) {
  const Vector3 offset = (airspace.centre(voxel) - from).cwiseAbs();
  return (offset + Vector3::Constant(airspace.grid().voxel / 2)).norm();
}

}  // namespace

std::vector<Vector3> anchors_of(const Contact& contact, const world::World& world) {
  std::vector<Vector3> anchors = {contact.with}, waiting = contact.relays;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const auto linked = [&](const Vector3& relay) {
      return world.radio.link(relay, anchors[i], world.terrain, false).up;
    };
    const auto rest = std::stable_partition(waiting.begin(), waiting.end(), linked);
    std::vector<Vector3> joined(waiting.begin(), rest);
    waiting.erase(waiting.begin(), rest);
    anchors.insert(anchors.end(), joined.begin(), joined.end());
  }
  return anchors;
}

bool keep_contact(Airspace& airspace, const std::vector<Vector3>& anchors,
                  const world::World& world, const Budget& budget) {
  Deadline deadline(budget);
  const double reach = world.radio.reach();
  std::vector<SightLevels> levels;
  if (world.radio.needs_line_of_sight)
    for (const Vector3& anchor : anchors)
      levels.emplace_back(airspace.grid(), world, anchor, deadline);
  if (deadline.is_over()) return false;
  const auto is_heard = [&](const world::Voxel& voxel) {
    const double bottom = airspace.grid().origin.z() + voxel[2] * airspace.grid().voxel;
    for (std::size_t i = 0; i < anchors.size(); ++i)
      if (farthest(airspace, voxel, anchors[i]) <= reach &&
          (levels.empty() || bottom >= levels[i].of(voxel)))
        return true;
    return false;
  };
  return airspace.keep_where(is_heard, budget.time_is_up);
}

}  // namespace skein::refiners
