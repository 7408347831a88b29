// SPDX-License-Identifier: Apache-2.0
// Follows flights along which devices perceive: the way-points reached, and when zones are in view.
#pragma once

#include <optional>

#include "book/book.hpp"
#include "watch/beliefs.hpp"

namespace skein::supervisor {

/// Lifetime: refers to the beliefs and the book.
class WayWatch {
 public:
  WayWatch(const Beliefs& beliefs, Book& book) : beliefs_(beliefs), book_(book) {}

  /// A vehicle state, which the beliefs do not have yet. Updates Entry::passed, Entry::watched and
  /// Entry::viewed of the perceptions under way. Cost: a hundred points or so of each zone.
  void see(const world::VehicleState& state, MissionTime now);

 private:
  void watch(Entry& look, const world::VehicleState& state, MissionTime now) const;

  const Beliefs& beliefs_;
  Book& book_;
  std::optional<MissionTime> seen_;  ///< the last state
};

}  // namespace skein::supervisor
