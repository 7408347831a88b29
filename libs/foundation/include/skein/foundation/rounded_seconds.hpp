// SPDX-License-Identifier: Apache-2.0
// Rounded times as text for people.
#pragma once

#include <string>

#include "skein/foundation/time.hpp"

namespace skein {

/// "12.3 s": rounded to a tenth, without trailing zeros; "for ever" for max().
std::string in_seconds(MissionTime t);
std::string in_seconds(Duration d);

}  // namespace skein
