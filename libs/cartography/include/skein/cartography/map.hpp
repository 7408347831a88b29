// SPDX-License-Identifier: Apache-2.0
// A map as one self-contained SVG: hill-shaded ground, zones, ways, swaths, quantities.
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

/// Collects points, then gives a frame with some room around them, the whole terrain where it is
/// not much larger, and neither narrower than 100 m nor flatter than 1:3.
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
  double low = 0, high = 1;  ///< what the ends of the colours mean
  double opacity = 0.75;     ///< over the hill shading
};

/// Layers are drawn in the order of the calls; labels last, kept apart from each other. All figures
/// must be finite, those of the world as its readers leave them. Deterministic: the same calls give
/// the same text.
class Map {
 public:
  /// The hill-shaded ground with contour lines is there from the beginning. The world must outlive
  /// the map.
  Map(const world::World& world, const Frame& frame);
  Map(const Map&) = delete;
  Map& operator=(const Map&) = delete;
  ~Map();

  /// One value per cell of the grid; NaN: nothing is drawn there.
  void heat(const world::Grid& grid, const std::vector<double>& values, const HeatScale& scale);
  void area(const world::Polygon& polygon, const AreaStyle& style);
  /// Hatched in red, with name, levels and times.
  void closed(const std::vector<world::Volume>& volumes);
  /// A strip as wide as the swath [m], translucent.
  void strip(const world::Vector2& from, const world::Vector2& to, double swath,
             const std::string& colour);
  /// With arrows in the sense it is flown.
  void way(const refiners::Way& way, const std::string& colour, double width = 2);
  /// What a sensor sees: from a place towards another, `aperture` half angle [rad].
  void cone(const world::Vector3& from, const world::Vector3& to, double aperture,
            const std::string& colour);
  void link(const world::Vector3& a, const world::Vector3& b, const std::string& colour,
            const std::string& label);
  /// A named dot.
  void marker(const world::Vector2& at, const std::string& colour, const std::string& label);
  /// Below the map: the heights flown and the ground under them, with volumes met.
  void profile(const refiners::Way& way, const std::string& colour);
  /// A line of the legend, in the colour of what it explains.
  void legend(const std::string& colour, const std::string& text);

  /// The whole picture. Lines under the title may be empty.
  std::string finish(const std::string& title, const std::vector<std::string>& lines) const;

  class Drawing;

 private:
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace skein::cartography
