// SPDX-License-Identifier: Apache-2.0
// Names on a map, kept apart from each other.
#pragma once

#include <string>
#include <vector>

#include "svg_text.hpp"

namespace skein::cartography {

struct Label {
  Spot at;
  std::string words;
  const char* colour = "#202020";
  bool beside = true;  ///< of a dot, which it must not cover; else on the spot
};

/// Places each label where it covers the least of those before, to the right if all is free, within
/// a picture of that size [px]. Same labels, same places.
std::string placed(const std::vector<Label>& labels, double width, double height);

}  // namespace skein::cartography
