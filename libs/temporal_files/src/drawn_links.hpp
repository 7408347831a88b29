// SPDX-License-Identifier: Apache-2.0
// Links of a network as both kinds of pictures show them.
#pragma once

#include <string>
#include <vector>

#include "skein/temporal_files/drawing.hpp"

namespace skein::temporal {

inline constexpr const char* kInk = "#22303c";
inline constexpr const char* kQuietInk = "#66757f";
inline constexpr const char* kRequirementInk = "#4a6375";
inline constexpr const char* kContingentInk = "#8a5a00";
inline constexpr const char* kConflictInk = "#c8102e";

/// A link of either kind.
struct DrawnLink {
  NodeIndex from = 0;
  NodeIndex to = 0;
  Ticks min = 0;
  Ticks max = 0;
  bool contingent = false;
  bool in_conflict = false;

  const char* colour() const;
  /// Whether `to` comes before `from`, certainly or probably.
  bool is_backwards() const;
};

struct DrawnNode {
  bool contingent = false;  ///< nature decides when it comes
  bool in_conflict = false;
};

std::vector<DrawnLink> drawn_links(const Stnu& network, const std::vector<LinkRef>& conflict);
std::vector<DrawnNode> drawn_nodes(const Stnu& network, const std::vector<DrawnLink>& links);

/// "2 … 7.5", or one date when both are the same.
std::string window_text(const DateWindow& window);

}  // namespace skein::temporal
