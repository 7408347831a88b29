// SPDX-License-Identifier: Apache-2.0
// One reader for each format; read_text() chooses. What they give counts only if nothing was wrong.
#pragma once

#include <string_view>

#include "findings.hpp"
#include "skein/mission_files/contents.hpp"

namespace skein::mission_files {

void read_plan(std::string_view text, Contents& contents, Findings& findings);
void read_waypoints(std::string_view text, Contents& contents, Findings& findings);
void read_kml(std::string_view text, Contents& contents, Findings& findings);

/// Says what is wrong with a place on Earth; true when nothing is.
bool check(const LatLon& at, const Mark& mark, Findings& findings);

}  // namespace skein::mission_files
