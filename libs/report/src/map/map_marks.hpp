// SPDX-License-Identifier: Apache-2.0
// Marks of the map: places, fires, alarms, view points, landings, times along the tracks.
#pragma once

#include "page/views.hpp"

namespace skein::report {

/// The marks and their labels; a label without a free place is left to the mark's tool tip.
void write_map_marks(Markup& out, const Run& run, const MapFrame& frame);

/// The object that an alarm is about: the nearest that was active when the alarm was raised.
struct NearestObject {
  std::string name;
  Position position;
  double metres = 0.0;  ///< from the alarm, horizontally
};
std::optional<NearestObject> nearest_object(const Chronology& story, const AlarmStory& alarm);

}  // namespace skein::report
