// SPDX-License-Identifier: Apache-2.0
// A map as one self-contained SVG: hill-shaded ground, zones, paths, swaths, quantities.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/refiners/flight.hpp"
#include "skein/world/world.hpp"

namespace skein::cartography {

/// The ground that a map shows [m], ENU.
struct Frame {
  double west = 0, south = 0, east = 0, north = 0;
};

/// Computes the frame of a map from the points it has to show: with some room around them, or the
/// whole terrain if that is not much larger; at least 100 m wide, and not flatter than 1:3.
class FrameBuilder {
 public:
  void add(const world::Vector2& point);
  void add(const world::Vector3& point) { add(world::Vector2(point.head<2>())); }
  template <class Points>
  void add_all(const Points& points) {
    for (const auto& point : points) add(point);
  }
  Frame frame(const world::Terrain& terrain) const;

 private:
  bool empty_ = true;
  Frame box_;
};

struct AreaStyle {
  std::string colour = "#404040";
  double opacity = 0;  ///< of the inside, [0, 1]
  bool dashed = false;
  std::string label = {};  ///< inside; may be empty
};

struct HeatScale {
  std::string title;
  double low = 0, high = 1;  ///< values at the ends of the colour scale
  double opacity = 0.75;     ///< over the hill shading
};

/// Layers are drawn in the order of the calls; labels last, without overlaps. Precondition: all
/// figures are finite. Deterministic: the same calls give the same text.
class Map {
 public:
  /// Draws the hill-shaded ground with contour lines. The world must outlive the map.
  Map(const world::World& world, const Frame& frame);
  Map(const Map&) = delete;
  Map& operator=(const Map&) = delete;
  ~Map();

  /// One value per cell of the grid; NaN: nothing is drawn there.
  void heat(const world::Grid& grid, const std::vector<double>& values, const HeatScale& scale);
  void area(const world::Polygon& polygon, const AreaStyle& style);
  /// Closed volumes: hatched in red, with name, levels and times.
  void closed(const std::vector<world::Volume>& volumes);
  /// A strip as wide as the swath [m], translucent.
  void strip(const world::Vector2& from, const world::Vector2& to, double swath,
             const std::string& colour);
  /// A path, with arrows in the direction of flight.
  void way(const refiners::Way& way, const std::string& colour, double width = 2);
  /// The field of view of a sensor at `from` that looks towards `to`; `aperture`: half angle [rad].
  void cone(const world::Vector3& from, const world::Vector3& to, double aperture,
            const std::string& colour);
  void link(const world::Vector3& a, const world::Vector3& b, const std::string& colour,
            const std::string& label);
  /// A named dot.
  void marker(const world::Vector2& at, const std::string& colour, const std::string& label);
  /// Adds a profile below the map: heights of the path and of the ground, and volumes crossed.
  void profile(const refiners::Way& way, const std::string& colour);
  /// A line of the legend for a colour.
  void legend(const std::string& colour, const std::string& text);

  /// The whole picture. Lines under the title may be empty.
  std::string finish(const std::string& title, const std::vector<std::string>& lines) const;

  class Drawing;

 private:
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace skein::cartography
