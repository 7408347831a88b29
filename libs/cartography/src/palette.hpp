// SPDX-License-Identifier: Apache-2.0
// Colours of maps: of the ground, of quantities, of UAVs.
#pragma once

#include <string>

#include "skein/drawing/pixels.hpp"

namespace skein::cartography {

using drawing::Colour;

/// Tint of the ground, from the lowest (0) to the highest (1) of the map, lit by `light`: 0 in the
/// shade, 0.7 on level ground, 1 facing the sun.
Colour ground_tint(double height, double light);

/// From dark blue (0) over green to yellow (1). Lightness increases with the value, so that it is
/// readable in grey and for the colour-blind.
Colour heat_tint(double value);

/// "#rrggbb"; eight distinct colours, repeated from index 8 on. Source of the colours: Okabe and
/// Ito, "Color universal design", 2008.
std::string line_colour(std::size_t index);

std::string hex(Colour colour);

}  // namespace skein::cartography
