// SPDX-License-Identifier: Apache-2.0
// What vehicles told each other, for the figures.
#pragma once

#include <string>
#include <vector>

#include "story/chronology.hpp"

namespace skein::report {

/// Two who synchronised.
struct Encounter {
  std::string id;
  std::size_t one = 0, other = 0;             ///< indices into Chronology::uavs
  double one_through = 0, other_through = 0;  ///< when each was there and had heard the other
  double t() const { return one_through > other_through ? one_through : other_through; }
};
/// By time.
std::vector<Encounter> encounters_of(const Chronology& story);

/// A frontier of one's plan, and who heard it within a second of the first.
struct TemporalMessage {
  double t = 0;  ///< when it was first heard
  std::size_t sender = 0;
  std::vector<std::size_t> heard_by;
};
/// By time.
std::vector<TemporalMessage> temporal_messages_of(const Journal& journal, const Chronology& story);

/// Of the rows of the figures: twelve that differ, then again from the first.
const char* figure_colour(std::size_t row);

}  // namespace skein::report
