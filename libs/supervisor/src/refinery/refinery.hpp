// SPDX-License-Identifier: Apache-2.0
// The refiners as planning uses them: with shared airspaces, and durations from simulated flights.
#pragma once

#include <utility>

#include "refinery/meeting_places.hpp"
#include "refinery/outlook.hpp"
#include "refinery/views.hpp"

namespace skein::supervisor {

/// For one vehicle, one world and one origin of plans. Thread rule: one thread at a time.
struct Refinery {
  Refinery(Gazetteer gazetteer, MissionTime origin, std::uint64_t seed,
           refiners::Budget budget = {})
      : air(std::move(gazetteer), origin, seed, std::move(budget)) {}
  Refinery(const Refinery&) = delete;  // its parts know each other
  Refinery& operator=(const Refinery&) = delete;

  TimedAir air;
  Ways ways{air};
  Views views{air};
  MeetingPlaces meetings{air, views};
  Patrols patrols{air, ways};
  Sweeps sweeps{air, ways};
  Outlook outlook{air, ways, patrols, sweeps};
};

}  // namespace skein::supervisor
