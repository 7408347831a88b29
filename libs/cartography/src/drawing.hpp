// SPDX-License-Identifier: Apache-2.0
// What a Map is made of.
#pragma once

#include <string>
#include <vector>

#include "ground_layer.hpp"
#include "labels.hpp"
#include "skein/cartography/map.hpp"

namespace skein::cartography {

/// Of the map on the picture [px].
inline constexpr double kMapWidth = 860, kMapHeight = 660, kMargin = 18;

struct LegendLine {
  std::string colour, words;
};

class Map::Drawing {
 public:
  Drawing(const world::World& shown, const Frame& frame)
      : world(shown),
        scale(frame, kMapWidth, kMapHeight),
        relief(relief_of(shown.terrain, frame)) {}

  const world::World& world;
  Scale scale;
  Relief relief;
  std::string layers;  ///< SVG, in the pixels of the map
  std::vector<Label> labels;
  std::vector<LegendLine> legend;
  std::vector<HeatScale> heats;
  std::vector<world::Volume> closed;
  std::vector<std::string> profiles;  ///< each a picture of kProfileHeight
};

/// Of one profile on the picture, with its axis [px].
inline constexpr double kProfileHeight = 150;

/// 1, 2 or 5 times a power of ten: the least of which at most so many steps make up a span.
double tick_step(double span, double ticks);

/// Heights along a way, as a group of that height and as wide as the map.
std::string profile_of(const Map::Drawing& drawing, const refiners::Way& way,
                       const std::string& colour);

}  // namespace skein::cartography
