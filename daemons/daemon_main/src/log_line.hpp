// SPDX-License-Identifier: Apache-2.0
// Lines of a daemon's log for people.
#pragma once

#include <string>

#include "skein/journal/record.hpp"

namespace skein::daemon_main {

/// "[0:09:30] goto 102 running (goal 701)": mission time and what a record says, in words; what its
/// sentence has no place for follows in brackets. Nothing of the record is left out but the UAV
/// when it is the node that writes. Numbers are rounded to a thousandth.
std::string log_line(const journal::Record& record);

}  // namespace skein::daemon_main
