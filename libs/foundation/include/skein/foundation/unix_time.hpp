// SPDX-License-Identifier: Apache-2.0
// Mission time as Unix time and as UTC text.
#pragma once

#include <cstdint>
#include <string>

#include "skein/foundation/time.hpp"

namespace skein {

/// Parses "2005-05-19T09:00:00Z" [ns since 1970]; 0 for texts of another form, and for instants
/// after 2262.
std::uint64_t epoch_of(const std::string& iso);

/// The instant `at` of a mission whose epoch is `epoch` [ns since 1970], as [ns since 1970]; not
/// below 0.
std::uint64_t unix_time(std::uint64_t epoch, MissionTime at);

/// "2005-05-19T09:00:01.250Z": truncated to milliseconds, which are left out if they are 0.
/// Precondition: before the year 2262.
std::string utc_text(std::uint64_t nanoseconds);

}  // namespace skein
