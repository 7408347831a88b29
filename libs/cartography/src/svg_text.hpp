// SPDX-License-Identifier: Apache-2.0
// Pieces of SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skein/world/geometry.hpp"

namespace skein::cartography {

/// A point of the picture [px], y downwards.
struct Spot {
  double x = 0, y = 0;
};

/// A length [px] with one decimal.
std::string px(double value);
/// "x,y x,y …", for points="".
std::string points(const std::vector<Spot>& spots);

struct TextStyle {
  double size = 11;
  const char* anchor = "start";
  const char* colour = "#202020";
  bool bold = false;
  bool halo = false;  ///< a white border, on maps
};
std::string text(const Spot& at, std::string_view words, const TextStyle& style);
/// Estimated width of a text [px].
double width_of(std::string_view words, double size);

}  // namespace skein::cartography
