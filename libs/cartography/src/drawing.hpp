// SPDX-License-Identifier: Apache-2.0
// Content of a Map.
#pragma once

#include <string>
#include <vector>

#include "ground_layer.hpp"
#include "labels.hpp"
#include "skein/cartography/map.hpp"

namespace skein::cartography {

/// Size and margin of the map on the picture [px].
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

/// Height of one profile on the picture, including its axis [px].
inline constexpr double kProfileHeight = 150;

/// The least step of 1, 2 or 5 times a power of ten that divides a span into at most `ticks` steps.
double tick_step(double span, double ticks);

/// The height profile of a path, as an SVG group of kProfileHeight and the width of the map.
std::string profile_of(const Map::Drawing& drawing, const refiners::Way& way,
                       const std::string& colour);

}  // namespace skein::cartography
