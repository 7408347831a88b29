// SPDX-License-Identifier: Apache-2.0
// Pictures of a network: bounds as labels, contingent links dashed, the conflict in red.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/foundation/result.hpp"
#include "skein/temporal/date_window.hpp"
#include "skein/temporal/network.hpp"
#include "skein/temporal/stnu_fault.hpp"

namespace skein::temporal {

struct DrawingOptions {
  std::string title;
  std::vector<DateWindow> windows;  ///< of each node, shown under its name; empty: not shown
  std::vector<LinkRef> conflict;    ///< in red, with the nodes they join
};

/// A picture with more nodes than this is larger than a page.
inline constexpr std::size_t kLegibleNodes = 60;
inline constexpr std::size_t kMostDrawnNodes = 1000;

/// The failure of draw_svg() if it follows from the size alone; absent: the layout has to be tried.
/// O(1).
std::optional<Failure> too_large_to_draw(const Stnu& network);

/// Text for Graphviz, of any size. Preconditions: the indices are positions; there are as many
/// windows as nodes, or none.
std::string draw_dot(const Stnu& network, const DrawingOptions& options);

/// A self-contained picture: time goes from left to right, each node right of what it must follow.
/// One that is wider than 1,600 pixels is folded: cut into strips that stand below each other, no
/// node and no label being cut.
/// Fails above kMostDrawnNodes nodes, or when there are too many long links to be told apart.
/// Preconditions as draw_dot(). Cost: about O(links × layers).
Result<std::string, Failure> draw_svg(const Stnu& network, const DrawingOptions& options);

/// "[1.5, 3]", "≥ 1.5", "≤ 3", "= 3" or "free": bounds as they are shown.
std::string bounds_text(Ticks min, Ticks max);

}  // namespace skein::temporal
