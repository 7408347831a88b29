// SPDX-License-Identifier: Apache-2.0
// The ground layer of a map: hill shading and contour lines.
#pragma once

#include <string>
#include <vector>

#include "skein/cartography/map.hpp"
#include "skein/drawing/pixels.hpp"
#include "svg_text.hpp"

namespace skein::cartography {

using drawing::Pixels;

/// Metres to pixels of the map, whose north-west corner is the origin.
class Scale {
 public:
  Scale(const Frame& frame, double most_width, double most_height);
  Spot operator()(const world::Vector2& at) const {
    return {(at.x() - frame_.west) * per_metre_, (frame_.north - at.y()) * per_metre_};
  }
  Spot operator()(const world::Vector3& at) const { return (*this)(world::Vector2(at.head<2>())); }
  double pixels(double metres) const { return metres * per_metre_; }
  double width() const { return (frame_.east - frame_.west) * per_metre_; }
  double height() const { return (frame_.north - frame_.south) * per_metre_; }
  const Frame& frame() const { return frame_; }

 private:
  Frame frame_;
  double per_metre_;
};

/// Lowest and highest ground of a frame [m].
struct Relief {
  double low = 0, high = 0;
};
Relief relief_of(const world::Terrain& terrain, const Frame& frame);

/// The ground tinted by height and lit from the north-west.
Pixels hill_shade(const world::Terrain& terrain, const Scale& scale, const Relief& relief);

/// Least height difference [m] for which contour lines are drawn.
inline constexpr double kLevelRelief = 2;
inline bool is_level(const Relief& relief) { return relief.high - relief.low < kLevelRelief; }
/// A round interval [m] for some ten contour lines between low and high.
double contour_interval(const Relief& relief);

/// Paths of the contour lines, every fifth of them stronger; none on level ground.
std::string contours(const world::Terrain& terrain, const Scale& scale, const Relief& relief);

}  // namespace skein::cartography
