// SPDX-License-Identifier: Apache-2.0
// A wide picture cut into strips, to be read one below the other like lines of text.
#pragma once

#include <vector>

#include "layered_layout.hpp"

namespace skein::temporal {

/// From x = begin to x = end of a layout.
struct Strip {
  double begin = 0;
  double end = 0;
  double width() const { return end - begin; }
};

/// Strips from left to right that together are the whole width. No node and no label is cut; none
/// is wider than `widest`, unless what must not be cut is. One strip when the layout is no wider.
std::vector<Strip> strips_of(const Layout& layout, double widest);

}  // namespace skein::temporal
