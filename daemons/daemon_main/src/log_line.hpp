// SPDX-License-Identifier: Apache-2.0
// Lines of a daemon's log for people.
#pragma once

#include <string>

#include "skein/journal/record.hpp"

namespace skein::daemon_main {

/// "[0:09:30] goto 102 running (goal 701)": mission time and the record as a sentence, with its
/// remaining fields in brackets. Complete except for the UAV if that is the writing node. Numbers
/// are rounded to a thousandth.
std::string log_line(const journal::Record& record);

}  // namespace skein::daemon_main
