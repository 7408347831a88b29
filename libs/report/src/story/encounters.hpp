// SPDX-License-Identifier: Apache-2.0
// Synchronisations and temporal messages between vehicles, for the figures.
#pragma once

#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// A synchronisation of two UAVs.
struct Encounter {
  std::string id;
  std::size_t one = 0, other = 0;             ///< indices into Chronology::uavs
  double one_through = 0, other_through = 0;  ///< [s] when each had sent and received the last sync
  /// When both had passed the synchronisation [s].
  double t() const { return one_through > other_through ? one_through : other_through; }
};
/// In time order.
std::vector<Encounter> encounters_of(const Chronology& story);

/// A frontier of a UAV's plan that it sent to others, with all that received it within one second
/// of the first reception.
struct TemporalMessage {
  double t = 0;  ///< first reception [s]
  std::size_t sender = 0;
  std::vector<std::size_t> heard_by;
};
/// In time order.
std::vector<TemporalMessage> temporal_messages_of(const Journal& journal, const Chronology& story);

/// The colour of a row of the figures: twelve distinct ones, repeated from the thirteenth row on.
const char* figure_colour(std::size_t row);

}  // namespace skein::report
