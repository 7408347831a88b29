// SPDX-License-Identifier: Apache-2.0
// Searches the game by brute force, remembering positions.
#include "stnu_game.hpp"

#include <algorithm>

namespace skein::temporal::testing {

StnuGame::StnuGame(const Stnu& network)
    : network_(network), controlled_(network.nodes.size(), true), arcs_(network.arcs) {
  for (const ContingentLink& link : network.contingent) {
    if (link.min == link.max) {
      arcs_.push_back({link.activation, link.contingent, link.min, link.max});
    } else {
      controlled_[link.contingent] = false;
      links_.push_back(link);
    }
  }
}

bool StnuGame::controller_wins() {
  Dates dates(network_.nodes.size(), kInfinite);
  dates[network_.origin] = 0;
  return after_nature(dates, 0);
}

/// Dates are those of the past and of this instant; whoever has none comes later.
bool StnuGame::acceptable(const Dates& dates, Ticks now) const {
  return std::all_of(arcs_.begin(), arcs_.end(), [&](const Arc& arc) {
    const Ticks from = dates[arc.from];
    const Ticks to = dates[arc.to];
    if (from == kInfinite && to == kInfinite) return true;
    if (from == kInfinite) return arc.min == kMinusInfinite || to - now - 1 >= arc.min;
    if (to == kInfinite) return arc.max == kInfinite || now + 1 - from <= arc.max;
    return to - from >= arc.min && to - from <= arc.max;
  });
}

bool StnuGame::before_nature(const Dates& dates, Ticks now) {
  const auto [place, fresh] = known_.try_emplace({now, dates}, false);
  if (!fresh) return place->second;
  const bool wins = nature_branches(dates, now, 0);
  known_[{now, dates}] = wins;
  return wins;
}

bool StnuGame::nature_branches(const Dates& dates, Ticks now, std::size_t link) {
  if (link == links_.size()) return after_nature(dates, now);
  const ContingentLink& task = links_[link];
  const Ticks begun = dates[task.activation];
  const bool running = begun != kInfinite && dates[task.contingent] == kInfinite;
  if (!running || now < begun + task.min) return nature_branches(dates, now, link + 1);
  if (now < begun + task.max && !nature_branches(dates, now, link + 1)) return false;
  Dates ended = dates;
  ended[task.contingent] = now;
  return nature_branches(ended, now, link + 1);
}

bool StnuGame::after_nature(const Dates& dates, Ticks now) {
  return controller_branches(dates, now, 0);
}

bool StnuGame::controller_branches(const Dates& dates, Ticks now, NodeIndex node) {
  if (node == dates.size()) {
    if (!acceptable(dates, now)) return false;
    if (std::find(dates.begin(), dates.end(), kInfinite) == dates.end()) return true;
    return before_nature(dates, now + 1);
  }
  if (controlled_[node] && dates[node] == kInfinite) {
    Dates executed = dates;
    executed[node] = now;
    if (controller_branches(executed, now, node + 1)) return true;
  }
  return controller_branches(dates, now, node + 1);
}

}  // namespace skein::temporal::testing
