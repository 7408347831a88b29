// SPDX-License-Identifier: Apache-2.0
// Instants of a run as the rest of the world counts them.
#pragma once

#include <cstdint>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein {

/// Of "2005-05-19T09:00:00Z" [ns since 1970]; 0 of anything else, and of what lies after 2262.
std::uint64_t epoch_of(const std::string& iso);

/// [ns since 1970]; nothing lies before it.
std::uint64_t unix_time(std::uint64_t epoch, MissionTime at);

/// "2005-05-19T09:00:01.250Z", with thousandths where there are some; what is finer is cut off.
/// Precondition: before the year 2262.
std::string utc_text(std::uint64_t nanoseconds);

}  // namespace skein
