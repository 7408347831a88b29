// SPDX-License-Identifier: Apache-2.0
// Placement of labels on a map without overlaps.
#pragma once

#include <string>
#include <vector>

#include "svg_text.hpp"

namespace skein::cartography {

struct Label {
  Spot at;
  std::string words;
  const char* colour = "#202020";
  bool beside = true;  ///< beside a dot, which the label must not cover; else centred on the place
};

/// The labels as SVG. Each is placed where it covers the least of those before, to the right if all
/// is free, within a picture of that size [px]. Deterministic.
std::string placed(const std::vector<Label>& labels, double width, double height);

}  // namespace skein::cartography
